"""datapackage.json (Frictionless): products with sizes and checksums, tables with their columns.

The package ``frictionless`` is not used for writing: it installs 38 more packages and infers column
types, which are known here.  Tests validate the result with it.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from thirdbody.data.files import digest
from thirdbody.data.tables import DRAWN_POINTS, TABLES
from thirdbody.release.citation import Release
from thirdbody.release.files import files_in, media_type
from thirdbody.release.texts import render_json

WIDE = re.compile(r"[A-Z]: \w+ \[.+\]")  # columns of the wide table of a figure


def data_package(data: Path, kinds: Iterable[str], release: Release) -> dict[str, Any]:
    """Content of ``datapackage.json`` for the folders ``kinds`` of products in ``data``.

    Raises as ``table_schema``.  See https://datapackage.org/standard/data-package.
    """
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
        "hash": f"sha256:{digest(file, 'sha256')}",
    }
    if file.suffix != ".csv":
        return described | {"type": "file"}
    table = {"type": "table", "format": "csv", "encoding": "utf-8", "schema": table_schema(file)}
    return described | table


def table_schema(file: Path) -> dict[str, Any]:
    """Table Schema of a CSV file by its column names, which are self-explanatory in wide tables of
    figures; ``ValueError`` if nothing describes them."""
    with open(file, encoding="utf-8", newline="") as stream:
        header = next(csv.reader(stream), [])
    for columns in (DRAWN_POINTS, *TABLES.values()):
        if header == [column.name for column in columns]:
            fields = [
                {"name": column.name, "type": column.kind, "description": column.description}
                | ({"unit": column.unit} if column.unit else {})
                for column in columns
            ]
            return {"fields": fields, "missingValues": [""]}
    if all(WIDE.match(name) for name in header):
        fields = [{"name": name, "type": "number"} for name in header]
        return {"fields": fields, "missingValues": [""]}
    raise ValueError(f"{file.name}: nothing describes the columns {header}")
