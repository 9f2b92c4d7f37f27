"""Loads at which a curve passes from one lubrication regime or contact mode to another.

At a separation d the loads of solids and film, and so L_s and A_sa,t*, depend on d alone.  A crossing
is found over d between two points of the curve, and its load follows from Eq. 1.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from thirdbody.curves.bracketing import bracketed_roots
from thirdbody.curves.turning_point import particle_ratio
from thirdbody.model.film import film_load
from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import has_particles
from thirdbody.model.regimes import BOUNDARY_LIMIT, FULL_FILM_LIMIT, PARTICLE_LIMIT, SURFACE_LIMIT
from thirdbody.solver.points import make_contact

LIMITS = (
    ("solid_load_fraction", BOUNDARY_LIMIT),
    ("solid_load_fraction", FULL_FILM_LIMIT),
    ("particle_contact_area_ratio", PARTICLE_LIMIT),
    ("particle_contact_area_ratio", SURFACE_LIMIT),
)


def transitions(
    separation: NDArray,
    values: Mapping[str, NDArray],
    conditions: NDArray,
    parameters: Parameters,
    rtol: float,
    limits: Sequence[tuple[str, float]] = LIMITS,
) -> tuple[NDArray, NDArray, NDArray, NDArray, NDArray]:
    """Find the loads at which L_s and A_sa,t* cross given levels.

    Parameters
    ----------
    separation : array, shape (loads, curves)
        Separations d [m] at increasing loads at which the curves are known.
    values : mapping
        The quantities that ``limits`` name, arrays of shape (loads, curves); nan where unknown.
    conditions : array, shape (4, curves)
        Viscosity [m2/s], particle diameter [m], roughness [m] and particle density [m-2].
    parameters : Parameters
        Inputs of the model.
    rtol : float
        Relative error asked for.
    limits : sequence of pairs
        ``solid_load_fraction`` or ``particle_contact_area_ratio`` and the level that it crosses; by
        default those between regimes and modes.

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
    excess = np.stack([values[quantity] - level for quantity, level in limits])
    above, known = excess > 0.0, np.isfinite(excess)
    change = known[:, :-1] & known[:, 1:] & (above[:, :-1] != above[:, 1:])
    limit, step, curve = np.nonzero(change)
    load, error = np.zeros((2, curve.size))
    quantity, level = (np.array(each)[limit] for each in zip(*limits, strict=True))
    three_body = has_particles(*conditions[1::2, curve])
    for some in (np.flatnonzero(three_body), np.flatnonzero(~three_body)):
        if some.size:
            ends = (separation[step[some] + after, curve[some]] for after in (0, 1))
            is_ratio = quantity[some] == "particle_contact_area_ratio"
            given = conditions[:, curve[some]], parameters, rtol
            load[some], error[some] = _crossings(*ends, is_ratio, level[some], *given)
    return limit, curve, load, error, above[limit, step + 1, curve]


@np.errstate(divide="ignore", invalid="ignore")  # no particle may touch
def _crossings(first, last, is_ratio, level, conditions, parameters, rtol):
    """F_t* [1] where A_sa,t* or L_s has its level between two separations [m], and bounds on errors."""
    viscosity, diameter, roughness, density = conditions
    solids = make_contact(diameter, roughness, density, parameters, rtol)

    def loads(d):
        solid = solids.log_solid_load(d)
        film, film_slope = film_load(d, viscosity, roughness, parameters)
        total = parameters.interpretation.film_load.total_load(np.exp(solid.value), film)  # Eq. 1
        return solid, total, np.maximum(np.abs(solid.slope), np.abs(film_slope))

    def excess(d):
        solid, total, _ = loads(d)
        return np.where(is_ratio, particle_ratio(solids, d), np.exp(solid.value) / total) - level

    at_first, at_last = excess(first), excess(last)
    outside = (at_first > 0.0) == (
        at_last > 0.0
    )  # within its error a point lies on the level itself
    nearest = np.where(np.abs(at_first) < np.abs(at_last), first, last)
    ends = (np.where(outside, nearest, end) for end in (first, last))
    d, width = bracketed_roots(excess, *ends, 0.1 * rtol * last)
    _, total, steepest = loads(d)
    return total, total * (steepest * width + rtol)
