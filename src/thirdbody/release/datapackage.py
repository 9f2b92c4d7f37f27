"""datapackage.json (Frictionless): products with sizes and sums, tables with their columns."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from thirdbody.data.tables import DRAWN_POINTS, TABLES, Column
from thirdbody.release.bag import digest, files_in
from thirdbody.release.citation import DATA_LICENCE, SPDX, Release
from thirdbody.release.media import media_type


def data_package(data: Path, kinds: Iterable[str], release: Release) -> dict[str, Any]:
    """Describe the products of an archive.

    Parameters
    ----------
    data : Path
        Folder of the archive that holds the folders of products.
    kinds : iterable of str
        Names of the folders of products.
    release : Release
        What the archive is of.

    Returns
    -------
    dict
        Content of ``datapackage.json``.

    Raises
    ------
    ValueError
        If nothing describes the columns of a table.

    References
    ----------
    https://datapackage.org/standard/data-package

    Examples
    --------
    In the root of the repository:

    >>> import tempfile
    >>> release = Release.of("pyproject.toml", "CITATION.cff")
    >>> with tempfile.TemporaryDirectory() as place:
    ...     figures = Path(place, "figures")
    ...     figures.mkdir()
    ...     _ = (figures / "fig03.csv").write_text("panel,curve,x_name,x,y_name,y")
    ...     package = data_package(Path(place), ["figures"], release)
    >>> package["resources"][0]["path"], package["resources"][0]["type"]
    ('figures/fig03.csv', 'table')
    """
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
    """Describe one file, and its columns if it is a table."""
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


def table_schema(file: Path) -> dict[str, Any] | None:
    """Describe the columns of a table.

    Parameters
    ----------
    file : Path
        Any product.

    Returns
    -------
    dict or None
        The Table Schema of a CSV file: that in the JSON file beside it if that holds one, else by
        the names of its columns.  None for other files.

    Raises
    ------
    ValueError
        If nothing describes the columns.
    """
    if file.suffix != ".csv":
        return None
    beside = file.with_suffix(".json")
    schema = json.loads(beside.read_text(encoding="utf-8")) if beside.is_file() else {}
    if "fields" in schema:  # other files of this name hold what the table does, for programs
        return schema
    with open(file, encoding="utf-8", newline="") as stream:
        header = next(csv.reader(stream), [])
    for columns in (DRAWN_POINTS, *TABLES.values()):
        if header == [column.name for column in columns]:
            return {"fields": [_field(column) for column in columns], "missingValues": [""]}
    raise ValueError(f"{file.name}: nothing describes the columns {header}")


def _field(column: Column) -> dict:
    field = {"name": column.name, "type": column.kind, "description": column.description}
    return field | ({"unit": column.unit} if column.unit else {})
