"""Loads at which a curve passes from one lubrication regime or contact mode to another."""

from __future__ import annotations

import numpy as np

from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import BOUNDARY_LIMIT, FULL_FILM_LIMIT, PARTICLE_LIMIT, SURFACE_LIMIT
from thirdbody.solver.bracketing import bracketed_roots
from thirdbody.solver.solve import solve

LIMITS = (
    ("solid_load_fraction", BOUNDARY_LIMIT),
    ("solid_load_fraction", FULL_FILM_LIMIT),
    ("particle_contact_area_ratio", PARTICLE_LIMIT),
    ("particle_contact_area_ratio", SURFACE_LIMIT),
)


def transitions(load, values, conditions, parameters: Parameters, rtol: float, limits=LIMITS):
    """Loads F_t* [1] at which quantities cross ``limits``, pairs of a quantity and its level.

    ``load`` has shape (loads,), ``values`` of each quantity (loads, curves), ``conditions``
    (4, curves): viscosity, diameter, roughness, density (SI).  Returns arrays of one length: the
    index of the limit and of the curve, the load, a bound on its error, and whether the quantity
    rises there.
    """
    quantities, levels = zip(*limits, strict=True)
    excess = np.stack([values[quantity] - level for quantity, level in limits])
    above, known = excess > 0.0, np.isfinite(excess)
    change = known[:, :-1] & known[:, 1:] & (above[:, :-1] != above[:, 1:])
    limit, step, curve = np.nonzero(change)
    if curve.size == 0:
        return limit, curve, np.zeros(0), np.zeros(0), np.zeros(0, dtype=bool)

    def excess_at(log_load):
        wanted = set(quantities)
        solution = solve(np.exp(log_load), *conditions[:, curve], parameters, rtol, wanted)
        found = np.stack([getattr(solution, quantity) for quantity in quantities])
        return found[limit, np.arange(limit.size)] - np.take(levels, limit)

    ends = np.log(load[step]), np.log(load[step + 1])
    root, width = bracketed_roots(excess_at, *ends, 0.1 * rtol)
    crossing = np.exp(root)
    return limit, curve, crossing, crossing * (width + rtol), above[limit, step + 1, curve]
