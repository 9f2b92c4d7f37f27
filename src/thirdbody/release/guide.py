"""README.md of an archive, for people: written from what the archive holds."""

from __future__ import annotations

import json
from pathlib import Path

from thirdbody.data.netcdf import read_dataset
from thirdbody.data.tables import DRAWN_POINTS
from thirdbody.model.regimes import STATUS_MEANINGS, WITHOUT_VALUES
from thirdbody.release.bag import files_in
from thirdbody.release.citation import DATA_LICENCE, Release
from thirdbody.release.datapackage import table_schema

# Unit and meaning of each entry of ``model_parameters``, the attribute of datasets.
MODEL = {
    "E_ss": ("Pa", "composite elastic modulus of the two surfaces"),
    "E_sa": ("Pa", "composite elastic modulus of a particle and a surface"),
    "H_s1": ("Pa", "hardness of surface 1"),
    "H_s2": ("Pa", "hardness of surface 2"),
    "k": ("1", "mean pressure at first yield of a summit over H_s2"),
    "omega_ratio": ("1", "interference of full plasticity over that of first yield"),
    "R_x": ("m", "radius of the ball"),
    "G": ("1", "material parameter of the film formula"),
    "V": ("1", "hardness parameter of the film formula"),
    "kappa": ("1", "ellipticity of the contact"),
    "U_per_viscosity": ("s m-2", "speed parameter over kinematic viscosity"),
    "A_n": ("m2", "apparent contact area"),
    "eta_s": ("m-2", "summits per area"),
    "R": ("m", "radius of the summits"),
    "sigma_s": ("m", "standard deviation of the summits' heights"),
    "y_s": ("m", "height of the summits' plane over the mean plane"),
    "phi_a": ("", "reading of the size distribution: uncentred, centred, gap_convolved"),
    "mean_ratio": ("1", "mean of the size distribution over x_a"),
    "sigma_a_ratio": ("1", "spread of the size distribution over x_a"),
    "gap_ratio": ("1", "spread of the gap over sigma, in the reading gap_convolved"),
    "truncation": ("1", "largest particle: mean + truncation times spread"),
    "participation": ("1", "share of the particles that carry load"),
    "h_e_ratio": ("1", "elastic depth of a particle over x_a"),
    "particle_plane": ("", "plane from which particles meet the separation: surface or summit"),
    "elastic_limits": ("", "sizes of elastic particles: below d (printed) or above it (physical)"),
    "coverage_limits": ("", "particles that cover summits: all (printed) or contacting ones"),
    "film_load": ("", "load in the film formula: that of the fluid, or the total"),
}


def guide(data: Path, kinds: dict[str, str], software: dict[str, str], release: Release) -> str:
    """Write the text of an archive's ``README.md``.

    Parameters
    ----------
    data : Path
        Folder of the archive that holds products, sources and configuration.
    kinds : dict
        Title of each folder of products in ``data``, by name; ``datasets`` must be among them.
    software : dict
        Versions of the packages that made the products, by name.
    release : Release
        What the archive is of.

    Returns
    -------
    str
        Markdown.
    """
    parts = [
        _head(release),
        _checking(),
        _contents(kinds),
        *(_CHAPTERS.get(kind, _files)(data / kind, title) for kind, title in kinds.items()),
        _meaning(data / "datasets"),
        _recomputing(software, release),
        _rights(release),
    ]
    return "\n".join(parts)


def _head(release: Release) -> str:
    return f"""\
# {release.citation["title"]}

Version {release.version}, {release.date}, by {", ".join(release.authors)}.

{release.citation["abstract"]}

The paper: {release.paper_text}

## How to cite

> {release.text}.

`data/CITATION.cff` says the same for programs, `data/codemeta.json` and `data/zenodo.json` in
other vocabularies. Cite the paper as well: the model is its authors' work.
"""


def _checking() -> str:
    return """\
## How to check that the archive is whole

    python verification/verify.py

needs Python 3.11 or newer with numpy, scipy and netCDF4; nothing of this project is installed or
imported. It compares every file with its SHA-256 and SHA-512 sums, looks for missing and extra
files, evaluates the equations of the paper at every point of every dataset and solves some points
again from `model_parameters` alone. It prints one line; the exit code is 0 if all is whole.

The folder is a BagIt 1.0 bag, so `sha256sum --check --quiet manifest-sha256.txt tagmanifest-sha256.txt`
checks the sums without Python. `verification/content_hash.py` gives the sums in `data/datasets/content-sha256.json`:
they depend on what a dataset says, not on the library that wrote it, and its first lines say how
they are taken. `verification/plain_model.py` is the model in plain code, one integral and one root at a time.
"""


def _contents(kinds: dict[str, str]) -> str:
    rows = [f"| `data/{kind}/` | {title} |" for kind, title in kinds.items()]
    return "\n".join(
        [
            "## Contents",
            "",
            "| where | what |",
            "|---|---|",
            *rows,
            "| `data/configuration/` | `config.json`: the configuration of the run; "
            "`parameters.json`: every input of the model, SI |",
            "| `data/source/` | library, workflow, tests, locked dependencies and configuration "
            "files, among them the inputs of the model with their sources and, in "
            "`config/calibrated/`, their ensembles |",
            "| `data/datapackage.json` | Frictionless description of all products |",
            "| `data/ro-crate-metadata.json` | RO-Crate: which rule made what from what |",
            "",
        ]
    )


def _datasets(folder: Path, title: str) -> str:
    lines = [
        f"### `data/datasets/`: {title}",
        "",
        "NetCDF-4, conventions CF-1.11 and ACDD-1.3. Combinations of the five dimensions that a",
        "figure does not show hold `_FillValue`, and flags say `not_shown`. Each point has a",
        "`solution_status`, which is among",
        "",
        *(f"- `{status}`: {meaning}" for status, meaning in STATUS_MEANINGS.items()),
        "",
        f"Points that are {' or '.join(WITHOUT_VALUES)} hold nan, and regime and mode say",
        "`without_values`; all others have values.",
        "",
        "| file | what | shape | points | status |",
        "|---|---|---|---|---|",
    ]
    for name in files_in(folder, folder):
        if name.endswith(".nc"):
            lines.append(_dataset_row(name, read_dataset(folder / name)))
    return "\n".join([*lines, ""])


def _dataset_row(name: str, dataset) -> str:
    status = dataset["solution_status"]
    counts = {name: int((status == code).sum()) for code, name in enumerate(STATUS_MEANINGS)}
    told = ", ".join(f"{count} {meaning}" for meaning, count in counts.items() if count)
    shape = " x ".join(str(dataset.sizes[dimension]) for dimension in status.dims)
    return f"| `{name}` | {dataset.attrs['title']} | {shape} | {sum(counts.values())} | {told} |"


def _tables(folder: Path, title: str) -> str:
    lines = [f"### `data/{folder.name}/`: {title}", ""]
    for name in files_in(folder, folder):
        schema = table_schema(folder / name)
        if schema is not None:
            lines += [f"`{name}`:", ""]
            lines += [_column(field) for field in schema["fields"]]
            lines.append("")
    lines.append("Files of the same name with other endings hold the same for other readers.\n")
    return "\n".join(lines)


def _column(field: dict) -> str:
    unit = f" [{field['unit']}]" if "unit" in field else ""
    return f"- `{field['name']}`: {field['description']}{unit}"


def _figures(folder: Path, title: str) -> str:
    names = [Path(name) for name in files_in(folder, folder)]
    stems = ", ".join(f"`{stem}`" for stem in sorted({name.stem for name in names}))
    endings = ", ".join(f"`{ending}`" for ending in sorted({name.suffix for name in names}))
    columns = [f"- `{column.name}`: {column.description}" for column in DRAWN_POINTS]
    head = (
        f"### `data/{folder.name}/`: {title}\n\n{stems}, each as {endings}. The CSV files hold:\n"
    )
    return "\n".join([head, *columns, ""])


def _files(folder: Path, title: str) -> str:
    names = ", ".join(f"`{name}`" for name in files_in(folder, folder))
    return f"### `data/{folder.name}/`: {title}\n\n{names}\n"


def _explorer(folder: Path, title: str) -> str:
    return (
        f"### `data/{folder.name}/`: {title}\n\nOpen `data/{folder.name}/index.html` in any browser: it "
        "needs no server and no network. Its sliders change every input of the model.\n"
    )


_CHAPTERS = {
    "datasets": _datasets,
    "tables": _tables,
    "figures": _figures,
    "claims": _tables,
    "explorer": _explorer,
}


def _meaning(folder: Path) -> str:
    """Tables of coordinates, variables and inputs with units, as the first dataset has them."""
    first = next(name for name in files_in(folder, folder) if name.endswith(".nc"))
    dataset = read_dataset(folder / first)
    variables = [
        f"| `{name}` | {attrs['symbol']} | {attrs['units']} | {attrs['long_name']} "
        f"| {attrs.get('equation', '')} |"
        for name, attrs in ((name, dataset[name].attrs) for name in dataset.variables)
    ]
    inputs = [
        f"| `{name}` | {MODEL[name][0]} | {MODEL[name][1]} |"
        for name in json.loads(dataset.attrs["model_parameters"])
    ]
    return "\n".join(
        [
            "## Quantities",
            "",
            "| name | symbol | unit | meaning | equation of the paper |",
            "|---|---|---|---|---|",
            *variables,
            "",
            "Each dataset's attribute `model_parameters` is a JSON object of every number and reading",
            "that its values depend on; `eta_s`, `R`, `sigma_s` and `y_s` are lists along `roughness`.",
            "Where each comes from is in `data/source/config/inputs.yaml` and",
            "`data/source/docs/calibration.md`.",
            "",
            "| name | unit | meaning |",
            "|---|---|---|",
            *inputs,
            "",
        ]
    )


def _recomputing(software: dict[str, str], release: Release) -> str:
    versions = ", ".join(f"{name} {number}" for name, number in software.items())
    return f"""\
## How to recompute

One value: read `model_parameters` of its dataset and solve Eqs. 1-10 of the paper, as
`verification/plain_model.py` does. Everything, in a copy, so that the archive stays as it is:

    cp -r data/source {release.name} && cp data/configuration/config.json {release.name}/used.json
    cd {release.name}
    make reproduce

installs the locked dependencies and runs the workflow on its default configuration;
`.venv/bin/snakemake -c2 release --configfile used.json` makes this archive again. The same software
gives the same bytes: {versions}. Other versions may write other bytes of the same content.
`data/source/codecheck.yml` lists what an independent checker compares. When, where and by whom the
archive was made is recorded in `provenance.json`, beside the archive and not in it.
"""


def _rights(release: Release) -> str:
    return f"""\
## Licences

Everything in `data/` is under {DATA_LICENCE} (`data/LICENSE-DATA`), but for the source code: that in
`data/source/`, its `config/` aside, and that in `verification/` are under
{release.citation["license"]} (`data/LICENSE`).
"""
