"""What the curves of a dataset hold: turning points and transitions, as rows of tables."""

from __future__ import annotations

import numpy as np
import xarray as xr

from thirdbody.curves.transitions import LIMITS, transitions
from thirdbody.curves.turning_point import turning_points
from thirdbody.data.scene import DIMENSIONS
from thirdbody.model.parameters import Parameters

CONDITION_COLUMNS = (
    "viscosity_m2_per_s",
    "particle_diameter_m",
    "roughness_m",
    "particle_density_per_m2",
)


def curves_of(dataset: xr.Dataset):
    """Conditions (4, curves) and the index of the curves that a dataset shows.

    A curve is shown where any of its points has a status.
    """
    shown = np.isfinite(dataset["solution_status"].values).any(axis=0)
    axes = [dataset[name].values for name in DIMENSIONS[1:]]
    conditions = np.stack([grid[shown] for grid in np.meshgrid(*axes, indexing="ij")])
    return conditions, shown


def tpca_rows(figure: str, dataset: xr.Dataset, parameters: Parameters) -> list[dict]:
    """Rows of the table ``tpca_loads``: one a curve that has a turning point."""
    conditions, shown = curves_of(dataset)
    found = turning_points(dataset["separation"].values[:, shown], *conditions, parameters)
    return [
        {
            **_condition(figure, conditions[:, curve]),
            "load": found.load[curve],
            "load_error": found.load_error[curve],
            "peak_ratio": found.peak_ratio[curve],
            "solid_load_fraction": found.solid_load_fraction[curve],
            "separation_m": found.separation[curve],
        }
        for curve in np.flatnonzero(np.isfinite(found.load))
    ]


def transition_rows(figure: str, dataset: xr.Dataset, parameters: Parameters) -> list[dict]:
    """Rows of the table ``transitions``: one a crossing of a regime or mode limit."""
    conditions, shown = curves_of(dataset)
    rtol = float(dataset.attrs["rtol"])
    values = {quantity: dataset[quantity].values[:, shown] for quantity, _ in LIMITS}
    crossings = transitions(dataset["load"].values, values, conditions, parameters, rtol)
    return [
        {
            **_condition(figure, conditions[:, curve]),
            "quantity": LIMITS[limit][0],
            "level": LIMITS[limit][1],
            "direction": "rising" if rising else "falling",
            "load": load,
            "load_error": error,
        }
        for limit, curve, load, error, rising in zip(*crossings, strict=True)
    ]


def _condition(figure: str, values) -> dict:
    return {"figure": figure} | dict(zip(CONDITION_COLUMNS, values, strict=True))
