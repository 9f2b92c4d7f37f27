"""Loads at which a curve passes from one lubrication regime or contact mode to another."""

from __future__ import annotations

import numpy as np

from thirdbody.bracketing import bracketed_roots
from thirdbody.interface import solve
from thirdbody.parameters import Parameters
from thirdbody.regimes import BOUNDARY_LIMIT, FULL_FILM_LIMIT, PARTICLE_LIMIT, SURFACE_LIMIT

LIMITS = (
    ("solid_load_fraction", BOUNDARY_LIMIT),
    ("solid_load_fraction", FULL_FILM_LIMIT),
    ("particle_contact_area_ratio", PARTICLE_LIMIT),
    ("particle_contact_area_ratio", SURFACE_LIMIT),
)


def transitions(load, values, conditions, quantity, level, parameters: Parameters, rtol: float):
    """Loads F_t* [1] at which ``quantity`` crosses ``level`` on each curve.

    ``load`` has shape (loads,), ``values`` of the quantity (loads, curves), ``conditions``
    (4, curves): viscosity, diameter, roughness, density (SI).  Returns arrays of one length: the
    curve's index, the load, a bound on its error, and whether the quantity rises there.
    """
    above = values > level
    known = np.isfinite(values)
    step, curve = np.nonzero(known[:-1] & known[1:] & (above[:-1] != above[1:]))
    if curve.size == 0:
        return curve, np.zeros(0), np.zeros(0), np.zeros(0, dtype=bool)

    def excess(log_load):
        solution = solve(np.exp(log_load), *conditions[:, curve], parameters, rtol, [quantity])
        return getattr(solution, quantity) - level

    ends = np.log(load[step]), np.log(load[step + 1])
    root, width = bracketed_roots(excess, *ends, 0.1 * rtol)
    crossing = np.exp(root)
    return curve, crossing, crossing * (width + rtol), above[step + 1, curve]
