"""Descriptions of the content of an archive: ``datapackage.json``, and values for ``README.md``.

The package ``frictionless`` is not used for writing: it installs 38 more packages and infers column
types, which are known here.  Tests validate the data package with it.
"""

import csv
import re
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from thirdbody.core.regimes import WITHOUT_VALUES
from thirdbody.files import digest
from thirdbody.netcdf import PlainDataset, read_plain
from chenhorng.archive.citation import Release
from chenhorng.archive.files import files_in, media_type, render_json
from chenhorng.tables import DRAWN_POINTS, TABLES, table_schema
from thirdbody.variables import STATUS, STATUS_MEANINGS

WIDE = re.compile(r"[A-Z]: \w+ \[.+\]")  # columns of the wide table of a figure


def data_package(data: Path, kinds: Iterable[str], release: Release) -> dict[str, Any]:
    """Content of ``datapackage.json`` (https://datapackage.org/standard/data-package): the products
    in the folders ``kinds`` of ``data`` with sizes, sums and columns; raises as ``schema_of``."""
    names = [name for kind in sorted(kinds) for name in files_in(data / kind, data)]
    resources = [_resource(data, name) for name in names]
    return render_json("datapackage.json", release=release, resources=resources)


def _resource(data: Path, path: str) -> dict:
    file = data / path
    described = {
        "name": path.lower().replace("/", "-").replace(".", "-").replace("_", "-"),
        "path": path,
        "mediatype": media_type(path),
        "bytes": file.stat().st_size,
        "hash": f"sha256:{digest(file)}",
    }
    if file.suffix != ".csv":
        return described | {"type": "file"}
    table = {"type": "table", "format": "csv", "encoding": "utf-8", "schema": schema_of(file)}
    return described | table


def schema_of(file: Path) -> dict[str, Any]:
    """Table Schema of a CSV file by its column names, which are self-explanatory in wide tables of
    figures; ``ValueError`` if nothing describes them."""
    with open(file, encoding="utf-8", newline="") as stream:
        header = next(csv.reader(stream), [])
    for columns in (DRAWN_POINTS, *TABLES.values()):
        if header == [column.name for column in columns]:
            return table_schema(columns)
    if all(WIDE.match(name) for name in header):
        fields = [{"name": name, "type": "number"} for name in header]
        return {"fields": fields, "missingValues": [""]}
    raise ValueError(f"{file.name}: nothing describes the columns {header}")


def describe_content(data: Path, kinds: dict[str, str]) -> dict[str, Any]:
    """Values for the template of ``README.md``, from the folder ``data`` of an archive; ``kinds``
    has the titles of the folders of products, of which ``datasets`` must be one."""
    datasets = {path.name: read_plain(path) for path in sorted(data.glob("datasets/*.nc"))}
    return {
        "kinds": kinds,
        "names": {kind: files_in(data / kind, data / kind) for kind in kinds},
        "datasets": [_describe_dataset(name, dataset) for name, dataset in datasets.items()],
        "quantities": next(iter(datasets.values())).variables,
        "tables": {
            kind: {path.name: schema_of(path) for path in sorted((data / kind).glob("*.csv"))}
            for kind in ("tables", "claims")
        },
        "drawn_points": DRAWN_POINTS,
        "status_meanings": STATUS_MEANINGS,
        "without_values": WITHOUT_VALUES,
    }


def _describe_dataset(name: str, dataset: PlainDataset) -> dict[str, Any]:
    """Name, title and shape of a dataset, and its numbers of points by their status."""
    status = dataset[STATUS]
    meanings = status.attrs["flag_meanings"].split()
    flags = zip(status.attrs["flag_values"], meanings, strict=True)
    counts = {meaning: int(np.count_nonzero(status.values == flag)) for flag, meaning in flags}
    points = {each: n for each, n in counts.items() if n and each != "not_shown"}
    shape = " x ".join(map(str, status.values.shape))
    return {"name": name, "title": dataset.attrs["title"], "shape": shape, "points": points}
