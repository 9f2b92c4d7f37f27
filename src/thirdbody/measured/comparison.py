"""``compare``: measurements compared with the model, with ensemble ranges and residuals."""

from __future__ import annotations

import codecs
import csv
import re
from dataclasses import asdict, dataclass
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import ArrayLike

from thirdbody.answers.answer import NO_ENSEMBLE, Answer, Row
from thirdbody.answers.bearing import USUAL as BEARING
from thirdbody.answers.bearing import USUAL_DENSITY, bearing, implied_speed
from thirdbody.conditions import (
    check_numbers,
    checked_parameters,
    in_si,
    is_column,
    warn_outside,
    without_warnings,
)
from thirdbody.configuration.inputs import calibrated_ensemble
from thirdbody.data.quantities import ranges
from thirdbody.measured.estimates import FORMULAS, MEASURED, Assumed, measurable
from thirdbody.messages import format_path, format_value
from thirdbody.model.parameters import Parameters
from thirdbody.solver.solve import solve
from thirdbody.tabular import Tabular
from thirdbody.units import ENGINEERING, UNITS, decimal, registry, unit_of

# a unit of each condition, and the column and unit of each measured quantity, by heading
CONDITIONS = {name.replace("_", " "): UNITS[key].text for name, key in ENGINEERING.items()}
CONDITIONS["speed"] = "m/s"
UNITS_OF = {column: unit for column, unit, *_ in MEASURED.values()}
USUAL = {name: ends for name, (_, _, *ends) in MEASURED.items()}  # least and most
USUAL["speed"] = BEARING["speed_m_per_s"][:2]
# other words for measured quantities
ALIASES = {"cof": "friction coefficient", "coefficient of friction": "friction coefficient"}
DIMENSIONLESS = "-", "1"  # units of ratios
LENGTHS = {name for name, (_, unit, *_) in MEASURED.items() if unit == "nm"}
CURVE = 80  # points of the model's curve where one condition varies
# "load [N]", "load (N)" or "load / N"
HEADING = re.compile(r"^\s*(.*?)\s*(?:\[(.*)\]|\((.*)\)|/\s*([^/]+?))?\s*$")


@dataclass(frozen=True, eq=False)
class Comparison(Tabular):
    """Measurements compared with the model.

    ``table`` has one row per measurement, with the index of the measurements: its conditions and,
    for each of the measured ``variables``, the measured value, ``_model``, ``_low`` and ``_high`` of the ensemble (if there
    is one) and ``_residual``, measured minus model.  ``curve`` is the model between the
    measurements, in the same columns, if one condition varies; otherwise empty.  ``along`` is the
    column that varies most, the abscissa of ``plot``; ``notes`` state the assumptions of the
    estimates, and what was not compared.
    """

    table: pd.DataFrame
    curve: pd.DataFrame
    along: str
    variables: tuple[str, ...]
    notes: tuple[str, ...]

    @property
    def answer(self) -> Answer:
        """Mean and root mean square residuals, and numbers of measurements within the ensemble range."""
        rows, notes = [], []
        for name in self.variables:
            known = self.table[np.isfinite(self.table[f"{name}_residual"])]
            residual = known[f"{name}_residual"]
            unit = UNITS_OF[name].replace("dimensionless", "1")
            sizes = float(residual.mean()), float(np.sqrt((residual**2).mean()))
            mean, size = sizes if len(known) else (None, None)
            rows.append(Row(f"{name}_mean", f"{name}: mean residual", mean, unit))
            rows.append(Row(f"{name}_rms", f"{name}: root mean square residual", size, unit))
            if f"{name}_low" in known:
                inside = known[name].between(known[f"{name}_low"], known[f"{name}_high"])
                count = f"{inside.sum()} of {len(known)}"
                notes.append(f"{name} is within the 90 % range in {count} measurements")
        title = f"{len(self.table)} measurements beside the model, along {self.along}"
        found = any(row.value is not None for row in rows)
        return Answer(title, tuple(rows), (*notes, *self.notes), found)

    def to_dataframe(self) -> pd.DataFrame:
        """``table``."""
        return self.table

    def plot(self) -> Any:
        """A matplotlib figure: measurements, the model and its range, a panel for each variable."""
        from thirdbody.figures.plot import plot_comparison

        return plot_comparison(self)

    def __str__(self) -> str:
        return str(self.answer)


def compare(
    measured: str | PathLike | pd.DataFrame,
    *,
    parameters: Parameters | None = None,
    speed_m_per_s: float | None = None,
    oil_density_kg_per_m3: float | None = None,
    ball_radius_mm: float | None = None,
    assumed: Assumed | None = None,
    **conditions: ArrayLike,
) -> Comparison:
    """Compare measurements with the model and with the range of its calibrated ensemble.

    Raises ``ValueError`` for an unknown heading or unit, a cell that is not a number, a file without
    measurements, and a condition that is missing, given twice or refused by ``solve``; ``OSError`` if
    the file cannot be read.

    Parameters
    ----------
    measured : path or pandas.DataFrame
        CSV separated by commas, semicolons (also with decimal commas) or tabs.  Headings have units,
        as ``load [N]``, ``load (N)``, ``load / N`` or in a row below them: ``viscosity [cSt]``,
        ``speed [m/s]``, ``particle diameter [um]``, ``roughness [nm]``, ``particle density [1/mm^2]``;
        and the measured quantities of ``estimates.toml``, such as ``friction coefficient`` and
        ``film thickness [nm]``.  A cell of a measured quantity without digits is a missing value.
        ``notes`` name these, and other columns, which are left out, such as H_c, ``film thickness [1]``.
    speed_m_per_s, oil_density_kg_per_m3, ball_radius_mm : float, optional
        The rolling speed of ``parameters`` [m/s], required if and only if there is a column of speeds.
        The published inputs stand for the speed that the message about a contradiction states.  With
        the density of the oil [kg m-3], the inputs are derived for this speed and ball by ``bearing``.
    assumed : Assumed, optional
        Assumptions of the estimates of friction and contact resistance (``estimates.Assumed``).
    parameters, **conditions
        As in ``thirdbody.solve``: inputs, and conditions that are not columns.

    Examples
    --------
    >>> import pandas as pd
    >>> import thirdbody as tb
    >>> data = {"load [N]": [5, 10, 20], "friction coefficient": [0.06, 0.08, 0.10]}
    >>> layer = dict(particle_diameter_nm=500, particle_density_per_m2=1e11, roughness_nm=300)
    >>> found = tb.compare(pd.DataFrame(data), viscosity_cSt=90, **layer)
    >>> found.table["friction_coefficient_model"].round(3).tolist()
    [0.114, 0.095, 0.074]
    """
    parameters = checked_parameters(parameters)
    assumed = Assumed() if assumed is None else assumed
    columns, notes = _read(measured)
    observed = {MEASURED[name][0]: columns[name] for name in columns if name in MEASURED}
    if not observed:
        raise ValueError(f"measured has no column of {', '.join(MEASURED)}; allowed: one or more")
    if ("speed" in columns) != (speed_m_per_s is not None):
        message = f"speed_m_per_s is {format_value(speed_m_per_s)}"
        raise ValueError(f"{message}; allowed: a number with a column of speeds, else none")
    if oil_density_kg_per_m3 is not None or ball_radius_mm is not None:
        parameters = bearing(
            parameters,
            ball_radius_mm=ball_radius_mm,
            speed_m_per_s=speed_m_per_s,
            oil_density_kg_per_m3=oil_density_kg_per_m3,
        )
    if speed_m_per_s is not None:
        check_numbers({"speed_m_per_s": speed_m_per_s}, BEARING)
        _check_speed(speed_m_per_s, parameters)
    rows = len(next(iter(columns.values())))
    index = measured.index if isinstance(measured, pd.DataFrame) else pd.RangeIndex(rows)
    table = _conditions(columns, conditions, parameters, index)
    along, curve = _curve(table)
    members = calibrated_ensemble(parameters)
    table, curve = (
        _with_model(each, observed, (parameters, *members), speed_m_per_s, assumed)
        for each in (table, curve)
    )
    for name, quantity in observed.items():
        table[name] = quantity.to(UNITS_OF[name]).magnitude
        table[f"{name}_residual"] = table[name] - table[f"{name}_model"]
        if name in FORMULAS:
            notes.append(f"{name} is an estimate: {FORMULAS[name].format(**asdict(assumed))}")
    if not members:
        notes.append(NO_ENSEMBLE)
    unsolved = int(table[f"{name}_model"].isna().sum())
    if unsolved:
        notes.append(f"the model has no solution at {unsolved} of {len(table)} measurements")
    return Comparison(table, curve, along, tuple(observed), tuple(notes))


def _check_speed(speed, parameters):
    """Raise ``ValueError`` if no oil has the density that the inputs imply at this speed [m/s]."""
    usual = implied_speed(parameters)
    density = USUAL_DENSITY * usual / speed
    least, most, _ = BEARING["oil_density_kg_per_m3"]
    if not least <= density <= most:
        raise ValueError(
            f"speed_m_per_s is {speed:g}, at which the inputs stand for an oil of {density:.5g} kg/m3; allowed: "
            f"{usual:.3g} m/s (with {USUAL_DENSITY:g} kg/m3), or oil_density_kg_per_m3, which derives the inputs"
        )


def _read(measured):
    """The columns of a file or table by heading, without unit, as quantities of pint, and notes on
    what was left out."""
    table = measured if isinstance(measured, pd.DataFrame) else _read_csv(measured)
    if not len(table):
        raise ValueError("measured has no rows; allowed: one or more below the headings")
    columns, notes, others = {}, [], []
    for heading, column in table.items():
        words, *units = HEADING.match(str(heading)).groups()
        name, unit = words.lower().replace("_", " "), next(filter(None, units), "")
        name = ALIASES.get(name, name)
        if name in columns:
            message = f"measured has the column {format_value(heading)}, a second one of {name}"
            raise ValueError(f"{message}; allowed: one of each")
        is_relative = name in LENGTHS and unit in DIMENSIONLESS  # H_c
        if (name in MEASURED or name in CONDITIONS) and not is_relative:
            columns[name] = _quantity(heading, name, unit, column, notes)
        else:
            others.append(str(heading))
    if others:
        notes.append(f"columns left out: {', '.join(others)}")
    return columns, notes


def _read_csv(path):
    """A CSV file as texts; the separator is the first of tab, semicolon and comma found in the headings."""
    if not isinstance(path, str | PathLike):
        allowed = "a pandas.DataFrame, or the path of a CSV file"
        raise ValueError(f"measured is {format_value(path)}; allowed: {allowed}")
    name = format_path(path)
    try:
        content = Path(path).read_bytes()
    except OSError as error:
        raise type(error)(f"{name} cannot be read ({error.strerror})") from None
    wide = content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    try:
        text = content.decode("utf-16" if wide else "utf-8-sig")
    except UnicodeDecodeError:
        text = content.decode("cp1252", "replace")  # of spreadsheets
    lines = [line for line in text.splitlines() if line.strip() and not line.startswith("#")]
    if not lines:
        raise ValueError(f"{name} is empty; allowed: headings and rows below them")
    separator = next((each for each in "\t;" if each in lines[0]), ",")
    headings, *rows = csv.reader(lines, delimiter=separator, skipinitialspace=True)
    lines = [headings, *rows]
    if not any(
        "".join(line[len(headings) - 1 :]).strip() for line in lines
    ):  # separators at the end
        headings, *rows = (line[: len(headings) - 1] for line in lines)
    if rows and len(rows[0]) == len(headings) and _are_units(headings, rows[0]):
        units, *rows = rows
        headings = [f"{each} [{unit.strip()}]" for each, unit in zip(headings, units)]
    for row in rows:
        if len(row) != len(headings):
            found = f"{len(row)} cells in the row {format_value(separator.join(row))}"
            raise ValueError(f"{name} has {found}; allowed: {len(headings)}, as headings")
    if separator == ";":
        signs = {sign for row in rows for cell in row for sign in ",." if sign in cell}
        if len(signs) > 1:
            message = f"{name} has numbers with a comma and numbers with a point"
            raise ValueError(f"{message}; allowed: one decimal sign, and none between thousands")
        rows = [[cell.replace(",", ".") for cell in row] for row in rows]
    return pd.DataFrame(rows, columns=headings)


def _are_units(headings, cells):
    """Whether the first row below headings has units, which the headings then have not."""
    known = any(any(HEADING.match(each).groups()[1:]) for each in headings)
    digits = any(sign.isdigit() for cell in cells for sign in cell)
    return not (known or digits) and any(cell.strip() not in ("", "-") for cell in cells)


def _quantity(heading, name, unit, column, notes):
    """The numbers of a column, nan in cells without a measurement, with their unit, which only
    dimensionless quantities may omit; for F_t* it is 1.  ``notes`` get the marks of missing values."""
    texts = column.astype(str).str.strip()
    numbers = pd.to_numeric(texts, errors="coerce").to_numpy(float)
    wrong = ~np.isfinite(numbers)
    if name in MEASURED:
        missing = np.isnan(numbers) & ~texts.str.contains(r"\d").to_numpy(bool)
        wrong &= ~missing
        if missing.any():
            marks = ", ".join(sorted({format_value(text) for text in texts[missing]}))
            notes.append(f"{heading} has {missing.sum()} cells without a number: {marks}")
    for index in np.flatnonzero(wrong):
        message = f"{heading} is {format_value(column.iloc[index])} in row {index + 1}"
        raise ValueError(f"{message}; allowed: numbers, finite and with a decimal point")
    if np.isnan(numbers).all():
        raise ValueError(f"{heading} has no numbers; allowed: one or more")
    wanted = CONDITIONS.get(name) or MEASURED[name][1]
    if unit in DIMENSIONLESS or (not unit and name in MEASURED):
        unit = "dimensionless"
    try:
        quantity = registry().Quantity(numbers, registry().Unit(unit.replace("%", "percent")))
        known = quantity.is_compatible_with(wanted) or (name == "load" and quantity.unitless)
    except Exception:  # pint raises many types
        known = False
    if not unit or not known:
        message = f"the unit of {format_value(heading)} is not known"
        raise ValueError(f"{message}; allowed: as '{name} [{wanted}]'")
    if name in USUAL:
        ends = registry().Quantity(USUAL[name], wanted).to(quantity.units).magnitude
        warn_outside({name: numbers}, {name: (*ends, unit.replace("dimensionless", "1"))})
    return quantity


def _conditions(columns, conditions, parameters, index):
    """The conditions of each measurement in engineering units, with the speed if there is one."""
    names = zip(CONDITIONS, ENGINEERING)
    given = {name: columns[words] for words, name in names if words in columns}
    for key, values in conditions.items():
        if unit_of(key).condition in given:
            raise ValueError(f"{key} is given twice; allowed: a column, or one number")
        if is_column(values) and not values.index.equals(index):
            message = f"{key} and measured have different indexes"
            raise ValueError(f"{message}; allowed: columns of one table, or their .to_numpy()")
    found = in_si(given | conditions, parameters)
    table = {
        key: decimal(UNITS[key].from_si(found[name], parameters.newtons_per_load))
        for name, key in ENGINEERING.items()
    }
    if "speed" in columns:
        table["speed_m_per_s"] = columns["speed"].to("m/s").magnitude
    for name, values in table.items():
        if values.shape not in ((), (len(index),)):
            allowed = f"one number, or {len(index)}"
            raise ValueError(f"{name} has shape {values.shape}; allowed: {allowed}")
    return pd.DataFrame(table, index=index).astype(float)


def _curve(table):
    """The condition that varies most, and conditions along it; none if another one also varies."""
    varying = table.nunique().sort_values(ascending=False, kind="stable")
    along = varying.index[0]
    if len(varying[varying > 1]) != 1:
        return along, table.iloc[:0]
    ends = table[along].min(), table[along].max()
    points = np.geomspace(*ends, CURVE) if ends[0] > 0.0 else np.linspace(*ends, CURVE)
    return along, pd.DataFrame(table.iloc[0].to_dict() | {along: points})


def _with_model(table, columns, inputs, speed_m_per_s, assumed):
    """Conditions with the model values for the first of the inputs, and the range of the others."""
    conditions = {name: table[name].to_numpy() for name in ENGINEERING.values()}
    if speed_m_per_s is not None:  # the film depends on the product of speed and viscosity
        speed = table["speed_m_per_s"].to_numpy() / speed_m_per_s
        conditions["viscosity_cSt"] = conditions["viscosity_cSt"] * speed
    with without_warnings():
        found = [
            measurable(solve(**conditions, parameters=each, progress=False), each, assumed)
            for each in inputs
        ]
    for column in columns:
        mine, *members = (each[column] for each in found)
        table = table.assign(**{f"{column}_model": mine}, **ranges(column, members))
    return table
