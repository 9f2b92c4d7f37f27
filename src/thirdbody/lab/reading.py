"""Measurements as instruments and spreadsheets write them: a CSV file, or a table of pandas."""

import csv
import io
import re
from os import PathLike
from pathlib import Path

import numpy as np
import pandas as pd

from thirdbody.conditions import UNIT, numbers_in, registry, unit_text, warn_outside
from thirdbody.lab.estimates import MEASURED
from thirdbody.variables import CONDITIONS, decimal

UNITS = {
    key: unit_text(key) for key in ("load", *(axis.alias for axis in CONDITIONS.values()))
}  # by column
UNITS |= {key: quantity.unit for key, quantity in MEASURED.items()}
USUAL = {key: (*quantity.usual, quantity.unit) for key, quantity in MEASURED.items()}
COLUMNS = {axis.name.replace("_", " "): axis.alias for axis in CONDITIONS.values()}  # by heading
COLUMNS |= {quantity.heading: key for key, quantity in MEASURED.items()}
COLUMNS |= {"normal load": "load_N", "normal force": "load_N"}
COLUMNS |= dict.fromkeys(("cof", "coefficient of friction", "μ"), "friction_coefficient")
OWN = {key: (key, unit) for key, unit in UNITS.items() if key != "load"}
OWN |= {"separation_m": ("separation_nm", "m"), "film_thickness": ("", "1")}  # of a solution
RATIOS = {
    "load_N": "load",
    "film_thickness_nm": "",
    "separation_nm": "",
}  # F_t*; H_c is left out
HEADING = re.compile(rf"(.*?)\s*(?:\[({UNIT})\]|\(({UNIT})\)|/\s*({UNIT}))?\s*\Z", re.DOTALL)
NUMBER = r"[-+]?\d*[.,]?\d*(?:[eE][-+]?\d+)?"
THOUSANDS = r"[-+]?[1-9]\d{0,2},\d{3}"
FIRST_LINES = 100  # in which the headings are


def read_measured(
    measured: str | PathLike | pd.DataFrame, is_measured: bool = True
) -> tuple[pd.DataFrame, list[str]]:
    """The conditions and measured quantities of a file or table, by column and in its unit; and notes.

    Raises ``ValueError`` for a number without a unit, a second column of one quantity, commas that may
    stand between thousands, and, if it ``is_measured``, a table without measured quantities.
    """
    table, notes = (measured, []) if isinstance(measured, pd.DataFrame) else _read_csv(measured)
    numbers, others = {}, []
    for heading, column in table.items():
        key, unit = _key_and_unit(str(heading))
        if not key:
            others.append(str(heading))
            continue
        if key in numbers:
            raise ValueError(f"{heading!r} is a second column of {key}; allowed: one")
        if unit is None:
            raise ValueError(f"{heading!r} has no unit; allowed: as '{heading} [{UNITS[key]}]'")
        column = pd.to_numeric(column) if column.dtype.kind == "O" else column
        quantity = registry().Quantity(numbers_in(str(heading), column, "1"), unit)
        numbers[key] = decimal(quantity.to(registry().Unit(UNITS[key])).magnitude)
        missing = np.isnan(numbers[key]).sum()
        if missing and key in MEASURED:
            notes.append(f"{heading} has no number in {missing} of {len(column)} rows")
    if others:
        notes.append(f"columns left out: {', '.join(others)}")
    if is_measured and not MEASURED.keys() & numbers.keys():
        names = ", ".join(quantity.heading for quantity in MEASURED.values())
        message = "; ".join(["measured has no measured quantity", *notes])
        raise ValueError(f"{message}; allowed: one or more of {names}")
    warn_outside({key: numbers[key] for key in numbers.keys() & USUAL.keys()}, USUAL)
    return pd.DataFrame(numbers, table.index), notes


def _key_and_unit(heading):
    """The column of a heading, empty if it is another one; and its unit, None if it has none."""
    if heading in OWN:
        return OWN[heading]
    name, *units = HEADING.findall(heading)[0]
    key = COLUMNS.get(" ".join(name.replace("_", " ").split()).casefold(), "")
    unit = next((unit for unit in units if unit), None)
    if unit in ("1", "-"):
        return RATIOS.get(key, key), "1"
    return key, "1" if unit is None and UNITS.get(key) == "1" else unit


def _read_csv(path):
    """The cells of a file as texts, below the row that has most of the headings; and notes."""
    content = Path(path).read_bytes()
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = content.decode("cp1252")  # of spreadsheets
    lines = [line for line in text.splitlines() if line.strip() and line[0] != "#"]

    def headings(place):
        above, separator = place
        cells = next(csv.reader([lines[above]], delimiter=separator, skipinitialspace=True))
        return sum(_key_and_unit(cell)[0] != "" for cell in cells)

    places = [(above, sign) for above in range(len(lines[:FIRST_LINES])) for sign in "\t;,"]
    above, separator = max(places, key=headings, default=(0, ","))
    rows = pd.read_csv(
        io.StringIO("\n".join(lines[above:])),
        sep=separator,
        header=None,  # pandas would rename a second column of one name
        dtype=str,
        skipinitialspace=True,
        na_values=["-", "#DIV/0!"],
    ).dropna(how="all")
    cells = rows.iloc[1:].reset_index(drop=True)
    numbers = cells.stack()
    numbers = numbers[numbers.str.fullmatch(NUMBER)]
    commas = numbers[numbers.str.contains(",")]
    if len(commas):
        if commas.str.fullmatch(THOUSANDS).all() or numbers.str.contains(".", regex=False).any():
            message = f"{path} has {commas.iloc[0]!r}, with a comma of decimals or of thousands"
            raise ValueError(f"{message}; allowed: one decimal sign, none between thousands")
        cells = cells.replace(",", ".", regex=True)
    notes = [f"lines above the headings left out: {above}"] if above else []
    return cells.set_axis(rows.iloc[0].fillna(""), axis=1), notes
