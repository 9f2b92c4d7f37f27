"""Separations on both sides of the root of the force balance F_t = F_s(d) + F_f(d) (Eq. 1).

A film whose thickness depends on F_f shares the load with the solids (Eqs. 7 and 8).  A film whose
thickness F_t sets keeps it, and the solids carry the rest, or all of it if they need a larger
separation.  Without a film the solids carry the load alone.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.core.balance import Points
from thirdbody.core.particles import separation_carrying

FILM_MARGIN = 1e-3  # a film thinner by this fraction certainly carries more than the load
# added to ln F_t*, so that the first separation lies below the root at nearly all points
SUMMIT_EXCESS, PARTICLE_EXCESS = 0.2, 0.002


class Brackets(NamedTuple):
    """Bracket [m] of the root of the force balance at each point.

    The root is between ``low`` and ``high``, near ``guess``; ``low`` is nan if there is none.
    Where a film whose thickness F_t sets (Eq. 8 as printed) is ``held``, every separation in the
    bracket is a solution.
    """

    guess: NDArray
    low: NDArray
    high: NDArray
    held: NDArray


def bracket(points: Points) -> Brackets:
    """Bracket the separation d >= 0 at which solids and film carry the load.

    If the film depends on F_f, it carries the load alone at d = R_x H_c(F_t), so the root is there
    or beyond.  If it depends on F_t, it keeps this separation unless the solids need a larger one.
    """
    film, rounding = points.film_separation()
    guess = np.maximum(first_separation(points), film)
    if points.shared_film is None:
        return _beyond_film_or_held(points, guess, film * (1.0 - rounding), film * (1.0 + rounding))
    return Brackets(
        guess=guess,
        low=film * (1.0 - FILM_MARGIN),
        high=_upper_bounds(points, guess),
        held=np.zeros(guess.shape, bool),
    )


def first_separation(points: Points) -> NDArray:
    """Approximate separation d [m] at which the solids alone carry the load.

    It is the larger of the separations for summits alone and for particles alone, at which the
    solids carry one to three times the load; less where it is 0.
    """
    summits, particles = points.contact.summits, points.contact.particles
    t = summits.first_separation(points.log_total + SUMMIT_EXCESS)
    guess = summits.offset + summits.deviation * t
    if particles is not None:
        log_area = points.log_total + PARTICLE_EXCESS - np.log(points.parameters.particle_pressure)
        guess = np.maximum(guess, separation_carrying(log_area, particles))
    return np.maximum(guess, 0.0)


def _upper_bounds(points, guess):
    """Upper bounds [m], at which summits, particles and film each carry far less than the load."""
    far = np.maximum(guess, points.contact.summits.offset)
    if points.contact.particles is not None:
        far = np.maximum(far, points.contact.particles.reach)
    return 2.0 * far + 10.0 * points.contact.summits.deviation


def _beyond_film_or_held(points, guess, film_low, film_high):
    """Brackets where the film keeps its separation, 0 when dry, unless the solids need more.

    Rounding leaves that separation between ``film_low`` and ``film_high``.  The forces at the guess
    decide this at most points, the forces at the film at the others.
    """
    high = _upper_bounds(points, guess)
    guess = np.maximum(guess, film_high)
    forces = points.forces(guess)
    beyond = forces.excess.value > forces.errors.noise
    low = np.where(beyond, guess, film_high)
    newton = guess - forces.excess.value / forces.excess.slope
    guess = np.where(beyond & (newton < high), newton, guess)
    held, has_root = np.zeros(guess.shape, bool), beyond.copy()
    unclear = np.flatnonzero(~beyond)
    if unclear.size:
        forces = points.take(unclear).forces(film_high[unclear])
        held[unclear] = (forces.excess.value < 0.0) & (points.film is not None)
        has_root[unclear] = forces.excess.value >= -forces.errors.noise
        has_root &= ~held
    return Brackets(
        guess=guess,
        low=np.where(held, film_low, np.where(has_root, low, np.nan)),
        high=np.where(held, film_high, np.where(has_root, high, np.nan)),
        held=held,
    )
