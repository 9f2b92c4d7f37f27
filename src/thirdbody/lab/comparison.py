"""``compare``: measurements compared with the model, with ensemble ranges and residuals."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from os import PathLike
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import ArrayLike

from thirdbody.answers.answer import Answer, Row, range_note
from thirdbody.bearings import (
    LUBRICANT_DENSITIES,
    USUAL_BEARING,
    USUAL_DENSITY,
    bearing,
    implied_speed,
    speed_note,
)
from thirdbody.conditions import (
    axis_of,
    checked_numbers,
    from_si,
    read_conditions,
    without_warnings,
)
from thirdbody.core.parameters import Parameters
from thirdbody.inputs import or_calibrated
from thirdbody.lab.estimates import FORMULAS, MEASURED, Assumed, measurable
from thirdbody.lab.reading import read_measured
from thirdbody.points import solve
from thirdbody.ranges import ranges
from thirdbody.tabular import Tabular
from thirdbody.variables import AXES, BY_ALIAS, decimal

UNITS_OF = {column: unit for column, unit, *_ in MEASURED.values()}
CURVE = 80  # points of the model's curve where one condition varies


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
                notes.append(f"{name} is within the range in {count} measurements")
        title = f"{len(self.table)} measurements beside the model, along {self.along}"
        found = any(row.value is not None for row in rows)
        return Answer(title, tuple(rows), (*notes, *self.notes), found)

    def to_dataframe(self) -> pd.DataFrame:
        """``table``."""
        return self.table

    def plot(self) -> Any:
        """A matplotlib figure: measurements, the model and its range, a panel for each variable."""
        from thirdbody.plotting.plot import plot_comparison

        return plot_comparison(self.table, self.curve, self.along, self.variables)

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
        CSV separated by commas, semicolons or tabs, also with decimal commas and with lines above the
        headings.  Headings have units, as ``load [N]``, ``load (N)``, ``load / N`` or in a row below
        them: ``viscosity [cSt]``, ``speed [m/s]``, ``particle diameter [um]``, ``roughness [nm]``,
        ``particle density [1/mm^2]``; and the measured quantities of ``estimates.toml``, such as
        ``friction coefficient`` and ``film thickness [nm]``; or are names such as ``load_N``.  A cell of
        a measured quantity without digits is a missing value.  ``notes`` name these, and other columns,
        which are left out, such as H_c, ``film thickness [1]``.
    speed_m_per_s, oil_density_kg_per_m3, ball_radius_mm : float or quantity, optional
        With the density of the oil [kg m-3], the inputs are derived for this rolling speed [m/s] and ball
        by ``bearing``; a column of speeds then needs no other one.  Without it, such a column requires the
        speed of ``parameters``, at which they stand for an oil of 700 to 1100 kg/m3; ``notes`` state both.
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
    [0.117, 0.099, 0.077]
    """
    parameters = or_calibrated(parameters)
    assumed = Assumed() if assumed is None else assumed
    columns, notes = read_measured(measured)
    observed = {MEASURED[name][0]: each for name, each in columns.items() if name in MEASURED}
    bearing_given = {
        "speed_m_per_s": speed_m_per_s,
        "oil_density_kg_per_m3": oil_density_kg_per_m3,
        "ball_radius_mm": ball_radius_mm,
    }
    parameters, speed, density = _of_bearing(parameters, "speed" in columns, bearing_given)
    rows = len(next(iter(columns.values())))
    index = measured.index if isinstance(measured, pd.DataFrame) else pd.RangeIndex(rows)
    try:
        table = _conditions(columns, conditions, parameters, index)
    except ValueError as error:  # perhaps a condition is among the columns left out
        raise ValueError("; ".join([str(error), *notes])) from None
    along, curve = _curve(table)
    members = parameters.members
    table, curve = (
        _with_model(each, observed, (parameters, *members), speed, assumed)
        for each in (table, curve)
    )
    if table["viscosity_cSt"].any():
        notes.append(speed_note(parameters, density))
    for name, quantity in observed.items():
        table[name] = decimal(quantity.to(UNITS_OF[name]).magnitude)
        table[f"{name}_residual"] = table[name] - table[f"{name}_model"]
        if name in FORMULAS:
            notes.append(f"{name} is an estimate: {FORMULAS[name].format(**asdict(assumed))}")
    notes.append(range_note(members))
    unsolved = int(table[f"{name}_model"].isna().sum())
    if unsolved:
        notes.append(f"the model has no solution at {unsolved} of {len(table)} measurements")
    return Comparison(table, curve, along, tuple(observed), tuple(notes))


def _of_bearing(parameters, has_speeds, given):
    """The inputs for the ball, speed and oil that are given; and the speed [m/s] and the density of the oil
    [kg m-3] that they stand for."""
    given = {name: each for name, each in given.items() if each is not None}
    numbers = checked_numbers(given, USUAL_BEARING)
    speed, density = (numbers.get(name) for name in ("speed_m_per_s", "oil_density_kg_per_m3"))
    if has_speeds and density is None:
        density = _implied_density(parameters, speed)
        del numbers["speed_m_per_s"]
    elif (
        has_speeds and speed is None
    ):  # the film depends on the speeds of the column and the density
        numbers["speed_m_per_s"] = speed = implied_speed(parameters, density)
    elif speed is not None and density is None:
        message = f"speed_m_per_s is {speed:g}, without a column of speeds"
        raise ValueError(f"{message}; allowed: none, or also oil_density_kg_per_m3")
    with without_warnings():
        inputs = bearing(parameters, **numbers) if numbers else parameters
    return inputs, speed, density or USUAL_DENSITY


def _implied_density(parameters, speed):
    """The density of the oil [kg m-3] that the inputs stand for at a ``speed`` [m/s]; ``ValueError`` unless a
    lubricant has it."""
    usual = f"{implied_speed(parameters):.3g} m/s (with {USUAL_DENSITY:g} kg/m3)"
    if speed is None:
        message = "speed_m_per_s is None, with a column of speeds; allowed: the speed of the inputs"
        raise ValueError(f"{message}, {usual}, or oil_density_kg_per_m3")
    density = USUAL_DENSITY * implied_speed(parameters) / speed
    least, most = LUBRICANT_DENSITIES
    if not least <= density <= most:
        message = f"speed_m_per_s is {speed:g}, at which the inputs stand for an oil of"
        allowed = f"{least:g} to {most:g} kg/m3, as at {usual}, or also oil_density_kg_per_m3"
        raise ValueError(f"{message} {density:.5g} kg/m3; allowed: {allowed}")
    return density


def _conditions(columns, conditions, parameters, index):
    """The conditions of each measurement in engineering units, with the speed if there is one."""
    words = {name: name.replace("_", " ") for name in AXES}
    given = {name: columns[each] for name, each in words.items() if each in columns}
    for key in conditions:
        if axis_of(key).name in given:
            raise ValueError(f"{key} is given twice; allowed: a column, or one number")
    read = read_conditions(given | conditions, parameters)
    if read.index is not None and not read.index.equals(index):
        message = "conditions and measured have different indexes"
        raise ValueError(f"{message}; allowed: columns of one table, or their .to_numpy()")
    table = {
        key: decimal(from_si(key, read.arrays[axis.name], parameters.newtons_per_load))
        for key, axis in BY_ALIAS.items()
    }
    if "speed" in columns:
        table["speed_m_per_s"] = columns["speed"].to("m/s").magnitude
    for key in conditions:
        shape = read.arrays[axis_of(key).name].shape
        if shape not in ((), (len(index),)):
            raise ValueError(f"{key} has shape {shape}; allowed: one number, or {len(index)}")
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


def _with_model(table, columns, inputs, speed, assumed):
    """Conditions with the model values for the first of the inputs, and the range of the others."""
    conditions = {name: table[name].to_numpy() for name in BY_ALIAS}
    if "speed_m_per_s" in table:  # the film depends on the product of speed and viscosity
        ratio = table["speed_m_per_s"].to_numpy() / speed
        conditions["viscosity_cSt"] = conditions["viscosity_cSt"] * ratio
    with without_warnings():
        found = [
            measurable(solve(**conditions, parameters=each, progress=False), each, assumed)
            for each in inputs
        ]
    for column in columns:
        mine, *members = (each[column] for each in found)
        table = table.assign(**{f"{column}_model": mine}, **ranges(column, members))
    return table
