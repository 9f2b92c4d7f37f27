"""A release of a few points, made through the library alone.

python small_release.py FOLDER      in the root of the repository: what the tests compare
"""

import dataclasses
import sys
from pathlib import Path

import chenhorng
import thirdbody as tb
from chenhorng.archive.citation import Release, software_versions
from chenhorng.archive.staging import pack, stage
from chenhorng.scenes import scene_dataset
from chenhorng.tables import DRAWN_POINTS, TABLES, write_csv
from thirdbody.netcdf import write_dataset

# as each page of the archive begins
SHEET = Path(chenhorng.__file__).with_name("sheets.html")
PAGE_HEAD = SHEET.read_text(encoding="utf-8").partition("<meta name=")[0]
KEYS = ("viscosity_cSt", "particle_diameter_nm", "roughness_nm", "particle_density_per_m2")
SCENES = {
    # dry, with and without particles
    "fig03": [([0], [0, 300, 700], [100], [1.0e11])],
    # from boundary to full film, and combinations that are not shown
    "fig04": [([0, 1, 70, 120], [500], [300], [1.0e11]), ([90], [0], [100], [1.0e11])],
    # more particles than there is room for
    "fig07": [([0, 90], [1000], [300], [1.0e11, 2.0e11, 8.0e13])],
}
CONFIG = {
    "rtol": 1e-9,
    "load_axis": {"load_N": [0.04, 80.0], "count": 7},
    "scenes": {
        name: {
            "title": f"A few points of {name}",
            "curves": [dict(zip(KEYS, group, strict=True)) for group in groups],
        }
        for name, groups in SCENES.items()
    },
}
SCRIPT = "workflow/scripts/solve_scene.py"
SOURCES = ("Snakefile", "pyproject.toml", "CITATION.cff", "config/inputs.yaml", SCRIPT)
PICTURES = {"svg": b"<svg/>\n", "pdf": b"%PDF-1.4\n", "png": b"\x89PNG\r\n\x1a\n"}


def solved(name, parameters):
    """The dataset of one of ``SCENES``."""
    scene = CONFIG["scenes"][name] | {"load_axis": CONFIG["load_axis"]}
    return scene_dataset(scene, parameters)


def make_products(folder):
    """Datasets of ``SCENES`` in ``folder``, a table and a figure; their paths."""
    parameters = tb.load_parameters().best
    products = []
    for kind in ("datasets", "tables", "figures"):
        (folder / kind).mkdir(parents=True)
    for name in SCENES:
        path = folder / "datasets" / f"{name}.nc"
        write_dataset(solved(name, parameters), path)
        products.append(path)
    columns = TABLES["tpca_windows"]
    row = {"roughness_m": 3e-7, "particle_density_per_m2": 1e11, "end": "low"}
    row |= {"diameter_over_roughness": 0.8, "error": 1e-6}
    products.append(folder / "tables" / "tpca_windows.csv")
    write_csv(products[-1], [row], columns)
    heading = ",".join(column.name for column in DRAWN_POINTS)
    drawn = f"{heading}\nA,90 cSt,load,1e-5,separation,2e-7\n"
    for kind, content in {**PICTURES, "csv": drawn.encode()}.items():
        products.append(folder / "figures" / f"fig03.{kind}")
        products[-1].write_bytes(content)
    pages = {"index.html": "figures/fig03.svg", "tables/tpca_windows.html": "../index.html"}
    for name, link in pages.items():
        products.append(folder / name)
        products[-1].write_text(
            f'{PAGE_HEAD}<p><a href="{link}">a page</a></p>\n', encoding="utf-8"
        )
    return products


def this_release(root="."):
    """This release; without git, a date and a commit stand in for those that nobody knows."""
    release = Release.of(Path(root, "pyproject.toml"), Path(root, "CITATION.cff"))
    citation = {"date-released": "2024-01-01", "commit": 40 * "0"} | release.citation
    return dataclasses.replace(release, date=citation["date-released"], citation=citation)


def make_release(folder):
    """The folder of a release and its archive file below ``folder``; the path of the former."""
    release = this_release()
    products = make_products(folder / "results")
    parameters = dataclasses.asdict(tb.load_parameters().best)
    settings = {"config": CONFIG, "parameters": parameters}
    software = software_versions("pyproject.toml")
    programs = sorted(map(str, Path("verification").glob("*.py")))
    place = folder / release.full_name
    stage(place, products, [*SOURCES, *programs], settings, software, release)
    pack(place, folder / f"{release.full_name}.zip")
    return place


if __name__ == "__main__":
    make_release(Path(sys.argv[1]))
