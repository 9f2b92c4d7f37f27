"""README.md of an archive, for people: written from what the archive holds."""

from __future__ import annotations

import re
from importlib.resources import files
from pathlib import Path
from typing import Any

import netCDF4
import numpy as np
from jinja2 import Environment, StrictUndefined

from thirdbody.data.tables import DRAWN_POINTS
from thirdbody.model.regimes import STATUS_MEANINGS, WITHOUT_VALUES
from thirdbody.release.citation import DATA_LICENCE, Release
from thirdbody.release.datapackage import table_schema
from thirdbody.release.files import files_in

TEMPLATE = "README.md.jinja"


def guide(data: Path, kinds: dict[str, str], software: dict[str, str], release: Release) -> str:
    """Text of an archive's ``README.md``.

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
        Markdown; texts that the configuration gives are escaped.
    """
    environment = Environment(
        undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True, keep_trailing_newline=True
    )
    environment.filters["text"] = markdown_text
    template = environment.from_string(
        files(__package__).joinpath(TEMPLATE).read_text(encoding="utf-8")
    )
    paths = sorted(data.glob("datasets/*.nc"))
    return template.render(
        release=release,
        kinds=kinds,
        names={kind: files_in(data / kind, data / kind) for kind in kinds},
        datasets=[describe_dataset(path) for path in paths],
        quantities=describe_variables(paths[0]),
        tables={
            kind: {path.name: table_schema(path) for path in sorted((data / kind).glob("*.csv"))}
            for kind in ("tables", "claims")
        },
        drawn_points=DRAWN_POINTS,
        status_meanings=STATUS_MEANINGS,
        without_values=WITHOUT_VALUES,
        software=software,
        data_licence=DATA_LICENCE,
    )


def markdown_text(text: str) -> str:
    r"""``text`` as one line of Markdown in which nothing is markup or HTML.

    Examples
    --------
    >>> markdown_text("a|b <script> [x](y)")
    'a\\|b &lt;script&gt; \\[x\\]\\(y\\)'
    """
    line = " ".join(str(text).split())
    line = line.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    return re.sub(r"([\\`*_{}\[\]()#+!|~$])", r"\\\1", line)


def describe_dataset(path: Path) -> dict[str, Any]:
    """Name, title and shape of a dataset, and its numbers of points by their status."""
    with netCDF4.Dataset(path) as dataset:
        dataset.set_auto_maskandscale(False)
        status = dataset["solution_status"]
        names = dict(zip(status.flag_values.tolist(), status.flag_meanings.split(), strict=True))
        codes, counts = np.unique(status[:], return_counts=True)
        points = {names[code]: int(n) for code, n in zip(codes.tolist(), counts, strict=True)}
        points.pop("not_shown", None)
        shape = " x ".join(map(str, status.shape))
        return {"name": path.name, "title": dataset.title, "shape": shape, "points": points}


def describe_variables(path: Path) -> dict[str, dict[str, Any]]:
    """Attributes of each variable of a dataset, by name."""
    with netCDF4.Dataset(path) as dataset:
        return {name: vars(variable) for name, variable in dataset.variables.items()}
