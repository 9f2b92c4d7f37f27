"""Tidy tables: ``columns.csv`` describes their columns; from it come CSV, Table Schema and LaTeX."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterable, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from os import PathLike
from pathlib import Path


@dataclass(frozen=True)
class Column:
    """A column of a table.

    Attributes
    ----------
    name : str
        Heading; it ends with the SI unit where there is one.
    kind : str
        Type of the Table Schema: ``number`` or ``string``.
    unit : str
        SI unit, ``1`` of a pure number, empty of a text.
    description : str
        What stands in it, for the Table Schema.
    """

    name: str
    kind: str
    unit: str
    description: str

    def parse(self, texts: Iterable[str]) -> list[float | str | None]:
        """The values that fields of a CSV file stand for; None where one is empty."""
        value = float if self.kind == "number" else str
        return [None if text == "" else value(text) for text in texts]

    def format(self, value: float | str | None, digits: int) -> str:
        """Text of ``value``, a number with so many significant digits; empty for None."""
        if value is None:
            return ""
        return f"{value:.{digits}g}" if self.kind == "number" else str(value)


def _described_tables() -> dict[str, tuple[Column, ...]]:
    tables: dict[str, list[Column]] = {}
    with open(Path(__file__).with_name("columns.csv"), encoding="utf-8", newline="") as stream:
        for row in csv.DictReader(stream):
            tables.setdefault(row.pop("table"), []).append(Column(**row))
    return {name: tuple(columns) for name, columns in tables.items()}


TABLES = _described_tables()
DRAWN_POINTS = TABLES.pop("drawn_points")  # of the CSV file beside each figure


def write_csv(path: str | PathLike, rows: Iterable[Mapping], columns: Sequence[Column]) -> None:
    """Write a table as CSV, numbers with ten significant digits: of each row, a value or None for the
    name of each column."""
    with open(path, "w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow([column.name for column in columns])
        for row in rows:
            writer.writerow([column.format(row[column.name], 10) for column in columns])


def read_csv(path: str | PathLike, columns: Sequence[Column]) -> list[dict]:
    """Rows of a table of ``write_csv``; ``OSError`` in one line names a file that is damaged or has
    other columns."""
    names = [column.name for column in columns]
    with _naming(path):
        fields = zip(*read_texts(path, columns), strict=True)
        values = [column.parse(each) for column, each in zip(columns, fields, strict=False)]
        return [dict(zip(names, row, strict=True)) for row in zip(*values, strict=True)]


def read_texts(path: str | PathLike, columns: Sequence[Column]) -> list[list[str]]:
    """The fields of each row as they stand in the file; ``OSError`` as of ``read_csv``."""
    names = [column.name for column in columns]
    with _naming(path), open(path, encoding="utf-8", newline="") as stream:
        header, *rows = csv.reader(stream)
        if header != names:
            raise ValueError(f"its columns are {header}")
        if any(len(row) != len(names) for row in rows):
            raise ValueError("a row has other columns")
        return rows


@contextmanager
def _naming(path):
    """Context in which what is wrong with a file becomes one line that names it."""
    try:
        yield
    except (ValueError, csv.Error) as error:
        reason = " ".join(str(error).split())
        raise OSError(
            f"{path} cannot be read ({reason}); remake it: snakemake -c2 --force {path}"
        ) from None


def write_schema(path: str | PathLike, columns: Sequence[Column]) -> None:
    """Write the Table Schema (Frictionless) of ``columns``, as JSON."""
    fields = [
        {
            "name": column.name,
            "type": column.kind,
            "description": column.description + (f" [{column.unit}]" if column.unit else ""),
        }
        for column in columns
    ]
    with open(path, "w", encoding="utf-8") as stream:
        json.dump({"fields": fields, "missingValues": [""]}, stream, indent=2)
        stream.write("\n")


def write_latex(path: str | PathLike, rows: Iterable[Mapping], columns: Sequence[Column]) -> None:
    """Write a table for LaTeX with the package booktabs, numbers with six significant digits."""
    from tabulate import tabulate

    cells = [[column.format(row[column.name], 6) for column in columns] for row in rows]
    headings = [column.name for column in columns]
    text = tabulate(cells, headings, tablefmt="latex_booktabs", disable_numparse=True)
    Path(path).write_text(text + "\n", encoding="utf-8")
