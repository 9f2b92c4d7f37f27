"""Measurements as instruments and spreadsheets write them: a CSV file, or a table of pandas."""

from __future__ import annotations

import codecs
import csv
import io
import re
import unicodedata
from os import PathLike
from typing import Any

import numpy as np
import pandas as pd

from thirdbody.bearings import USUAL_BEARING
from thirdbody.conditions import NEVER_ZERO, registry, warn_outside
from thirdbody.files import readable_file
from thirdbody.lab.estimates import MEASURED
from thirdbody.messages import format_path, format_value
from thirdbody.variables import AXES, BY_ALIAS

# a unit of each condition, and the usual range of the numbers, by the name in headings
CONDITION_UNITS = {name.replace("_", " "): axis.alias_unit for name, axis in AXES.items()}
CONDITION_UNITS["speed"] = "m/s"
USUAL_ENDS = {name: ends for name, (_, _, *ends) in MEASURED.items()}
USUAL_ENDS["speed"] = USUAL_BEARING["speed_m_per_s"][:2]
# headings of the library's own tables: their name and unit
OWN = {key: (axis.name.replace("_", " "), axis.alias_unit) for key, axis in BY_ALIAS.items()}
OWN |= {column: (name, unit) for name, (column, unit, *_) in MEASURED.items()}
OWN["speed_m_per_s"] = "speed", "m/s"
ALIASES = dict.fromkeys(("cof", "coefficient of friction", "µ", "μ"), "friction coefficient")
ALIASES |= dict.fromkeys(("normal load", "normal force"), "load")
DIMENSIONLESS = "-", "1"  # units of ratios
LENGTHS = {name for name, (_, unit, *_) in MEASURED.items() if unit == "nm"}
# "load [N]", "load (N)", "load / N", "load, N" or "load in N"
UNIT = r"\[(.*)\]|\((.*)\)|/\s*([^/]+)|(?:,|\sin\s)\s*([^\s,\[\]()]+)"
HEADING = re.compile(rf"(.*?)\s*(?:{UNIT})?", re.DOTALL)
NUMBER = re.compile(r"[-+]?(?:\d+[.,]?\d*|[.,]\d+)(?:e[-+]?\d+)?", re.IGNORECASE)
THOUSANDS = re.compile(r"[-+]?[1-9]\d{0,2},\d{3}")


def read_measured(measured: str | PathLike | pd.DataFrame) -> tuple[dict[str, Any], list[str]]:
    """The known columns as quantities of pint, by their name in headings; and notes on what was left out.

    Raises ``ValueError`` in one line for what ``thirdbody.compare`` refuses in a table.
    """
    table, notes = (measured, []) if isinstance(measured, pd.DataFrame) else _read_csv(measured)
    if not len(table):
        raise ValueError("measured has no rows; allowed: one or more below the headings")
    columns, others = {}, []
    for heading, column in table.items():
        name, unit = _named(heading)
        is_relative = name in LENGTHS and unit in DIMENSIONLESS  # H_c
        if is_relative or name not in MEASURED.keys() | CONDITION_UNITS.keys():
            others.append(str(heading))
        elif name in columns:
            message = f"measured has the column {format_value(heading)}, a second one of {name}"
            raise ValueError(f"{message}; allowed: one of each")
        else:
            columns[name] = heading, unit, column
    if table is not measured:
        columns = _with_points(columns)
    found = {name: _quantity(name, *each, notes) for name, each in columns.items()}
    named = ", ".join(each for each in others if each.strip())
    if not MEASURED.keys() & found.keys():
        message = f"measured has no column of {', '.join(MEASURED)}; allowed: one or more"
        raise ValueError(message + (f" beside {named}" if named else ""))
    return found, [*notes, f"columns left out: {named}"] if named else notes


def _named(heading: Any) -> tuple[str, str]:
    """Name and unit of a heading; the unit is empty if there is none."""
    text = str(heading).strip()
    if text in OWN:
        return OWN[text]
    words, *units = HEADING.fullmatch(text).groups()
    name = " ".join(words.lower().replace("_", " ").split())
    return ALIASES.get(name, name), next(filter(None, units), "").strip()


# ---- files


def _read_csv(path):
    """A CSV file as texts, with rows counted from 1; and notes on the lines above its headings."""
    name, text = _text(path)
    rows = _rows(name, text)
    if not rows:
        raise ValueError(f"{name} is empty; allowed: headings and rows below them")
    above = next((place for place, row in enumerate(rows) if _measured_in(row)), 0)
    headings, *rows = rows[above:]
    while not headings[-1].strip() and not any("".join(row[len(headings) - 1 :]) for row in rows):
        headings = headings[:-1]  # separators at the end
    width = len(headings)
    rows = [row if "".join(row[width:]).strip() else row[:width] for row in rows]
    if rows and len(rows[0]) == width and _are_units(headings, rows[0]):
        units, *rows = rows
        headings = [f"{each} [{unit.strip(' []()')}]" for each, unit in zip(headings, units)]
    for row in rows:
        if len(row) != width:
            found = f"{len(row)} cells in the row {format_value(','.join(row))}"
            raise ValueError(f"{name} has {found}; allowed: {width}, as headings")
    notes = [f"lines above the headings left out: {above}"] if above else []
    return pd.DataFrame(rows, pd.RangeIndex(1, len(rows) + 1), headings), notes


def _text(path):
    """The name and the text of a file in any usual encoding."""
    place = readable_file("measured", path, "a pandas.DataFrame, or the path of a CSV file")
    name, content = format_path(place), place.read_bytes()
    wide = content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    try:
        text = content.decode("utf-16" if wide else "utf-8-sig")
    except UnicodeDecodeError:
        text = content.decode("cp1252", "replace")  # of spreadsheets
    if "\0" in text:
        raise ValueError(f"{name} is not a text; allowed: a CSV file")
    # the signs of units as they are typed, and the minus of typography
    return name, unicodedata.normalize("NFC", text).replace("\u2212", "-")


def _rows(name, text):
    """The rows with content, split at the separator that gives most measured quantities."""

    def split(separator, strict):
        lines = io.StringIO(text, newline="")
        reader = csv.reader(lines, delimiter=separator, skipinitialspace=True, strict=strict)
        return [row for row in reader if "".join(row).strip() and not row[0].startswith("#")]

    def known(separator):
        rows = split(separator, strict=False)
        return max(((_measured_in(row), len(row)) for row in rows), default=(0, 0))

    try:
        return split(max("\t;,", key=known), strict=True)
    except csv.Error as error:
        message = f"{name} has quotation marks that do not pair ({error})"
        raise ValueError(f"{message}; allowed: pairs of them") from None


def _measured_in(row):
    """The number of cells that are headings of measured quantities."""
    return sum(_named(cell)[0] in MEASURED for cell in row)


def _are_units(headings, cells):
    """Whether the first row below headings has units, which the headings then have not."""
    known = any(_named(each)[1] for each in headings)
    digits = any(sign.isdigit() for cell in cells for sign in cell)
    return not (known or digits) and any(cell.strip() not in ("", "-") for cell in cells)


def _with_points(columns):
    """Columns of texts with decimal points; ``ValueError`` for numbers that may be one or another."""
    cells = (cell.strip() for *_, column in columns.values() for cell in column)
    numbers = [cell for cell in cells if NUMBER.fullmatch(cell)]
    commas = [each for each in numbers if "," in each]
    if commas and any("." in each for each in numbers):
        message = "measured has numbers with a comma and numbers with a point"
        raise ValueError(f"{message}; allowed: one decimal sign, and none between thousands")
    if commas and all(THOUSANDS.fullmatch(each) for each in commas):
        message = f"measured has {commas[0]!r}, with a comma of decimals or of thousands"
        raise ValueError(f"{message}; allowed: a decimal point, and nothing between thousands")
    return {
        name: (heading, unit, column.map(_with_point) if commas else column)
        for name, (heading, unit, column) in columns.items()
    }


def _with_point(cell):
    return cell.replace(",", ".") if NUMBER.fullmatch(cell.strip()) else cell


# ---- columns


def _quantity(name, heading, unit, column, notes):
    """A column as a quantity, nan in cells without a measurement; ``notes`` get the marks of these."""
    numbers = _numbers(name, heading, column, notes)
    wanted = CONDITION_UNITS.get(name) or MEASURED[name][1]
    if unit in DIMENSIONLESS or (not unit and name in MEASURED):  # ratios may omit their unit
        unit = "dimensionless"
    try:
        quantity = registry().Quantity(numbers, registry().Unit(unit.replace("%", "percent")))
        known = quantity.is_compatible_with(wanted) or (name == "load" and quantity.unitless)
    except Exception:  # pint raises many types
        known = False
    if not unit or not known:
        message = f"the unit of {format_value(heading)} is not known"
        raise ValueError(f"{message}; allowed: as '{name} [{wanted}]'")
    if name in USUAL_ENDS:
        ends = registry().Quantity(USUAL_ENDS[name], wanted).to(quantity.units).magnitude
        warn_outside({name: numbers}, {name: (*ends, unit.replace("dimensionless", "1"))})
    return quantity


def _numbers(name, heading, column, notes):
    """The numbers of a column; of a measured quantity nan in cells without one."""
    texts = column.astype(str).str.strip()
    numbers = pd.to_numeric(texts, errors="coerce").to_numpy(float)
    wrong, allowed = ~np.isfinite(numbers), "numbers, finite and with a decimal point"
    if name in MEASURED:
        # "#DIV/0!" is one of the marks of spreadsheets
        without = ~texts.str.contains(r"\d").to_numpy(bool) | texts.str.startswith("#").to_numpy()
        missing = np.isnan(numbers) & without
        wrong &= ~missing
        if missing.any():
            marks = ", ".join(sorted({format_value(text) for text in texts[missing]}))
            notes.append(f"{heading} has {missing.sum()} cells without a number: {marks}")
    elif not wrong.any():
        wrong = numbers <= 0.0 if name in NEVER_ZERO else numbers < 0.0
        allowed = f"{'' if name in NEVER_ZERO else 'zero or '}positive numbers"
    for index in np.flatnonzero(wrong):
        row, cell = column.index[index], format_value(column.iloc[index])
        raise ValueError(f"{heading} is {cell} in row {row}; allowed: {allowed}")
    if np.isnan(numbers).all():
        raise ValueError(f"{heading} has no numbers; allowed: one or more")
    return numbers
