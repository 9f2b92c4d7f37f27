"""The force balance F_t = F_s(d) + F_f(d) (Eq. 1), solved for the separation d.

A root is accepted only if the sum of forces changes sign between two separations around it, by more
than rounding and table errors.  All variables are means of their values at these two, and the
differences bound the error.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.model.particles import EPSILON, separation_carrying
from thirdbody.solver.points import Forces, Points
from thirdbody.solver.several import bracket_largest, may_have_several

MAX_ITERATIONS = 200
FILM_MARGIN = 1e-3  # a film thinner by this fraction certainly carries more than the load
STEP_LEFT = 0.05  # of the tolerance: error allowed after the next Newton step
NARROW = 4.0 * EPSILON  # relative width of the narrowest bracket
# added to ln F_t*, so that the first separation lies below the root at nearly all points
SUMMIT_EXCESS, PARTICLE_EXCESS = 0.2, 0.002
GROWTH = 4.0  # growth of an interval without a change of sign


class Brackets(NamedTuple):
    """Bracket [m] of the root of the force balance at each point.

    The root is between ``low`` and ``high``, near ``guess``; ``low`` is nan if there is none.
    ``sure`` means that the forces at ``low`` are certainly too large.  Where a film whose thickness
    F_t sets (Eq. 8 as printed) is ``held``, every separation in the bracket is a solution.
    ``count`` is the number of roots, of which the largest is bracketed, and ``certain`` whether
    this holds despite rounding.
    """

    guess: NDArray
    low: NDArray
    high: NDArray
    sure: NDArray
    held: NDArray
    count: NDArray
    certain: NDArray


class Balance(NamedTuple):
    """The ``forces`` at two separations around the root, of shape (2, points), and whether their
    change of sign is ``certain``; ``count`` is the number of roots."""

    forces: Forces
    certain: NDArray
    count: NDArray


def bracket(points: Points) -> Brackets:
    """Bracket the largest separation d >= 0 at which solids and film carry the load.

    If the film depends on F_f, it carries the load alone at d = R_x H_c(F_t), so the root is there
    or beyond.  If it depends on F_t, it keeps this separation unless the solids need a larger one,
    which the forces at the first separation show at most points.
    Points that ``may_have_several`` roots must not use tables, whose errors may hide a root.
    """
    guess = first_separation(points)
    alone, rounded = np.zeros((2, guess.size))
    if points.film is not None:
        alone, rounded = points.film_separation()
        guess = np.maximum(guess, alone)
    high = _upper_bounds(points, guess)
    sure, held = np.ones(guess.shape, bool), np.zeros(guess.shape, bool)
    low = start = alone * (1.0 - FILM_MARGIN)
    if not points.shares_load:
        start = alone * (1.0 + rounded)
        guess = np.maximum(guess, start)
        forces = points.forces(guess)
        sure = forces.excess > forces.noise
        low = np.where(sure, guess, start)
        newton = guess - forces.excess / forces.slope
        guess = np.where(sure & (newton < high), newton, guess)
    exists, several = sure.copy(), may_have_several(points)
    left = np.flatnonzero(~sure | several & ~points.shares_load)
    if left.size:
        forces = points.take(left).forces(start[left])
        sure[left], exists[left] = forces.excess > forces.noise, forces.excess >= -forces.noise
        held[left] = (forces.excess < 0.0) & (points.film is not None)
        exists &= ~held
    count, certain = (exists | held).astype(int), np.ones(guess.shape, bool)
    several = np.flatnonzero(several)
    if several.size:
        some = points.take(several)
        near, far, number, undecided = bracket_largest(some, start[several], guess[several])
        beyond = number > 0
        # no root where particles cover everything at the film thickness
        particles = some.contact.particles
        covered = particles.cover_all(particles.contact(start[several])[2])
        count[several] = (held[several] & ~covered) + number
        if points.film is not None and not points.shares_load:
            # on a plateau at the load, no root may be found beyond the film
            held[several] = ~beyond & (held[several] | undecided)
            count[several] = np.maximum(count[several], undecided)
        exists[several], sure[several] = beyond, True
        certain[several] = ~undecided
        there = several[beyond]
        low[there], high[there] = near[beyond], far[beyond]
        guess[there] = 0.5 * (near + far)[beyond]
    low = np.where(held, alone * (1.0 - rounded), np.where(exists, low, np.nan))
    high = np.where(held, alone * (1.0 + rounded), high)
    return Brackets(guess, low, high, sure, held, count, certain)


def first_separation(points: Points) -> NDArray:
    """Approximate separation d [m] at which the solids alone carry the load.

    It is the larger of the separations for summits alone and for particles alone, at which the
    solids carry one to three times the load.
    """
    surfaces, particles = points.contact.summits, points.contact.particles
    t = surfaces.first_separation(points.log_load + SUMMIT_EXCESS)
    guess = surfaces.offset + surfaces.deviation * t
    if particles is not None:
        log_area = points.log_load + PARTICLE_EXCESS - np.log(points.parameters.particle_pressure)
        guess = np.maximum(guess, separation_carrying(log_area, particles))
    return np.maximum(guess, 0.0)


def _upper_bounds(points, guess):
    """Upper bounds [m], at which summits, particles and film each carry far less than the load."""
    far = np.maximum(guess, points.contact.summits.offset)
    if points.contact.particles is not None:
        far = np.maximum(far, points.contact.particles.reach)
    return 2.0 * far + 10.0 * points.contact.summits.deviation


def enclose(points: Points, brackets: Brackets, tolerance: float) -> Balance:
    """Narrow the brackets by Newton's method until the variables converge to ``tolerance``.

    When the next step would converge, the signs on both sides of it are checked; if rounding could
    hide them, the interval is widened.
    """
    guess, low, high, sure, held, count, certain = brackets
    ends = np.full((len(Forces._fields), 2, guess.size), np.nan)
    fixed = np.flatnonzero(held)
    if fixed.size:
        film = points.take(fixed)
        ends[:, 0, fixed] = _held_by_film(film.forces(low[fixed], with_areas=True))
        ends[:, 1, fixed] = _held_by_film(film.forces(high[fixed], with_areas=True))
    certain = certain.copy()
    active = np.flatnonzero(~held & ~np.isnan(low))
    points = points.take(active)
    d, low, high, sure = guess[active], low[active], high[active], sure[active]
    last, doubt = np.full(d.shape, np.inf), np.ones(d.shape)
    for iteration in range(MAX_ITERATIONS):
        if not active.size:
            break
        forces = points.forces(d)
        size, steepness = np.abs(forces.excess), np.abs(forces.slope)
        more, less = forces.excess > forces.noise, forces.excess < -forces.noise
        low, high, sure = np.where(more, d, low), np.where(less, d, high), sure | more
        step = size / steepness
        new = d - forces.excess / forces.slope
        # Newton's step is taken while steps halve the excess; otherwise the bracket is halved
        halved = size <= np.maximum(0.5 * last, 2.0 * forces.noise)
        newton = (new >= low) & (new <= high) & halved
        change = step * forces.steepest
        left = change * change * (1.0 + forces.steepest / steepness)
        close = newton & ((left <= STEP_LEFT * tolerance) | (size <= 2.0 * forces.noise))
        final = (high - low <= NARROW * d) | (iteration == MAX_ITERATIONS - 1)
        d = np.where(newton, new, 0.5 * (low + high))
        last = np.where(newton, size, np.inf)
        (close,) = np.nonzero(close | final)
        if not close.size:
            continue
        width = np.maximum(tolerance / (8.0 * forces.steepest), 1.2 * forces.noise / steepness)
        width = doubt * np.maximum(width, NARROW * d)
        a = np.where(final, low, np.fmax(d - width, low))[close]
        b = np.where(final, high, np.fmin(d + width, high))[close]
        both = points.take(np.tile(close, 2)).forces(np.append(a, b), with_areas=True)
        both = Forces(*(each.reshape(2, -1) for each in both))
        above, below = both.excess > both.noise, both.excess < -both.noise
        holds = (above[0] | (sure[close] & (a == low[close]))) & (below[1] | (b == high[close]))
        done = holds | final[close]
        finished = active[close[done]]
        for end, each in zip(ends, both, strict=True):
            end[0][finished], end[1][finished] = each[0][done], each[1][done]
        certain[finished] &= holds[done]
        # where a sign is wrong, iterate from there
        doubt[close] *= GROWTH
        lower, higher = ~done & below[0], ~done & above[1]
        high[close[lower]], low[close[higher]], sure[close[higher]] = a[lower], b[higher], True
        d[close[lower]] = np.fmax(2.0 * a - b, low[close])[lower]
        d[close[higher]] = np.fmin(2.0 * b - a, high[close])[higher]
        kept = np.ones(d.size, bool)
        kept[close[done]] = False
        points, active = points.take(kept), active[kept]
        d, low, high, sure, last, doubt = (x[kept] for x in (d, low, high, sure, last, doubt))
    return Balance(Forces(*ends), certain, count)


def _held_by_film(forces):
    """The forces where a film of known thickness carries the load that the solids leave."""
    fluid = -np.expm1(np.minimum(forces.log_solid, 0.0))
    less = np.exp(forces.log_solid) / fluid  # F_s/F_f, which magnifies the rounding of F_s
    rounding = forces.rounding + forces.solid_noise * less
    return np.stack(forces._replace(log_fluid=np.log(fluid), rounding=rounding))
