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

FILM_MARGIN = 1e-3  # a film thinner by this fraction certainly carries more than the load
STEP_LEFT = 1.0  # of the tolerance: error expected, with a large margin, after the next Newton step
NARROW = 4.0 * EPSILON  # relative width of the narrowest bracket
# added to ln F_t*, so that the first separation lies below the root at nearly all points
SUMMIT_EXCESS, PARTICLE_EXCESS = 0.2, 0.002
GROWTH = 4.0  # growth of an interval whose signs rounding hides


class Brackets(NamedTuple):
    """Bracket [m] of the root of the force balance at each point.

    The root is between ``low`` and ``high``, near ``guess``; ``low`` is nan if there is none.
    Where a film whose thickness F_t sets (Eq. 8 as printed) is ``held``, every separation in the
    bracket is a solution.  ``count`` is the number of roots, of which the largest is bracketed, and
    ``certain`` whether this holds despite rounding.
    """

    guess: NDArray
    low: NDArray
    high: NDArray
    held: NDArray
    count: NDArray
    certain: NDArray


class Balance(NamedTuple):
    """The ``points`` in the order of ``places``, and the ``forces`` at two separations around the root
    of each, of shape (2, points).  ``certain`` is whether their sum changes its sign despite rounding,
    and ``count`` the number of roots."""

    points: Points
    places: NDArray
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
    exists, held = np.ones(guess.shape, bool), np.zeros(guess.shape, bool)
    low = start = alone * (1.0 - FILM_MARGIN)
    if not points.shares_load:
        start = alone * (1.0 + rounded)
        guess = np.maximum(guess, start)
        forces = points.forces(guess)
        exists = forces.excess > forces.noise
        low = np.where(exists, guess, start)
        newton = guess - forces.excess / forces.slope
        guess = np.where(exists & (newton < high), newton, guess)
    several = may_have_several(points)
    left = np.flatnonzero(~exists | several & ~points.shares_load)
    if left.size:
        forces = points.take(left).forces(start[left])
        exists[left] = forces.excess >= -forces.noise
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
        exists[several] = beyond
        certain[several] = ~undecided
        there = several[beyond]
        low[there], high[there] = near[beyond], far[beyond]
        guess[there] = 0.5 * (near + far)[beyond]
    low = np.where(held, alone * (1.0 - rounded), np.where(exists, low, np.nan))
    high = np.where(held, alone * (1.0 + rounded), np.where(exists, high, np.nan))
    return Brackets(guess, low, high, held, count, certain)


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


def enclose(points: Points, brackets: Brackets, tolerance: float, iterations: int) -> Balance:
    """Narrow the brackets by Newton's method until the variables converge to ``tolerance``.

    When the next step would converge, the signs on both sides of it are checked; if rounding could
    hide them, the interval is widened.  After so many ``iterations``, the rest is not ``certain``.
    """
    d, low, high, held, count, certain = brackets
    found = []  # indices of finished points, forces at both ends, and whether a sign changes
    fixed = np.flatnonzero(held | np.isnan(low))
    if fixed.size:
        both = _at_both(points, fixed, low[fixed], high[fixed])
        found.append((fixed, _held_by_film(both), np.ones(fixed.size, bool)))
    active = np.flatnonzero(~held & ~np.isnan(low))
    remaining = points.take(active)
    d, low, high = (x[active] for x in (d, low, high))
    last, doubt = np.full(d.shape, np.inf), np.ones(d.shape)
    for iteration in range(iterations):
        if not active.size:
            break
        forces = remaining.forces(d)
        noise, size, steepness = forces.noise, np.abs(forces.excess), np.abs(forces.slope)
        low = np.where(forces.excess > noise, d, low)
        high = np.where(forces.excess < -noise, d, high)
        new = d - forces.excess / forces.slope
        # Newton's step is taken while steps halve the excess; otherwise the bracket is halved
        settled = size <= 2.0 * noise
        newton = (new >= low) & (new <= high) & (settled | (size <= 0.5 * last))
        ratio = forces.steepest / steepness
        left = (size * ratio) ** 2 * (1.0 + ratio)
        close = newton & (settled | (left <= STEP_LEFT * tolerance))
        final = (high - low <= NARROW * d) | (iteration == iterations - 1)
        d = np.where(newton, new, 0.5 * (low + high))
        last = np.where(newton, size, np.inf)
        close = np.flatnonzero(close | final)
        if not close.size:
            continue
        width = np.maximum(tolerance / (8.0 * forces.steepest), 1.2 * noise / steepness)
        width = doubt * np.maximum(width, NARROW * d)
        a = np.where(final, low, np.fmax(d - width, low))[close]
        b = np.where(final, high, np.fmin(d + width, high))[close]
        both = _at_both(remaining, close, a, b)
        above, below = both.excess > both.noise, both.excess < -both.noise
        holds = above[0] & below[1]
        done = np.flatnonzero(holds | final[close])
        both = Forces(*(each.take(done, axis=1) for each in both))
        found.append((active[close[done]], both, holds[done]))
        kept = np.ones(d.size, bool)
        kept[close[done]] = False
        if done.size < close.size:  # where both signs are the same, iterate from there
            lower, higher = kept[close] & below[0], kept[close] & above[1]
            doubt[close[~(lower | higher)]] *= GROWTH
            high[close[lower]], low[close[higher]] = a[lower], b[higher]
            d[close[lower]] = np.fmax(2.0 * a - b, low[close])[lower]
            d[close[higher]] = np.fmin(2.0 * b - a, high[close])[higher]
        kept = np.flatnonzero(kept)
        remaining, active = remaining.take(kept), active[kept]
        d, low, high, last, doubt = (x[kept] for x in (d, low, high, last, doubt))
    places, forces, holds = zip(*found, strict=True)
    places = np.concatenate(places)
    forces = Forces(*(np.concatenate(each, axis=1) for each in zip(*forces, strict=True)))
    certain = certain[places] & np.concatenate(holds)
    return Balance(points.take(places), places, forces, certain, count[places])


def _at_both(points, chosen, low, high):
    """The forces of the ``chosen`` points at ``low`` and ``high``, of shape (2, chosen)."""
    forces = points.take(np.tile(chosen, 2)).forces(np.append(low, high), with_areas=True)
    return Forces(*(each.reshape(2, -1) for each in forces))


def _held_by_film(forces):
    """The forces where a film of known thickness carries the load that the solids leave."""
    fluid = -np.expm1(np.minimum(forces.log_solid, 0.0))
    less = np.exp(forces.log_solid) / fluid  # F_s/F_f, which magnifies the rounding of F_s
    rounding = forces.rounding + forces.solid_noise * less
    return forces._replace(log_fluid=np.log(fluid), rounding=rounding)
