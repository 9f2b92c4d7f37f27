"""Descriptions of an archive: schemas of its tables, and values for its ``README.md``."""

import csv
import re
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from chenhorng.archive.files import files_in
from chenhorng.tables import DRAWN_POINTS, TABLES, table_schema
from thirdbody.core.regimes import WITHOUT_VALUES
from thirdbody.netcdf import PlainDataset, read_plain
from thirdbody.variables import STATUS, STATUS_MEANINGS

WIDE = re.compile(r"[A-Z]: \w+ \[.+\]")  # columns of the wide table of a figure


def table_schemas(data: Path, folders: Iterable[str]) -> dict[str, Any]:
    """Content of ``table-schemas.json``: the Table Schema of each CSV file in the ``folders`` of
    ``data``, by its path (https://datapackage.org/standard/table-schema).  Raises the errors of
    ``schema_of``."""
    paths = [path for name in sorted(folders) for path in sorted((data / name).rglob("*.csv"))]
    return {path.relative_to(data).as_posix(): schema_of(path) for path in paths}


def schema_of(file: Path) -> dict[str, Any]:
    """Table Schema of a CSV file, from its column names.  The names of wide tables of figures
    explain themselves.  Other columns that nothing describes raise ``ValueError``."""
    with open(file, encoding="utf-8", newline="") as stream:
        header = next(csv.reader(stream), [])
    for columns in (DRAWN_POINTS, *TABLES.values()):
        if header == [column.name for column in columns]:
            return table_schema(columns)
    if all(WIDE.match(name) for name in header):
        fields = [{"name": name, "type": "number"} for name in header]
        return {"fields": fields, "missingValues": [""]}
    raise ValueError(f"{file.name}: nothing describes the columns {header}")


def describe_content(data: Path, titles: dict[str, str]) -> dict[str, Any]:
    """Values for the template of ``README.md``, from the folder ``data`` of an archive.  ``titles``
    has the titles of the folders of products, ``datasets`` among them."""
    datasets = {path.name: read_plain(path) for path in sorted(data.glob("datasets/*.nc"))}
    return {
        "titles": titles,
        "names": {folder: files_in(data / folder, data / folder) for folder in titles},
        "datasets": [_describe_dataset(name, dataset) for name, dataset in datasets.items()],
        "quantities": next(iter(datasets.values())).variables,
        "tables": {
            folder: {path.name: schema_of(path) for path in sorted((data / folder).glob("*.csv"))}
            for folder in ("tables", "claims")
        },
        "drawn_points": DRAWN_POINTS,
        "status_meanings": STATUS_MEANINGS,
        "without_values": WITHOUT_VALUES,
    }


def _describe_dataset(name: str, dataset: PlainDataset) -> dict[str, Any]:
    """Name, title and shape of a dataset, and the number of points with each status."""
    status = dataset[STATUS]
    meanings = status.attrs["flag_meanings"].split()
    flags = zip(status.attrs["flag_values"], meanings, strict=True)
    counts = {meaning: int(np.count_nonzero(status.values == flag)) for flag, meaning in flags}
    points = {meaning: n for meaning, n in counts.items() if n and meaning != "not_shown"}
    shape = " x ".join(map(str, status.values.shape))
    return {"name": name, "title": dataset.attrs["title"], "shape": shape, "points": points}
