"""datapackage.json (Frictionless): every product with its size and sum, tables with their columns."""

from __future__ import annotations

import csv
import json
from pathlib import Path

from thirdbody.data.tables import TABLES, Column
from thirdbody.release.bag import digest, files_in
from thirdbody.release.citation import DATA_LICENCE, SPDX, Release
from thirdbody.release.media import media_type

# the data that a figure draws; its columns are named by their content, not by a unit
DRAWN_POINTS = (
    Column("panel", "string", "", "letter of the panel"),
    Column("curve", "string", "", "label of the curve"),
    Column("x_name", "string", "", "quantity along x"),
    Column("x", "number", "", "its value, in SI units"),
    Column("y_name", "string", "", "quantity along y"),
    Column("y", "number", "", "its value, in SI units"),
)


def data_package(data: Path, kinds, release: Release) -> dict:
    """Description of the products in the folders ``kinds`` of ``data``."""
    resources = [
        _resource(data, path) for kind in sorted(kinds) for path in files_in(data / kind, data)
    ]
    licence = {"name": DATA_LICENCE, "path": f"{SPDX}{DATA_LICENCE}.html"}
    return {
        "name": release.name,
        "title": release.citation["title"],
        "description": release.citation["abstract"],
        "version": release.version,
        "created": f"{release.date}T00:00:00Z",
        "licenses": [licence],
        "sources": [
            {"title": release.paper_text, "path": f"https://doi.org/{release.paper['doi']}"}
        ],
        "contributors": [{"title": name, "role": "author"} for name in release.authors],
        "keywords": release.citation["keywords"],
        "resources": resources,
    }


def _resource(data: Path, path: str) -> dict:
    """One file; one with columns is a table."""
    file = data / path
    described = {
        "name": path.lower().replace("/", "-").replace(".", "-").replace("_", "-"),
        "path": path,
        "mediatype": media_type(path),
        "bytes": file.stat().st_size,
        "hash": f"sha256:{digest(file, 'sha256')}",
    }
    schema = table_schema(file)
    if schema is None:
        return described | {"type": "file"}
    return described | {"type": "table", "format": "csv", "encoding": "utf-8", "schema": schema}


def table_schema(file: Path) -> dict | None:
    """Table Schema of a CSV file, by its columns or from the file beside it; None for the rest.

    Raises ``ValueError`` for a table whose columns nothing describes.
    """
    if file.suffix != ".csv":
        return None
    beside = file.with_suffix(".json")
    if beside.is_file():
        return json.loads(beside.read_text(encoding="utf-8"))
    with open(file, encoding="utf-8", newline="") as stream:
        header = next(csv.reader(stream), [])
    for columns in (DRAWN_POINTS, *TABLES.values()):
        if header == [column.name for column in columns]:
            return {"fields": [_field(column) for column in columns], "missingValues": [""]}
    raise ValueError(f"{file.name}: nothing describes the columns {header}")


def _field(column: Column) -> dict:
    field = {"name": column.name, "type": column.kind, "description": column.description}
    return field | ({"unit": column.unit} if column.unit else {})
