"""What the curves of a dataset hold: turning points and transitions, as rows of tables."""

from __future__ import annotations

import numpy as np

from thirdbody.curves.transitions import LIMITS, transitions
from thirdbody.curves.turning_point import turning_points
from thirdbody.data.conditions import Condition
from thirdbody.data.plain import PlainDataset
from thirdbody.data.quantities import STATUS, curves_of
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import SOLUTION_STATUSES
from thirdbody.solver.solve import solve_arrays

FOUND = ("load", "load_error", "peak_ratio", "solid_load_fraction")  # of a turning point


def tpca_rows(figure: str, dataset: PlainDataset, parameters: Parameters) -> list[dict]:
    """Rows of the table ``tpca_loads``, one a curve that has a turning point, of the ``dataset`` of a
    ``figure`` that was solved with ``parameters``."""
    conditions, shown = curves_of(dataset)
    found = turning_points(dataset["separation"].values[:, shown], *conditions, parameters)
    curves = np.flatnonzero(found.exists)
    statuses = _statuses(found.load[curves], conditions[:, curves], dataset, parameters)
    return [
        {
            **_place(figure, conditions[:, curve]),
            **{name: getattr(found, name)[curve] for name in FOUND},
            "separation_m": found.separation[curve],
            STATUS: status,
        }
        for curve, status in zip(curves, statuses, strict=True)
    ]


def transition_rows(figure: str, dataset: PlainDataset, parameters: Parameters) -> list[dict]:
    """Rows of the table ``transitions``, one a crossing of a regime or mode limit; arguments as of
    ``tpca_rows``."""
    conditions, shown = curves_of(dataset)
    rtol = float(dataset.attrs["rtol"])
    values = {quantity: dataset[quantity].values[:, shown] for quantity, _ in LIMITS}
    separation = dataset["separation"].values[:, shown]
    crossings = transitions(separation, values, conditions, parameters, rtol)
    _, curves, loads, *_ = crossings
    statuses = _statuses(loads, conditions[:, curves], dataset, parameters)
    return [
        {
            **_place(figure, conditions[:, curve]),
            "quantity": LIMITS[limit][0],
            "level": LIMITS[limit][1],
            "direction": "rising" if rising else "falling",
            "load": load,
            "load_error": error,
            STATUS: status,
        }
        for (limit, curve, load, error, rising), status in zip(
            zip(*crossings, strict=True), statuses, strict=True
        )
    ]


def _statuses(load, conditions, dataset, parameters) -> list[str]:
    """Statuses of points, by name: their loads F_t*, and ``conditions`` as of ``curves_of``."""
    given = {"load": load} | dict(zip(Condition._fields, conditions, strict=True))
    rtol = float(dataset.attrs["rtol"])
    status = solve_arrays(given, parameters, rtol, [STATUS]).solution_status
    return [SOLUTION_STATUSES[index] for index in status]


def _place(figure: str, values) -> dict:
    return {"figure": figure} | Condition(*values).columns
