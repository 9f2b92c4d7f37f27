"""The balance of forces F_t = F_s(d) + F_f(d) (Eq. 1), solved for the separation d.

A separation is accepted only where the sum of forces changes its sign between two separations around
it, by more than rounding and tables may change it.  Both are kept: the values of all variables are
means of those at the two, and their differences bound the error.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.model.particles import EPSILON, separation_bearing
from thirdbody.solver.points import Points
from thirdbody.solver.several import enclose_largest, may_be_several

MAX_ITERATIONS = 200
THINNER = 1e-3  # a film thinner by so much carries more than the load for certain
CURVED = 0.05  # of the tolerance: what the next step of Newton's method may leave
NARROW = 4.0 * EPSILON  # relative width of the narrowest bracket
WIDER = 4.0  # by which an interval grows in which no change of sign is seen


class Ends(NamedTuple):
    """The interface at both ends of the intervals in which forces balance, each of shape (2, points).

    Attributes
    ----------
    separation : array
        d [m].
    log_solid, log_fluid : array
        ln(F_s/F_t) and ln(F_f/F_t) [1].
    noise, rounding : array
        What rounding and tables may change in ``log_solid``, and in any part of loads and areas [1].
    area, log_beside : array
        A_sa/A_n and ln(A_ss-sa/A_n) [1].
    coverage : array
        That of the particles larger than d [1].
    solid_slope, area_slope : array
        d ln F_s/dd [m-1] and d(A_sa/A_n)/dd [m-1].
    """

    separation: NDArray
    log_solid: NDArray
    log_fluid: NDArray
    noise: NDArray
    rounding: NDArray
    area: NDArray
    log_beside: NDArray
    coverage: NDArray
    solid_slope: NDArray
    area_slope: NDArray


class Balance(NamedTuple):
    """Where the forces balance, at each of some points.

    Attributes
    ----------
    ends : Ends
        Two separations between which they do; nan where they do nowhere.
    certain : array of bool
        Whether the change of sign between them is beyond rounding.
    count : array of int
        At how many separations they balance, of which this is the largest.
    held : array of bool
        Whether the separation is that of a film whose thickness the load F_t sets (Eq. 8 as printed).
    """

    ends: Ends
    certain: NDArray
    count: NDArray
    held: NDArray


def balance_forces(points: Points, tolerance: float) -> Balance:
    """The largest separation d >= 0 at which solids and film carry the load.

    Parameters
    ----------
    points : Points
        Any points; those that ``may_be_several`` not by tables, whose errors may hide a separation.
    tolerance : float
        Relative error that is small enough in any variable.

    Returns
    -------
    Balance

    Notes
    -----
    A film of F_f carries the load by itself at d = R_x H_c(F_t), so the root is there or beyond.  A film
    of F_t keeps the surfaces at that separation, unless the solids need a larger one to carry F_t.
    """
    guess = first_separation(points)
    least, held = np.zeros(guess.shape), np.zeros(guess.shape, bool)
    if points.film is not None:
        alone, rounded = points.film_separation()
        guess = np.maximum(guess, alone)
        least = alone * (1.0 - THINNER if points.shares_load else 1.0 + rounded)
    if points.shares_load:
        exists = sure = ~held
    else:
        forces = points.forces(least)
        sure, exists = forces.excess > forces.noise, forces.excess >= -forces.noise
        if points.film is not None:
            held = forces.excess < 0.0
            exists = ~held
    certain, count = np.ones(guess.shape, bool), (exists | held).astype(int)
    high = _too_high(points, guess)
    brackets = np.stack([guess, least, high])
    several = np.flatnonzero(may_be_several(points))
    if several.size:
        some = points.take(several)
        found = enclose_largest(some, least[several], guess[several])
        beyond = found.count > 0
        # a film so thin that particles cover everything is no balance
        count[several] = (held[several] & ~_are_covered(some, least[several])) + found.count
        if points.film is not None and not points.shares_load:
            # along a plateau as high as the load nothing may be found beyond the film
            held[several] = ~beyond & (held[several] | found.undecided)
            count[several] = np.maximum(count[several], found.undecided)
        exists[several], sure[several] = beyond, True
        certain[several] = ~found.undecided
        middle = 0.5 * (found.low + found.high)
        brackets[:, several[beyond]] = np.stack([middle, found.low, found.high])[:, beyond]
    ends = np.full((len(Ends._fields), 2, guess.size), np.nan)
    seek = np.flatnonzero(exists)
    if seek.size:
        some = points if seek.size == exists.size else points.take(seek)
        ends[..., seek], enclosed = _enclose(some, *brackets[:, seek], sure[seek], tolerance)
        certain[seek] &= enclosed
    if held.any():
        thin, thick = alone[held] * (1.0 - rounded[held]), least[held]
        ends[..., held] = _held_ends(points.take(held), thin, thick)
    return Balance(Ends(*ends), certain, count, held)


def first_separation(points: Points) -> NDArray:
    """About the separation d [m] at which the solids alone carry the load.

    It is the larger of those that summits alone and particles alone would have, where the solids
    carry between one and two times the load.
    """
    surfaces, particles = points.surfaces, points.contact.particles
    guess = surfaces.offset + surfaces.deviation * surfaces.first_separation(points.log_load)
    if particles is not None:
        area = np.exp(points.log_load) / points.parameters.particle_pressure
        guess = np.maximum(guess, separation_bearing(area, particles))
    return np.maximum(guess, 0.0)


def _too_high(points, guess):
    """Separations [m] at which summits, particles and film each carry far less than the load."""
    far = np.maximum(guess, points.surfaces.offset)
    if points.contact.particles is not None:
        far = np.maximum(far, points.contact.particles.reach)
    return 2.0 * far + 10.0 * points.surfaces.deviation


def _are_covered(points, separation):
    """Whether particles leave no room between them at a ``separation`` [m]."""
    particles = points.contact.particles
    return particles.leave_no_room(particles.contact(separation)[2])


def _enclose(points, guess, low, high, sure, tolerance):
    """Ends of intervals in which the forces balance, and whether that is certain.

    Newton's method within a bracket.  Forces are too small at ``high``; at ``low`` they are too large if
    that is ``sure``.  Once a step should leave no error that counts, signs are looked at on either
    side; where rounding could hide them the interval is widened.
    """
    ends, certain = np.full((len(Ends._fields), 2, guess.size), np.nan), np.zeros(guess.shape, bool)
    active, last, doubt = np.arange(guess.size), high - low, np.ones(guess.shape)
    d = guess
    for iteration in range(MAX_ITERATIONS):
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
        narrow = high - low <= NARROW * d
        d, last = (
            np.where(newton, new, 0.5 * (low + high)),
            np.where(newton, step, 0.5 * (high - low)),
        )
        final = narrow | (iteration == MAX_ITERATIONS - 1)
        (close,) = np.nonzero(close | final)
        if not close.size:
            continue
        width = np.maximum(tolerance / (8.0 * forces.steepest), 1.2 * forces.noise / steepness)
        width = doubt * np.maximum(width, NARROW * d)
        a = np.where(final, low, np.fmax(d - width, low))[close]
        b = np.where(final, high, np.fmin(d + width, high))[close]
        some = points if close.size == d.size else points.take(close)
        above, below = some.forces(a, True), some.forces(b, True)
        holds = (above.excess > above.noise) | (sure[close] & (a == low[close]))
        holds &= (below.excess < -below.noise) | (b == high[close])
        done = holds | final[close]
        finished = active[close[done]]
        ends[:, 0, finished] = _ends_at(some, a, above)[:, done]
        ends[:, 1, finished] = _ends_at(some, b, below)[:, done]
        certain[finished] = holds[done]
        kept = np.ones(d.size, bool)
        kept[close[done]] = False
        if not kept.any():
            break
        # where a sign is wrong, the search goes on from there
        doubt[close] *= WIDER
        lower, higher = ~done & (above.excess < -above.noise), ~done & (below.excess > below.noise)
        high[close[lower]], low[close[higher]], sure[close[higher]] = a[lower], b[higher], True
        d[close[lower]] = np.fmax(2.0 * a - b, low[close])[lower]
        d[close[higher]] = np.fmin(2.0 * b - a, high[close])[higher]
        points = points.take(kept)
        active, d, low, high, sure, last, doubt = (
            each[kept] for each in (active, d, low, high, sure, last, doubt)
        )
    return ends, certain


def _ends_at(points, separation, forces):
    """Rows of ``Ends`` at one separation each."""
    area, log_beside = points.contact.areas(separation, forces.solids)
    touching = forces.solids.touching
    _, area_slope, coverage, _ = np.zeros((4, area.size)) if touching is None else touching
    return np.stack(
        [
            separation,
            forces.log_solid,
            forces.log_fluid,
            forces.solid_noise,
            forces.rounding,
            area,
            log_beside,
            coverage,
            forces.solids.slope,
            area_slope,
        ]
    )


def _held_ends(points, thin, thick):
    """Rows of ``Ends`` where a film of known thickness, within rounding, takes what solids leave."""
    both = []
    for separation in (thin, thick):
        forces = points.forces(separation, True)
        fluid = -np.expm1(np.minimum(forces.log_solid, 0.0))
        less = np.exp(forces.log_solid) / fluid  # F_s/F_f, by which rounding of F_s is magnified
        forces = forces._replace(
            log_fluid=np.log(fluid), rounding=forces.rounding + forces.solid_noise * less
        )
        both.append(_ends_at(points, separation, forces))
    return np.stack(both, axis=1)
