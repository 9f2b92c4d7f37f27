"""Loads at which a curve passes from one lubrication regime or contact mode to another."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from thirdbody.curves.crossings import level_roots
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import BOUNDARY_LIMIT, FULL_FILM_LIMIT, PARTICLE_LIMIT, SURFACE_LIMIT

LIMITS = (
    ("solid_load_fraction", BOUNDARY_LIMIT),
    ("solid_load_fraction", FULL_FILM_LIMIT),
    ("particle_contact_area_ratio", PARTICLE_LIMIT),
    ("particle_contact_area_ratio", SURFACE_LIMIT),
)


def transitions(
    load: NDArray,
    values: Mapping[str, NDArray],
    conditions: NDArray,
    parameters: Parameters,
    rtol: float,
    limits: Sequence[tuple[str, float]] = LIMITS,
) -> tuple[NDArray, NDArray, NDArray, NDArray, NDArray]:
    """Find the loads at which quantities cross given levels.

    Parameters
    ----------
    load : array, shape (loads,)
        Increasing loads F_t* [1] at which the curves are known.
    values : mapping
        The quantities that ``limits`` name, arrays of shape (loads, curves).
    conditions : array, shape (4, curves)
        Viscosity [m2/s], particle diameter [m], roughness [m] and particle density [m-2].
    parameters : Parameters
        Inputs of the model.
    rtol : float
        Relative error asked for.
    limits : sequence of pairs
        A quantity and the level that it crosses; by default those between regimes and modes.

    Returns
    -------
    limit, curve : array of int, shape (crossings,)
        Index of the limit and of the curve.
    load : array
        F_t* there [1].
    error : array
        Bound on the error of this load [1].
    rises : array of bool
        Whether the quantity rises with the load there.
    """
    quantities, levels = zip(*limits, strict=True)
    excess = np.stack([values[quantity] - level for quantity, level in limits])
    above, known = excess > 0.0, np.isfinite(excess)
    change = known[:, :-1] & known[:, 1:] & (above[:, :-1] != above[:, 1:])
    limit, step, curve = np.nonzero(change)
    if curve.size == 0:
        return limit, curve, np.zeros(0), np.zeros(0), np.zeros(0, dtype=bool)

    names = "viscosity", "particle_diameter", "roughness", "particle_density"
    given = dict(zip(names, conditions[:, curve], strict=True))
    passed = quantities, limit, np.array(levels)[limit]
    ends = np.log(load[step]), np.log(load[step + 1])
    root, width = level_roots("load", ends, *passed, given, parameters, rtol)
    crossing = np.exp(root)
    return limit, curve, crossing, crossing * (width + rtol), above[limit, step + 1, curve]
