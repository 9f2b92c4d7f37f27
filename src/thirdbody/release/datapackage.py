"""datapackage.json (Frictionless): products with sizes and sums, tables with their columns.

The package ``frictionless`` is not used to write: it brings 38 more packages and infers types of
columns, which are known here.  Tests validate the result with it.
"""

from __future__ import annotations

import csv
import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from thirdbody.data.sums import digest
from thirdbody.data.tables import DRAWN_POINTS, TABLES
from thirdbody.release.citation import DATA_LICENCE, SPDX, Release
from thirdbody.release.files import files_in, media_type


def data_package(data: Path, kinds: Iterable[str], release: Release) -> dict[str, Any]:
    """Content of ``datapackage.json`` for the folders ``kinds`` of products in ``data``.

    Raises
    ------
    ValueError
        If nothing describes the columns of a table.

    References
    ----------
    https://datapackage.org/standard/data-package
    """
    cited = release.citation
    names = [name for kind in sorted(kinds) for name in files_in(data / kind, data)]
    return {
        "name": release.name,
        "title": cited["title"],
        "description": cited["abstract"],
        "version": release.version,
        "created": f"{release.date}T00:00:00Z",
        "licenses": [{"name": DATA_LICENCE, "path": f"{SPDX}{DATA_LICENCE}.html"}],
        "sources": [{"title": release.paper_text, "path": release.paper_url}],
        "contributors": [{"title": name, "role": "author"} for name in release.authors],
        "keywords": cited["keywords"],
        "resources": [_resource(data, name) for name in names],
    }


def _resource(data: Path, path: str) -> dict:
    file = data / path
    described = {
        "name": path.lower().replace("/", "-").replace(".", "-").replace("_", "-"),
        "path": path,
        "mediatype": media_type(path),
        "bytes": file.stat().st_size,
        "hash": f"sha256:{digest(file, 'sha256')}",
    }
    if file.suffix != ".csv":
        return described | {"type": "file"}
    table = {"type": "table", "format": "csv", "encoding": "utf-8", "schema": table_schema(file)}
    return described | table


def table_schema(file: Path) -> dict[str, Any]:
    """Table Schema of a CSV file: the JSON file beside it, or by the names of its columns.

    Raises
    ------
    ValueError
        If nothing describes the columns.
    """
    beside = file.with_suffix(".json")
    schema = json.loads(beside.read_text(encoding="utf-8")) if beside.is_file() else {}
    if "fields" in schema:  # claims.json holds the statements themselves
        return schema
    with open(file, encoding="utf-8", newline="") as stream:
        header = next(csv.reader(stream), [])
    for columns in (DRAWN_POINTS, *TABLES.values()):
        if header == [column.name for column in columns]:
            return {"fields": [_field(column) for column in columns], "missingValues": [""]}
    raise ValueError(f"{file.name}: nothing describes the columns {header}")


def _field(column) -> dict:
    field = {"name": column.name, "type": column.kind, "description": column.description}
    return field | ({"unit": column.unit} if column.unit else {})
