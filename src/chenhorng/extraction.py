"""Turning points and transitions of the curves of a dataset, as rows of tables."""

import numpy as np

from thirdbody.core.parameters import Parameters
from thirdbody.core.regimes import SOLUTION_STATUSES
from thirdbody.core.solve import solve_points
from thirdbody.core.transitions import LIMITS, limit_crossings
from thirdbody.core.turning_points import turning_points
from thirdbody.curves import Condition
from thirdbody.netcdf import PlainDataset, curves_of
from thirdbody.variables import STATUS

FIELDS = ("load", "load_error", "peak_ratio", "solid_load_fraction")  # of ``TurningPoints``


def tpca_rows(figure: str, dataset: PlainDataset, parameters: Parameters) -> list[dict]:
    """Rows of the table ``tpca_loads`` from the ``dataset`` of a ``figure``, solved with
    ``parameters``: a row for each curve with a turning point."""
    conditions, shown = curves_of(dataset)
    separation = dataset["separation"].values[:, shown]
    points = turning_points(separation, **Condition(*conditions)._asdict(), parameters=parameters)
    curves = np.flatnonzero(points.exists)
    columns = {name: getattr(points, name)[curves] for name in FIELDS}
    columns["separation_m"] = points.separation[curves]
    return _rows(figure, conditions[:, curves], columns, dataset, parameters)


def transition_rows(figure: str, dataset: PlainDataset, parameters: Parameters) -> list[dict]:
    """Rows of the table ``transitions``: a row for each crossing of a limit of a regime or mode.
    The arguments are those of ``tpca_rows``."""
    conditions, shown = curves_of(dataset)
    rtol = float(dataset.attrs["rtol"])
    values = {quantity: dataset[quantity].values[:, shown] for quantity, _ in LIMITS}
    separation = dataset["separation"].values[:, shown]
    crossings = limit_crossings(separation, values, conditions, parameters, rtol)
    limits, curves, loads, errors, rising = crossings
    columns = {
        "quantity": [LIMITS[limit][0] for limit in limits],
        "level": [LIMITS[limit][1] for limit in limits],
        "direction": np.where(rising, "rising", "falling"),
        "load": loads,
        "load_error": errors,
    }
    return _rows(figure, conditions[:, curves], columns, dataset, parameters)


def _rows(figure, conditions, columns, dataset, parameters) -> list[dict]:
    """Rows of a table, with the condition of the curve and the status of the point."""
    points = {"load": columns["load"]} | dict(zip(Condition._fields, conditions, strict=True))
    rtol = float(dataset.attrs["rtol"])
    status = solve_points(points, parameters, rtol, [STATUS])[STATUS]
    columns["normal_load_N"] = columns["load"] * parameters.newtons_per_load
    columns[STATUS] = [SOLUTION_STATUSES[index] for index in status]
    rows = zip(*columns.values(), strict=True)
    return [
        {"figure": figure, **Condition(*condition).columns, **dict(zip(columns, row))}
        for condition, row in zip(conditions.T, rows, strict=True)
    ]
