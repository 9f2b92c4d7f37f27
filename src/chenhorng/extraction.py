"""Extraction from curves of a dataset: turning points and transitions, as rows of tables."""

import numpy as np

from thirdbody.core.parameters import Parameters
from thirdbody.core.regimes import SOLUTION_STATUSES
from thirdbody.core.solve import solve_points
from thirdbody.core.transitions import LIMITS, limit_crossings
from thirdbody.core.turning_points import turning_points
from thirdbody.curves import Condition
from thirdbody.netcdf import PlainDataset, curves_of
from thirdbody.variables import STATUS

FOUND = ("load", "load_error", "peak_ratio", "solid_load_fraction")  # of a turning point


def tpca_rows(figure: str, dataset: PlainDataset, parameters: Parameters) -> list[dict]:
    """Rows of the table ``tpca_loads``, one per curve with a turning point, for the ``dataset`` of
    a ``figure`` solved with ``parameters``."""
    conditions, shown = curves_of(dataset)
    separation = dataset["separation"].values[:, shown]
    found = turning_points(separation, **Condition(*conditions)._asdict(), parameters=parameters)
    curves = np.flatnonzero(found.exists)
    columns = {name: getattr(found, name)[curves] for name in FOUND}
    columns["separation_m"] = found.separation[curves]
    return _rows(figure, conditions[:, curves], columns, dataset, parameters)


def transition_rows(figure: str, dataset: PlainDataset, parameters: Parameters) -> list[dict]:
    """Rows of the table ``transitions``, one per crossing of a regime or mode limit; arguments as
    in ``tpca_rows``."""
    conditions, shown = curves_of(dataset)
    rtol = float(dataset.attrs["rtol"])
    values = {quantity: dataset[quantity].values[:, shown] for quantity, _ in LIMITS}
    separation = dataset["separation"].values[:, shown]
    found = limit_crossings(separation, values, conditions, parameters, rtol)
    limits, curves, loads, errors, rising = found
    columns = {
        "quantity": [LIMITS[limit][0] for limit in limits],
        "level": [LIMITS[limit][1] for limit in limits],
        "direction": np.where(rising, "rising", "falling"),
        "load": loads,
        "load_error": errors,
    }
    return _rows(figure, conditions[:, curves], columns, dataset, parameters)


def _rows(figure, conditions, columns, dataset, parameters) -> list[dict]:
    """Rows of a table, each with the condition of its curve and the status of its point."""
    given = {"load": columns["load"]} | dict(zip(Condition._fields, conditions, strict=True))
    rtol = float(dataset.attrs["rtol"])
    status = solve_points(given, parameters, rtol, [STATUS])[STATUS]
    columns["normal_load_N"] = columns["load"] * parameters.newtons_per_load
    columns[STATUS] = [SOLUTION_STATUSES[index] for index in status]
    rows = zip(*columns.values(), strict=True)
    return [
        {"figure": figure, **Condition(*condition).columns, **dict(zip(columns, row))}
        for condition, row in zip(conditions.T, rows, strict=True)
    ]
