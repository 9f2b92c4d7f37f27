"""Tidy tables as CSV and Table Schema; ``tables.csv`` describes their columns."""

import csv
from collections.abc import Iterable, Mapping, Sequence
from itertools import groupby
from operator import attrgetter
from os import PathLike
from pathlib import Path
from typing import Any, NamedTuple

from thirdbody.files import unreadable


class Column(NamedTuple):
    """A column of a table: its name, which ends with the SI unit if there is one; the type of
    the Table Schema, ``number`` or ``string``; the SI unit, ``1`` for a pure number and empty for
    text; its description; the table in ``tables.csv``; and its heading in the sheet of the table,
    empty if that is the name."""

    name: str
    kind: str
    unit: str
    description: str
    table: str = ""
    heading: str = ""

    def parse(self, text: str) -> float | str | None:
        """The value of a field of a CSV file; None if it is empty."""
        if text == "":
            return None
        return float(text) if self.kind == "number" else text


with open(Path(__file__).with_suffix(".csv"), encoding="utf-8", newline="") as file:
    COLUMNS = [Column(**row) for row in csv.DictReader(file, restval="")]
TABLES = {table: list(columns) for table, columns in groupby(COLUMNS, attrgetter("table"))}
DRAWN_POINTS = TABLES.pop("drawn_points")  # of the CSV file beside each figure


def write_csv(path: str | PathLike, rows: Iterable[Mapping], columns: Sequence[Column]) -> None:
    """Write a table as CSV, numbers with ten significant digits; each row has a value or None for
    each column name."""
    formats = {column.name: ".10g" if column.kind == "number" else "" for column in columns}
    with open(path, "w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(formats)
        for row in rows:
            fields = ((row[name], form) for name, form in formats.items())
            writer.writerow("" if value is None else format(value, form) for value, form in fields)


def read_csv(path: str | PathLike, columns: Sequence[Column]) -> list[dict]:
    """Rows of a table of ``write_csv``; raises ``OSError`` in one line for a file that is damaged
    or has other columns."""
    try:
        with open(path, encoding="utf-8", newline="") as stream:
            header, *rows = csv.reader(stream)
        found = [
            {column.name: column.parse(text) for column, text in zip(columns, row, strict=True)}
            for row in rows
        ]
    except (ValueError, csv.Error) as error:
        raise unreadable(path, error) from None
    if header != [column.name for column in columns]:
        raise unreadable(path, f"its columns are {header}")
    return found


def table_schema(columns: Sequence[Column]) -> dict[str, Any]:
    """The Table Schema (Frictionless) of ``columns``."""
    fields = [
        {
            "name": column.name,
            "type": column.kind,
            "description": column.description + (f" [{column.unit}]" if column.unit else ""),
        }
        for column in columns
    ]
    return {"fields": fields, "missingValues": [""]}
