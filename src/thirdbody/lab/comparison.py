"""``compare``: measurements beside the model, with the range of the ensemble and residuals."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from os import PathLike
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd
from numpy.typing import ArrayLike

from thirdbody.bearings import with_oil_density
from thirdbody.conditions import (
    checked_number,
    density_of_oil,
    from_si,
    read_conditions,
    without_warnings,
)
from thirdbody.core.parameters import Parameters
from thirdbody.inputs import or_calibrated
from thirdbody.lab.estimates import MEASURED, fitted_coefficients, measurable
from thirdbody.lab.reading import read_measured
from thirdbody.notes import area_note, range_note, speed_note
from thirdbody.points import Solution, solve
from thirdbody.ranges import ranges
from thirdbody.variables import CONDITIONS, SPEED, decimal

if TYPE_CHECKING:
    from matplotlib.figure import Figure

CURVE = 80  # points of the model between the measurements


def compare(
    measured: str | PathLike | pd.DataFrame,
    *,
    parameters: Parameters | None = None,
    boundary_friction: float | None = None,
    film_friction: float | None = None,
    resistivity_ohm_m: float | None = None,
    oil_density_kg_per_m3: float | None = None,
    **conditions: ArrayLike,
) -> pd.DataFrame:
    """Compare measurements with the model and with the range of its calibrated ensemble.

    Parameters
    ----------
    measured : path or pandas.DataFrame
        One row a measurement; a CSV file may have commas, semicolons or tabs, decimal commas, and lines
        above the headings.  Headings have units, as ``load [N]``, ``load (N)`` or ``load / N``, or are keys
        such as ``load_N``.  Conditions are load, viscosity, particle diameter, roughness, particle density
        and speed; measured quantities friction coefficient, contact resistance, film thickness, separation,
        real contact area, real contact area fraction, solid load fraction and fluid load fraction.  Other
        columns are left out.
    parameters : Parameters, optional
        Inputs of the model, by default the calibrated ones.
    boundary_friction, film_friction, resistivity_ohm_m : float or quantity, optional
        Coefficients [1], [1] and [ohm m] of ``thirdbody.lab.friction`` and ``thirdbody.lab.contact_resistance``.
        Those that are not given are fitted to the measurements by linear least squares.  Where the
        measurements do not tell them, they are 0.12, 0.03 and 2.2e-7, for steel in oil.
    oil_density_kg_per_m3 : float or quantity, optional
        For speeds, the density of the oil [kg m-3], by default that of ``parameters``.
    **conditions
        Conditions that are not columns, as in ``thirdbody.solve``, also the speed.

    Returns
    -------
    pandas.DataFrame
        A row for each measurement, with the index of the measurements.  Columns are the conditions; and for
        each measured quantity its value, the model's (``_model``), the range over the members of
        ``parameters``, 5 to 95 % (``_low``, ``_high``), and measured minus model (``_residual``).
        ``attrs`` has ``notes``; ``along``, the condition that varies most; ``summary``, a mapping for each
        quantity with the count, mean and root mean square of the residuals, and how many measurements are
        inside the range; ``coefficients``; and ``inputs``, the values of ``parameters``.

    Raises
    ------
    TypeError
        For a condition that is a column and an argument, and an unknown one.
    ValueError
        For a condition that is missing or that ``solve`` refuses, a column without a unit, two columns of
        one quantity, a table without measured quantities, and a density of the oil without speeds.
    OSError
        If the file cannot be read.

    Warns
    -----
    OutOfRangeWarning
        For numbers that are probably in another unit.

    Examples
    --------
    >>> import pandas as pd
    >>> import thirdbody as tb
    >>> data = {"load [N]": [5, 10, 20, 40], "friction coefficient": [0.106, 0.093, 0.074, 0.06]}
    >>> layer = dict(particle_diameter_nm=500, particle_density_per_m2=1e11, roughness_nm=300)
    >>> table = tb.lab.compare(pd.DataFrame(data), viscosity_cSt=90, **layer)
    >>> table["friction_coefficient_model"].round(3).tolist()
    [0.107, 0.092, 0.074, 0.06]
    >>> print(table.attrs["notes"][0])
    boundary_friction is 0.109 with a standard error of 0.00087, fitted to the measurements
    """
    parameters = or_calibrated(parameters)
    observed, table, notes = read_runs(measured, parameters, conditions)
    parameters = of_oil(oil_density_kg_per_m3, parameters, table)
    solutions = solve_runs(table, (parameters, *parameters.members))
    coefficients, fits = fitted_coefficients(
        observed,
        solutions[0],
        {
            "boundary_friction": boundary_friction,
            "film_friction": film_friction,
            "resistivity_ohm_m": resistivity_ohm_m,
        },
    )
    models = _models(solutions, coefficients)
    for name in observed:
        table[name] = observed[name]
        table = table.assign(**_model_columns(name, models))
        table[f"{name}_residual"] = table[name] - table[f"{name}_model"]
    notes += [*fits, area_note(parameters)]
    if SPEED.alias in table:
        notes.append(f"speeds are those in an oil of {density_of_oil(parameters):g} kg/m3")
    elif table["viscosity_cSt"].any():
        notes.append(speed_note(parameters))
    notes.append(range_note(parameters.members))
    unsolved = int(np.isnan(solutions[0].separation).sum())
    if unsolved:
        notes.append(f"the model has no solution at {unsolved} of {len(table)} measurements")
    table.attrs = {
        "notes": notes,
        "along": _varying(table)[0],
        "summary": [_summary(table, name) for name in observed],
        "coefficients": coefficients,
        "inputs": parameters.as_dict(),
        "oil_density_kg_per_m3": density_of_oil(parameters),
    }
    return table


def plot_comparison(comparison: pd.DataFrame, parameters: Parameters | None = None) -> Figure:
    """Draw a comparison: the measurements, the model and its range, a panel for each measured quantity.

    Parameters
    ----------
    comparison : pandas.DataFrame
        The result of ``thirdbody.lab.compare``.
    parameters : Parameters, optional
        The inputs of the comparison, by default the calibrated ones.

    Returns
    -------
    matplotlib.figure.Figure
        Over the condition that varies most, with the curve of the model if no other one varies.

    Raises
    ------
    ValueError
        For other inputs than those of the comparison.
    """
    from thirdbody.plotting import plot

    parameters = or_calibrated(parameters)
    if parameters.as_dict() != comparison.attrs["inputs"]:
        raise ValueError("parameters are not those of the comparison; allowed: the same")
    along, *others = _varying(comparison)
    curve = comparison[_conditions_of(comparison)].iloc[:0]
    ends = comparison[along].min(), comparison[along].max()
    if not others and ends[0] < ends[1]:
        points = (np.geomspace if ends[0] > 0.0 else np.linspace)(*ends, CURVE)
        curve = pd.DataFrame(comparison[curve.columns].iloc[0].to_dict() | {along: points})
    parameters = with_oil_density(parameters, comparison.attrs["oil_density_kg_per_m3"])
    solutions = solve_runs(curve, (parameters, *parameters.members))
    models = _models(solutions, comparison.attrs["coefficients"])
    names = [summary["quantity"] for summary in comparison.attrs["summary"]]
    for name in names:
        curve = curve.assign(**_model_columns(name, models))
    return plot.plot_comparison(comparison, curve, along, names)


def read_runs(
    measured: str | PathLike | pd.DataFrame,
    parameters: Parameters,
    conditions: Mapping[str, Any],
    is_measured: bool = True,
) -> tuple[pd.DataFrame, pd.DataFrame, list[str]]:
    """The measured quantities, if there are to be some, their conditions, with the speed if there is one, and notes."""
    columns, notes = read_measured(measured, is_measured)
    observed = columns[[name for name in columns if name in MEASURED]]
    # dict refuses a condition that is a column and an argument
    arguments = dict(**columns.drop(columns=observed.columns), **conditions)
    try:
        read = read_conditions(arguments, parameters)
    except ValueError as error:
        error.add_note("; ".join(notes))  # perhaps the condition is among the columns left out
        raise
    if read.index is not None and not read.index.equals(observed.index):
        message = "conditions and measured have different indexes"
        raise ValueError(f"{message}; allowed: columns of one table, or their .to_numpy()")
    keys = {name: CONDITIONS[name].alias for name in read.arrays}
    table = {
        key: decimal(from_si(key, read.arrays[name], parameters.newtons_per_load))
        for name, key in keys.items()
    }
    return observed, pd.DataFrame(table, observed.index).astype(float), notes


def of_oil(density: float | None, parameters: Parameters, table: pd.DataFrame) -> Parameters:
    """The same inputs for an oil of another ``density`` [kg m-3], if it is given; it has an effect on speeds alone."""
    if density is None:
        return parameters
    if SPEED.alias not in table:
        raise ValueError(f"oil_density_kg_per_m3 is {density}, without speeds; allowed: None")
    checked = checked_number("oil_density_kg_per_m3", density, unit="kg m-3")
    return with_oil_density(parameters, checked)


def solve_runs(table: pd.DataFrame, inputs: Iterable[Parameters]) -> list[Solution]:
    """The solutions of a table of conditions for each of several inputs."""
    conditions = {key: table[key].to_numpy() for key in _conditions_of(table)}
    with without_warnings():
        return [solve(**conditions, parameters=each, progress=False) for each in inputs]


def _conditions_of(table):
    """The columns of a table that are conditions."""
    return [axis.alias for axis in CONDITIONS.values() if axis.alias in table]


def _models(solutions, coefficients):
    with without_warnings():
        return [measurable(solution, coefficients) for solution in solutions]


def _model_columns(name, models):
    """The column ``_model``, of the first of the models, and the range over the others."""
    first, *members = (model[name] for model in models)
    return {f"{name}_model": first, **ranges(name, members)}


def _varying(table):
    """The conditions that vary, first the one with most values; the load if none varies."""
    counts = table[_conditions_of(table)].nunique()
    varying = counts[counts > 1].sort_values(ascending=False, kind="stable")
    return [*varying.index] or ["load_N"]


def _summary(table, name):
    """How far measurements of a quantity are from the model."""
    known = table[np.isfinite(table[f"{name}_residual"])]
    residual = known[f"{name}_residual"]
    inside = None
    if f"{name}_low" in table:
        inside = int(known[name].between(known[f"{name}_low"], known[f"{name}_high"]).sum())
    return {
        "quantity": name,
        "unit": MEASURED[name].unit,
        "count": len(known),
        "mean_residual": float(residual.mean()),
        "rms_residual": float(np.sqrt((residual**2).mean())),
        "inside_range": inside,
    }
