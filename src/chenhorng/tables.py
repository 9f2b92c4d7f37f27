"""Tidy tables as CSV and Table Schema; ``tables.csv`` describes their columns."""

import csv
from collections.abc import Iterable, Mapping, Sequence
from itertools import groupby
from operator import attrgetter
from os import PathLike
from pathlib import Path
from typing import Any, NamedTuple

from thirdbody.files import unreadable
from thirdbody.variables import CONDITION_AXES


class Column(NamedTuple):
    """A column of a table, as ``tables.csv`` describes it.

    ``name`` ends with the SI unit if the column has one.  ``kind`` is the type of the Table Schema,
    ``number`` or ``string``.  ``unit`` is the SI unit, ``1`` for a pure number and empty for text.
    An empty description in the file is that of a condition.
    ``heading`` is the heading in the sheet of the ``table``; an empty heading stands for the name.
    """

    name: str
    kind: str
    unit: str
    description: str
    table: str = ""
    heading: str = ""

    def parse(self, text: str) -> float | str | None:
        """The value of a field of a CSV file; None for an empty field."""
        if text == "":
            return None
        return float(text) if self.kind == "number" else text


# descriptions of columns that are conditions
OF_CONDITIONS = {axis.column: f"{axis.symbol}: {axis.label}" for axis in CONDITION_AXES}
with open(Path(__file__).with_suffix(".csv"), encoding="utf-8", newline="") as file:
    COLUMNS = [
        Column(**row | {"description": row["description"] or OF_CONDITIONS.get(row["name"], "")})
        for row in csv.DictReader(file, restval="")
    ]
TABLES = {table: list(columns) for table, columns in groupby(COLUMNS, attrgetter("table"))}
DRAWN_POINTS = TABLES.pop("drawn_points")  # the columns of the CSV file beside each figure


def write_csv(path: str | PathLike, rows: Iterable[Mapping], columns: Sequence[Column]) -> None:
    """Write a table as CSV, numbers with ten significant digits.  Each row has a value or None by
    the name of each column."""
    formats = {column.name: ".10g" if column.kind == "number" else "" for column in columns}
    with open(path, "w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(formats)
        for row in rows:
            fields = ((row[name], form) for name, form in formats.items())
            writer.writerow("" if value is None else format(value, form) for value, form in fields)


def read_csv(path: str | PathLike, columns: Sequence[Column]) -> list[dict]:
    """Rows of a table that ``write_csv`` wrote.  ``OSError``, in one line, names a file that is
    damaged or has other columns."""
    try:
        with open(path, encoding="utf-8", newline="") as stream:
            header, *rows = csv.reader(stream)
        parsed = [
            {column.name: column.parse(text) for column, text in zip(columns, row, strict=True)}
            for row in rows
        ]
    except (ValueError, csv.Error) as error:
        raise unreadable(path, error) from None
    if header != [column.name for column in columns]:
        raise unreadable(path, f"its columns are {header}")
    return parsed


def table_schema(columns: Sequence[Column]) -> dict[str, Any]:
    """The Table Schema of ``columns`` (https://datapackage.org/standard/table-schema)."""
    fields = [
        {
            "name": column.name,
            "type": column.kind,
            "description": column.description + (f" [{column.unit}]" if column.unit else ""),
        }
        for column in columns
    ]
    return {"fields": fields, "missingValues": [""]}
