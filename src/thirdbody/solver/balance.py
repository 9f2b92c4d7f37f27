"""The balance of forces F_t = F_s(d) + F_f(d) (Eq. 1), solved for the separation d.

A separation is accepted only where the sum of forces changes its sign between two separations around
it, by more than rounding and tables may change it.  Both are kept: the values of all variables are
means of those at the two, and their differences bound the error.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.model.particles import EPSILON, separation_carrying
from thirdbody.solver.points import Forces, Points
from thirdbody.solver.several import enclose_largest, may_be_several

MAX_ITERATIONS = 200
THINNER = 1e-3  # a film thinner by so much carries more than the load for certain
CURVED = 0.05  # of the tolerance: what the next step of Newton's method may leave
NARROW = 4.0 * EPSILON  # relative width of the narrowest bracket
WIDER = 4.0  # by which an interval grows in which no change of sign is seen


class Brackets(NamedTuple):
    """Between which separations [m] the forces balance, at each of some points.

    They do so between ``low`` and ``high``, near ``guess``; ``low`` is nan where they do nowhere.  They are
    too large at ``low`` for certain where this is ``sure``.  Where a film whose thickness F_t sets
    (Eq. 8 as printed) is ``held``, any separation between both is right.  ``count`` says at how many
    separations the forces balance, of which the largest is meant, and ``certain`` whether rounding
    leaves no doubt of that.
    """

    guess: NDArray
    low: NDArray
    high: NDArray
    sure: NDArray
    held: NDArray
    count: NDArray
    certain: NDArray


class Balance(NamedTuple):
    """The ``forces`` at two separations between which they balance, of shape (2, points), and whether
    their change of sign is ``certain``; ``count`` is that of ``Brackets``."""

    forces: Forces
    certain: NDArray
    count: NDArray


def bracket(points: Points) -> Brackets:
    """Enclose the largest separation d >= 0 at which solids and film carry the load.

    A film of F_f carries the load by itself at d = R_x H_c(F_t), so the root is there or beyond.  A film
    of F_t keeps the surfaces at that separation, unless the solids need a larger one to carry F_t.
    Points that ``may_be_several`` must not have tables, whose errors may hide a separation.
    """
    guess = first_separation(points)
    alone, rounded = np.zeros((2, guess.size))
    if points.film is not None:
        alone, rounded = points.film_separation()
        guess = np.maximum(guess, alone)
    high = _too_high(points, guess)
    if points.shares_load:
        low = alone * (1.0 - THINNER)
        exists, held = np.ones(guess.shape, bool), np.zeros(guess.shape, bool)
        sure = exists.copy()
    else:
        low = alone * (1.0 + rounded)
        forces = points.forces(low)
        sure, exists = forces.excess > forces.noise, forces.excess >= -forces.noise
        held = (forces.excess < 0.0) & (points.film is not None)
        exists &= ~held
    count, certain = (exists | held).astype(int), np.ones(guess.shape, bool)
    several = np.flatnonzero(may_be_several(points))
    if several.size:
        some = points.take(several)
        near, far, number, undecided = enclose_largest(some, low[several], guess[several])
        beyond = number > 0
        # a film so thin that particles cover everything is no balance
        particles = some.contact.particles
        covered = particles.cover_all(particles.contact(low[several])[2])
        count[several] = (held[several] & ~covered) + number
        if points.film is not None and not points.shares_load:
            # along a plateau as high as the load nothing may be found beyond the film
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
    """About the separation d [m] at which the solids alone carry the load.

    It is the larger of those that summits alone and particles alone would have, where the solids
    carry between one and two times the load.
    """
    surfaces, particles = points.contact.summits, points.contact.particles
    guess = surfaces.offset + surfaces.deviation * surfaces.first_separation(points.log_load)
    if particles is not None:
        area = np.exp(points.log_load) / points.parameters.particle_pressure
        guess = np.maximum(guess, separation_carrying(area, particles))
    return np.maximum(guess, 0.0)


def _too_high(points, guess):
    """Separations [m] at which summits, particles and film each carry far less than the load."""
    far = np.maximum(guess, points.contact.summits.offset)
    if points.contact.particles is not None:
        far = np.maximum(far, points.contact.particles.reach)
    return 2.0 * far + 10.0 * points.contact.summits.deviation


def enclose(points: Points, brackets: Brackets, tolerance: float) -> Balance:
    """Narrow the brackets by Newton's method until no variable differs by more than ``tolerance``.

    Once a step should leave no error that counts, signs are looked at on either side; where rounding
    could hide them the interval is widened.
    """
    guess, low, high, sure, held, count, certain = brackets
    ends = np.full((len(Forces._fields), 2, guess.size), np.nan)
    fixed = np.flatnonzero(held)
    if fixed.size:
        film = points.take(fixed)
        ends[:, 0, fixed] = _beside_a_film(film.forces(low[fixed], with_areas=True))
        ends[:, 1, fixed] = _beside_a_film(film.forces(high[fixed], with_areas=True))
    certain = certain.copy()
    active = np.flatnonzero(~held & ~np.isnan(low))
    points = points.take(active)
    d, low, high, sure = guess[active], low[active], high[active], sure[active]
    last, doubt = high - low, np.ones(d.shape)
    for iteration in range(MAX_ITERATIONS):
        if not active.size:
            break
        forces = points.forces(d)
        size, steepness = np.abs(forces.excess), np.abs(forces.slope)
        more, less = forces.excess > forces.noise, forces.excess < -forces.noise
        low, high, sure = np.where(more, d, low), np.where(less, d, high), sure | more
        step = size / steepness
        new = d - forces.excess / forces.slope
        newton = (new >= low) & (new <= high) & (step <= np.maximum(0.5 * last, 1e-3 * d))
        change = step * forces.steepest
        left = change * change * (1.0 + forces.steepest / steepness)
        close = newton & ((left <= CURVED * tolerance) | (size <= 2.0 * forces.noise))
        final = (high - low <= NARROW * d) | (iteration == MAX_ITERATIONS - 1)
        d = np.where(newton, new, 0.5 * (low + high))
        last = np.where(newton, step, 0.5 * (high - low))
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
        # where a sign is wrong, the search goes on from there
        doubt[close] *= WIDER
        lower, higher = ~done & below[0], ~done & above[1]
        high[close[lower]], low[close[higher]], sure[close[higher]] = a[lower], b[higher], True
        d[close[lower]] = np.fmax(2.0 * a - b, low[close])[lower]
        d[close[higher]] = np.fmin(2.0 * b - a, high[close])[higher]
        kept = np.ones(d.size, bool)
        kept[close[done]] = False
        points, active = points.take(kept), active[kept]
        d, low, high, sure, last, doubt = (x[kept] for x in (d, low, high, sure, last, doubt))
    return Balance(Forces(*ends), certain, count)


def _beside_a_film(forces):
    """The forces where a film of known thickness, within rounding, takes what solids leave."""
    fluid = -np.expm1(np.minimum(forces.log_solid, 0.0))
    less = np.exp(forces.log_solid) / fluid  # F_s/F_f, by which rounding of F_s is magnified
    rounding = forces.rounding + forces.solid_noise * less
    return np.stack(forces._replace(log_fluid=np.log(fluid), rounding=rounding))
