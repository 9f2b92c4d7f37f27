"""Loads at which the lubrication regime or contact mode of a curve changes.

The loads of solids and film depend only on the separation d, and so do L_s and A_sa,t*.  The search
between two points of the curve is therefore a search for d.  Eq. 1 then gives the load.
"""

from collections.abc import Mapping
from itertools import product

import numpy as np
from numpy.typing import NDArray

from thirdbody.core import regimes
from thirdbody.core.bracketing import bracketed_roots
from thirdbody.core.contact import Contact
from thirdbody.core.names import PARTICLE_CONTACT_AREA_RATIO
from thirdbody.core.parameters import Parameters
from thirdbody.core.particles import has_particles
from thirdbody.core.turning_points import load_at, particle_ratio

# tolerance of d over that of the load: a relative change of d changes F_t* by more
SEPARATION_MARGIN = 0.01

LIMITS = [(quantity, level) for quantity, level, *_ in regimes.LIMITS]


def limit_crossings(
    separation: NDArray,
    values: Mapping[str, NDArray],
    conditions: NDArray,
    parameters: Parameters,
    rtol: float,
) -> tuple[NDArray, NDArray, NDArray, NDArray, NDArray]:
    """Find the loads at which L_s and A_sa,t* cross the ``LIMITS`` between regimes and modes.

    ``separation`` d [m] and ``values`` of the quantities have the shape (loads, curves), at
    increasing loads, nan where unknown.  ``conditions``, shape (4, curves), are viscosity, particle
    diameter, roughness and particle density in SI.  Returns for each crossing the index of the
    limit, the index of the curve, F_t* [1], a bound on its error [1], and whether the quantity
    increases with the load.
    """
    excess = np.stack([values[quantity] - level for quantity, level in LIMITS])
    above, solved = excess > 0.0, np.isfinite(excess)
    change = solved[:, :-1] & solved[:, 1:] & (above[:, :-1] != above[:, 1:])
    limit, step, curve = np.nonzero(change)
    load, error = np.zeros((2, curve.size))
    quantity, level = (np.array(column)[limit] for column in zip(*LIMITS, strict=True))
    is_ratio = quantity == PARTICLE_CONTACT_AREA_RATIO
    _, diameter, _, density = conditions[:, curve]
    is_three_body = has_particles(diameter, density)
    for of_ratio, three_body in product((False, True), repeat=2):
        chosen = np.flatnonzero((is_ratio == of_ratio) & (is_three_body == three_body))
        first, last = (separation[step[chosen] + after, curve[chosen]] for after in (0, 1))
        inputs = conditions[:, curve[chosen]], parameters, rtol
        if chosen.size:
            load[chosen], error[chosen] = _crossings(first, last, of_ratio, level[chosen], *inputs)
    return limit, curve, load, error, above[limit, step + 1, curve]


def _crossings(first, last, of_ratio, level, conditions, parameters, rtol):
    """F_t* [1] where A_sa,t*, or else L_s, crosses its level between two separations [m]."""
    viscosity, diameter, roughness, density = conditions
    solids = Contact.of(diameter, roughness, density, parameters, rtol)

    def excess(d):
        value = (
            particle_ratio(solids, d) if of_ratio else load_at(solids, viscosity, roughness, d)[1]
        )
        return value - level

    at_first, at_last = excess(first), excess(last)
    # A point closer to the level than its error may lie on the wrong side.  The crossing is then at
    # this point.
    outside = (at_first > 0.0) == (at_last > 0.0)
    nearest = np.where(np.abs(at_first) < np.abs(at_last), first, last)
    low, high = (np.where(outside, nearest, end) for end in (first, last))
    d, width = bracketed_roots(excess, low, high, SEPARATION_MARGIN * rtol * last)
    load, _, steepest = load_at(solids, viscosity, roughness, d)
    return load, load * (steepest * width + rtol)
