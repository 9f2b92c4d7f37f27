"""The stages of the compiled loop: each evaluates equations at all points of a block.

All take the ``block`` of points, the ``count`` of points that are left in its first columns, and
what they need of the ``Model``; what they say they find goes to the rows of that name, and
``layout`` describes the rows.  Their loops over k, which counts points, have no branches and look
nothing up but pieces of tables: so the compiler turns them into instructions for many numbers at
once.  A name with _1 is a slope, one with _2 half of a second derivative.
"""

from __future__ import annotations

import numpy as np

from thirdbody.model.particles import LOWEST
from thirdbody.solver.compiled.layout import (
    BARE,
    BOUND,
    COVERED,
    CROSSING_ROOT,
    CURVE,
    ELASTIC_MOMENT,
    ELASTIC_POSITION,
    ELASTIC_SHIFT,
    ERROR,
    FILM,
    FILM_ERROR,
    FILM_GAP,
    FLUID_SHARE,
    GAP,
    HALF_PIECES,
    LOAD_ERROR,
    LOCAL,
    MEAN,
    MOMENT,
    OFFSET,
    PART_ERROR,
    PARTICLE_SHARE,
    PER_CROSSING,
    PER_DEVIATION,
    PER_LOAD,
    PER_SPREAD,
    PLASTIC_AREA,
    POSITION,
    REMAINDER,
    SEPARATION,
    SLOPE,
    SLOPE_ERROR,
    SOLID,
    SOLID_SHARE,
    STEEPEST,
    STEP,
    SUMMIT_AREA,
    SUMMIT_PARAMETER,
    SUMMITS,
    SURFACE_SHARE,
    TOTAL_AREA,
    TOUCHING,
    UNSURE,
    VALUE,
)
from thirdbody.solver.compiled.lookup import (
    find_octave_piece,
    find_piece,
    look_up,
    look_up_guess,
    look_up_summits,
    power,
    relative_terms,
)
from thirdbody.solver.compiled.machine_code import stage

PLAIN = 1e-30  # an area A_t* in which one of zero in float64 has no share


@stage
def start(block, count, model, has_particles, has_film, film_is_known):
    """First guess: the largest of the separations at which one body would bear the load alone."""
    given, work = block.given, block.work
    one = work.dtype.type(1)
    for k in range(count):
        work[POSITION, k] = one / (given[PER_LOAD, k] * given[SUMMIT_PARAMETER, k])
    look_up_guess(block, count, model.summits.alone, POSITION)
    for k in range(count):
        work[SEPARATION, k] = given[OFFSET, k] + work[LOCAL, k] / given[PER_DEVIATION, k]
    if has_film:
        for k in range(count):
            work[POSITION, k] = given[CROSSING_ROOT, k]
        look_up_guess(block, count, model.film.alone, POSITION)
        for k in range(count):
            separation = work[LOCAL, k] / given[PER_CROSSING, k]
            work[SEPARATION, k] = max(work[SEPARATION, k], separation)
    if has_particles:
        pressure, of_all = model.particles.pressure, model.particles.of_all
        nowhere = work.dtype.type(-np.inf)  # of a load that all particles together do not bear
        for k in range(count):
            bears = given[PER_LOAD, k] * pressure * given[PLASTIC_AREA, k]
            work[POSITION, k] = model.particles.bears_here / bears
            work[ELASTIC_POSITION, k] = model.particles.bears_there / bears
        look_up_guess(block, count, model.particles.alone, POSITION)
        for k in range(count):
            alpha = work[LOCAL, k] if work[POSITION, k] <= of_all else nowhere
            separation = given[MEAN, k] + alpha / given[PER_SPREAD, k]
            work[SEPARATION, k] = max(work[SEPARATION, k], separation)
        look_up_guess(block, count, model.particles.alone, ELASTIC_POSITION)
        for k in range(count):
            alpha = work[LOCAL, k] if work[ELASTIC_POSITION, k] <= of_all else nowhere
            alpha = alpha - given[ELASTIC_SHIFT, k]
            separation = given[MEAN, k] + alpha / given[PER_SPREAD, k]
            work[SEPARATION, k] = max(work[SEPARATION, k], separation)
    if film_is_known:
        for k in range(count):
            work[SEPARATION, k] = max(work[SEPARATION, k], given[FILM_GAP, k])


@stage
def summits_bear(block, count, model):
    """F_ss, the load of Eq. 2 that summits bear where there are no particles, becomes ``SOLID``."""
    given, work, series = block.given, block.work, block.series
    summits, rounding = model.summits, model.limits.rounding
    one = work.dtype.type(1)
    last = work.dtype.type(summits.table.rows.shape[0] - 1.5)
    for k in range(count):
        t = (work[SEPARATION, k] - given[OFFSET, k]) * given[PER_DEVIATION, k]
        work[POSITION, k] = min((t - summits.table.start) * summits.table.scale, last)
    find_piece(block, count, summits.table, POSITION)
    look_up_summits(block, count, summits.table.rows, model.degree, 0, SUMMITS)
    for k in range(count):
        per_load = given[PER_LOAD, k] * given[SUMMIT_PARAMETER, k]
        pieces = summits.table.scale * given[PER_DEVIATION, k]
        inner, misplacement = pieces + pieces, (rounding + rounding) / pieces
        load = power(series[SUMMITS, VALUE, k]) * per_load
        slope, curve = relative_terms(series, SUMMITS, k, inner)
        series[SOLID, VALUE, k] = load
        series[SOLID, SLOPE, k] = slope * load
        series[SOLID, CURVE, k] = curve * load
        # the place in the table is known to rounding
        subtracted = abs(given[OFFSET, k]) * pieces
        misplaced = misplacement * (work[POSITION, k] + subtracted) * abs(slope)
        work[PART_ERROR, k] = misplaced
        work[LOAD_ERROR, k] = (summits.error + misplaced) * load
        work[STEEPEST, k] = max(-slope, one / abs(work[SEPARATION, k]))


@stage
def summits_touch(block, count, model):
    """A_ss, the area of Eq. 3 where there are no particles, in the pieces that hold the load."""
    given, series, summits = block.given, block.series, model.summits
    invalid = series.dtype.type(np.nan)
    first = model.degree + 1
    look_up_summits(block, count, summits.table.rows, model.degree, first, SUMMIT_AREA)
    for k in range(count):
        pieces = summits.table.scale * given[PER_DEVIATION, k]
        inner = pieces + pieces
        area = power(series[SUMMIT_AREA, VALUE, k] * summits.area_root)
        area = area * given[SUMMIT_PARAMETER, k]
        area = area if area >= model.limits.least else invalid
        slope, curve = relative_terms(series, SUMMIT_AREA, k, inner)
        series[SUMMIT_AREA, VALUE, k] = area
        series[SUMMIT_AREA, SLOPE, k] = slope * area
        series[SUMMIT_AREA, CURVE, k] = curve * area


@stage
def find_moments(block, count, model):
    """The moment, the integral of Eqs. 4-6 above a size, at d and at the other limit of the elastic
    one."""
    given, work = block.given, block.work
    table = model.particles.table
    last = work.dtype.type(table.rows.shape[0] - 1.5)
    for k in range(count):
        alpha = (work[SEPARATION, k] - given[MEAN, k]) * given[PER_SPREAD, k] - table.start
        work[POSITION, k] = min(alpha * table.scale, last)
        work[ELASTIC_POSITION, k] = min((alpha + given[ELASTIC_SHIFT, k]) * table.scale, last)
    find_piece(block, count, table, POSITION)
    look_up(block, count, table.rows, model.degree, 0, MOMENT)
    find_piece(block, count, table, ELASTIC_POSITION)
    look_up(block, count, table.rows, model.degree, 0, ELASTIC_MOMENT)


@stage
def particles_touch(block, count, particles):
    """A_sa and the coverage of Eq. 5 become ``TOUCHING`` and ``COVERED``."""
    given, series = block.given, block.series
    own, other = particles.own_weight, particles.other_weight
    scale, coverage = particles.table.scale, particles.coverage
    for k in range(count):
        inner = (scale + scale) * given[PER_SPREAD, k]
        here, here_1 = series[MOMENT, VALUE, k], series[MOMENT, SLOPE, k] * inner
        here_2 = series[MOMENT, CURVE, k] * inner * inner
        there, there_1 = series[ELASTIC_MOMENT, VALUE, k], series[ELASTIC_MOMENT, SLOPE, k] * inner
        there_2 = series[ELASTIC_MOMENT, CURVE, k] * inner * inner
        here_2, there_2 = here_2 + here_2, there_2 + there_2
        plastic = given[PLASTIC_AREA, k]
        series[TOUCHING, VALUE, k] = plastic * (own * here + other * there)  # Eq. 5, A_sa
        series[TOUCHING, SLOPE, k] = plastic * (own * here_1 + other * there_1)
        series[TOUCHING, CURVE, k] = plastic * (own * here_2 + other * there_2)
        covering = coverage * plastic
        series[COVERED, VALUE, k] = covering * here  # Eq. 5, what is subtracted from 1
        series[COVERED, SLOPE, k] = covering * here_1
        series[COVERED, CURVE, k] = covering * here_2


@stage
def particles_bear(block, count, model):
    """``SOLID`` loses what particles cover and gains what they bear: F_s of Eq. 4."""
    given, work, series = block.given, block.work, block.series
    limits, pressure = model.limits, model.particles.pressure
    contacting = model.particles.contacting
    zero, one, invalid = work.dtype.type(0), work.dtype.type(1), work.dtype.type(np.nan)
    for k in range(count):
        covered = series[COVERED, VALUE, k]
        area, area_1 = series[TOUCHING, VALUE, k], series[TOUCHING, SLOPE, k]
        area_2 = series[TOUCHING, CURVE, k]
        bare = given[BARE, k] - contacting * covered  # Eq. 4, the bracket behind F_ss
        falls_1 = contacting * series[COVERED, SLOPE, k]
        falls_2 = contacting * series[COVERED, CURVE, k]
        load, load_1 = series[SOLID, VALUE, k], series[SOLID, SLOPE, k]
        load_2 = series[SOLID, CURVE, k]
        bears = pressure * given[PER_LOAD, k]
        valid = (min(bare, one - covered) > limits.least_bare) & (area_1 <= zero)
        valid &= given[PLASTIC_AREA, k] >= limits.least
        series[SOLID, VALUE, k] = (load * bare + bears * area) if valid else invalid  # Eq. 4
        series[SOLID, SLOPE, k] = load_1 * bare - load * falls_1 + bears * area_1
        twice = load_1 * falls_1
        series[SOLID, CURVE, k] = load_2 * bare - (twice + twice) - load * falls_2 + bears * area_2


@stage
def bound_particle_errors(block, count, model):
    """What the table of the moment does to the errors, and how steep the particles make the results.

    Errors of a polynomial scale with its piece: near the largest size that is all there is.  Errors
    of a place in the table scale with the slope there.
    """
    given, work, series = block.given, block.work, block.series
    particles = model.particles
    own, other = particles.own_weight, particles.other_weight
    scale, rounding = particles.table.scale, model.limits.rounding
    zero, one, four = work.dtype.type(0), work.dtype.type(1), work.dtype.type(4)
    endless = work.dtype.type(np.inf)
    for k in range(count):
        inner = (scale + scale) * given[PER_SPREAD, k]
        here, there = series[MOMENT, VALUE, k], series[ELASTIC_MOMENT, VALUE, k]
        first, second = abs(series[MOMENT, SLOPE, k]), abs(series[ELASTIC_MOMENT, SLOPE, k])
        moment = own * here + other * there
        area, area_1 = series[TOUCHING, VALUE, k], series[TOUCHING, SLOPE, k]
        bare = given[BARE, k] - particles.contacting * series[COVERED, VALUE, k]
        bears, plastic = particles.pressure * given[PER_LOAD, k], given[PLASTIC_AREA, k]
        size = abs(own) * (abs(here) + first) + abs(other) * (abs(there) + second)
        moved = work[POSITION, k] * first * abs(own)
        moved += work[ELASTIC_POSITION, k] * second * abs(other)
        unsure = four * particles.error * size + (moved + moved) * rounding
        room = one - series[COVERED, VALUE, k]
        unsure_here = four * particles.error * (abs(here) + first)
        unsure_here += (rounding + rounding) * work[POSITION, k] * first
        room_error = particles.coverage * plastic * unsure_here / room
        part_error = unsure / moment if moment > zero else endless
        part_error = part_error if unsure > zero else zero  # no particle touches
        work[SLOPE_ERROR, k] = particles.slope_error * size * plastic * abs(inner) * bears
        work[PART_ERROR, k] += part_error + room_error
        # abs leaves but one product that can be fused with the sum: no choice, no other last digit
        load_error = abs(part_error * bears * area)
        load_error += particles.contacting * room_error * series[SOLID, VALUE, k]
        work[LOAD_ERROR, k] = work[LOAD_ERROR, k] * bare + load_error
        steepness = -area_1 / area
        steepness = steepness if area > zero else zero
        steepness = max(steepness, -series[COVERED, SLOPE, k] / room)
        work[STEEPEST, k] = max(work[STEEPEST, k], steepness)


@stage
def film_bears(block, count, model):
    """F_f at which the film is as thick as the surfaces are apart, Eq. 7, becomes ``FILM``."""
    given, work, series = block.given, block.work, block.series
    film, least = model.film, model.limits.least
    invalid = work.dtype.type(np.nan)
    for k in range(count):
        work[POSITION, k] = work[SEPARATION, k] * given[PER_CROSSING, k]
    find_octave_piece(block, count, film.table)
    look_up(block, count, film.table.rows, model.degree, 0, FILM)
    for k in range(count):
        load = power(series[FILM, VALUE, k] * given[CROSSING_ROOT, k])
        load = load if load >= least else invalid
        inner = work[HALF_PIECES, k] / work[SEPARATION, k]
        slope, curve = relative_terms(series, FILM, k, inner)
        series[FILM, VALUE, k] = load
        series[FILM, SLOPE, k] = slope * load
        series[FILM, CURVE, k] = curve * load
        misplaced = film.crossing_error * abs(slope) * work[SEPARATION, k]
        work[PART_ERROR, k] += misplaced
        work[LOAD_ERROR, k] += (film.error + misplaced) * load
        work[STEEPEST, k] = max(work[STEEPEST, k], -slope)


@stage
def film_holds(block, count):
    """What solids leave to bear, 1 - F_s/F_t, becomes ``FILM`` where they are as far apart as a film of
    known thickness keeps them; elsewhere nothing."""
    given, work, series = block.given, block.work, block.series
    zero, one = work.dtype.type(0), work.dtype.type(1)
    for k in range(count):
        left = one - series[SOLID, VALUE, k]
        held = (work[SEPARATION, k] == given[FILM_GAP, k]) & (left > zero)
        series[FILM, VALUE, k] = left if held else zero


@stage
def take_step(block, count, model):
    """Halley's step towards F_s + F_f = F_t, Eq. 1, and what errors there are after it."""
    work, series, limits = block.work, block.series, model.limits
    real = work.dtype.type
    zero, half, one, eight = real(0), real(0.5), real(1), real(8)
    endless, invalid = real(np.inf), real(np.nan)
    known = model.summits.error + model.film.error
    for k in range(count):
        total = series[SOLID, VALUE, k] + series[FILM, VALUE, k]  # Eq. 1, over F_t
        total_1 = series[SOLID, SLOPE, k] + series[FILM, SLOPE, k]
        total_2 = series[SOLID, CURVE, k] + series[FILM, CURVE, k]
        residual, step = _halley(total, total_1, total_2)
        steepest, separation = work[STEEPEST, k], work[SEPARATION, k]
        condition = -steepest * total / total_1
        moved = abs(steepest * step)
        load_error = work[LOAD_ERROR, k] / total + limits.noise
        slope_error = work[SLOPE_ERROR, k] / abs(total_1)
        remainder = moved * moved * moved * (one + condition)
        # a load's own error counts as much as its part in the balance
        error = (
            remainder
            + moved * slope_error
            + known
            + work[PART_ERROR, k]
            + condition * load_error
            + eight * limits.rounding * steepest * separation
        )
        valid = (total_1 < zero) & (series[SOLID, VALUE, k] >= limits.least)
        valid &= separation + step > zero
        valid &= slope_error < half
        work[SEPARATION, k] = separation + step if valid else invalid
        work[STEP, k] = step
        work[UNSURE, k] = load_error * total
        work[REMAINDER, k] = remainder if valid & (abs(residual) < one) else endless
        work[ERROR, k] = error


@stage
def _halley(total, total_1, total_2):
    """ln of a load that is to be 1, and the step that Halley's method takes to make it so.

    ``total_1`` and ``total_2`` are its slope and half of its second derivative.  The logarithm is a
    quotient of polynomials, wrong by a fifth power of what the load differs from 1 by.
    """
    real = type(total)
    half, one, three, four = real(0.5), real(1), real(3), real(4)
    residual = three * (total * total - one) / (total * (total + four) + one)
    square = total_1 * total_1
    curve = total_2 * total - square
    return residual, -residual * total * total_1 / (square - half * residual * curve)


@stage
def add_moment_remainders(block, count, model):
    """What the Taylor series of the moments leave after the step is no power of the loads' slopes.

    The third derivative of M is that of x^2 phi(x), counted in spreads: no more than 8 + 8|alpha| +
    alpha^2 times the slope where x is above a half, and than a number for sizes next to zero.  Where
    the slope itself falls to zero, Halley's step leaves a square of how much it bends the loads, too.
    """
    given, work, series, particles = block.given, block.work, block.series, model.particles
    own, other = particles.own_weight, particles.other_weight
    scale = particles.table.scale
    real = work.dtype.type
    zero, half, eight, per_six = real(0), real(0.5), real(8), real(1.0 / 6.0)
    inner = abs(scale + scale)
    small = particles.smallest + half  # beside the spread
    for k in range(count):
        per_spread = given[PER_SPREAD, k]
        # the separation has moved by then: alpha is known well enough for a bound
        alpha = (work[SEPARATION, k] - given[MEAN, k]) * per_spread
        shifted = alpha + given[ELASTIC_SHIFT, k]
        here_3 = abs(series[MOMENT, SLOPE, k]) * inner * (eight + abs(alpha) * (eight + abs(alpha)))
        here_3 += particles.smallest_third if alpha < small else zero
        there_3 = abs(series[ELASTIC_MOMENT, SLOPE, k]) * inner
        there_3 *= eight + abs(shifted) * (eight + abs(shifted))
        there_3 += particles.smallest_third if shifted < small else zero
        moved = abs(work[STEP, k]) * per_spread
        area, total_1 = series[TOUCHING, VALUE, k], series[SOLID, SLOPE, k] + series[FILM, SLOPE, k]
        bend = (series[SOLID, CURVE, k] + series[FILM, CURVE, k]) * work[STEP, k] / total_1
        third = abs(own) * here_3 + abs(other) * there_3
        left = third * moved * moved * moved * per_six * given[PLASTIC_AREA, k]
        bears = left * particles.pressure * given[PER_LOAD, k]
        error = left / area + work[STEEPEST, k] * (
            bears / abs(total_1) + abs(work[STEP, k]) * bend * bend
        )
        error = error if left > zero else zero
        work[REMAINDER, k] += error
        work[ERROR, k] += error


@stage
def keep_film(block, count, model):
    """No step where a film of known thickness holds, and none to where it would be thinner.

    The separation is then that of the film, and as exact.  Of the shares of the load that of the film,
    1 - F_s/F_t, loses most.  Solids that bear everything have to be farther apart than the film by
    more than both may be wrong by.
    """
    given, work, series, limits = block.given, block.work, block.series, model.limits
    real = work.dtype.type
    zero, one, eight = real(0), real(1), real(8)
    endless, invalid = real(np.inf), real(np.nan)
    for k in range(count):
        solid, film = series[SOLID, VALUE, k], series[FILM, VALUE, k]
        steepest, total_1 = work[STEEPEST, k], abs(series[SOLID, SLOPE, k])
        separation, gap = work[SEPARATION, k], given[FILM_GAP, k]
        valid, held = separation > zero, film > zero
        misplaced = (given[FILM_ERROR, k] + eight * limits.rounding) * gap
        moved = abs(steepest * misplaced)
        load_error = work[LOAD_ERROR, k] / solid + limits.noise + moved
        error = model.summits.error + work[PART_ERROR, k] + moved
        error = error + load_error * max(one, solid / film)
        unsure = misplaced + work[UNSURE, k] / total_1
        farther = separation - gap > unsure + unsure
        remains = separation if farther & (not held) else gap
        unsure = unsure + work[REMAINDER, k] / steepest
        remainder = work[REMAINDER, k] if separation - gap > unsure + unsure else endless
        work[SEPARATION, k] = remains if valid else invalid
        work[REMAINDER, k] = zero if held & valid else remainder
        work[STEP, k] = zero if held else work[STEP, k]
        work[ERROR, k] = error if held else work[ERROR, k]
        work[UNSURE, k] = misplaced * total_1 if held else work[UNSURE, k]


@stage
def stop_before_contact(block, count, model):
    """A step to where particles come into contact, or across, is not the last one.

    There the loads have no Taylor series, and rounding may decide on which side a point is; and half
    of the way there an area has lost half of what its errors are compared with.  What errors of the
    loads do to the separation depends on the slope, which loses a part on the other side.  It stays
    the same up to there, as ln M is concave: so they do not reach across where the particles that
    lose touch bear far more than they are.

    Nor is a step the last one, or an error known, that is long beside what the sizes at d spread
    over: they decay by a factor of e over 1/|alpha|, and are none below ``LOWEST``; and down to the
    smallest size slopes fall as its square.
    """
    given, work, series, limits = block.given, block.work, block.series, model.limits
    particles, start = model.particles, model.particles.table.start
    own, other = particles.own_weight, particles.other_weight
    scale = particles.table.scale
    real = work.dtype.type
    zero, quarter, one, eight, sixteen = real(0), real(0.25), real(1), real(8), real(16)
    lowest, endless = real(LOWEST), real(np.inf)
    for k in range(count):
        separation, per_spread = work[SEPARATION, k], given[PER_SPREAD, k]
        bears = particles.pressure * given[PER_LOAD, k] * given[PLASTIC_AREA, k]
        here, there = bears * own, bears * other
        inner = (scale + scale) * per_spread
        total_1 = series[SOLID, SLOPE, k] + series[FILM, SLOPE, k]
        beyond_here_1 = total_1 - here * inner * series[MOMENT, SLOPE, k]
        beyond_there_1 = total_1 - there * inner * series[ELASTIC_MOMENT, SLOPE, k]
        unsure, rounded = work[UNSURE, k], abs(work[STEP, k])
        rounded += eight * limits.rounding * separation
        slope = abs(total_1)
        bears_here = abs(here * series[MOMENT, VALUE, k]) > sixteen * unsure
        bears_there = abs(there * series[ELASTIC_MOMENT, VALUE, k]) > sixteen * unsure
        slope_here = slope if bears_here else min(slope, abs(beyond_here_1))
        slope_there = slope if bears_there else min(slope, abs(beyond_there_1))
        unsure_here = (rounded + unsure / slope_here) * per_spread
        unsure_there = (rounded + unsure / slope_there) * per_spread
        alpha = (separation - given[MEAN, k]) * per_spread - start
        shifted = alpha + given[ELASTIC_SHIFT, k]
        stays = unsure_here + unsure_here < abs(alpha)
        stays &= unsure_there + unsure_there < abs(shifted)
        here_alpha, there_alpha = alpha + start, shifted + start
        short_here = unsure_here * (one + abs(here_alpha)) < quarter
        short_there = unsure_there * (one + abs(there_alpha)) < quarter
        stays &= short_here | (unsure_here + unsure_here < lowest - here_alpha) | (alpha > zero)
        stays &= (
            short_there | (unsure_there + unsure_there < lowest - there_alpha) | (shifted > zero)
        )
        down, down_there = here_alpha - particles.smallest, there_alpha - particles.smallest
        stays &= (sixteen * unsure_here < down) | (down < zero)
        stays &= (sixteen * unsure_there < down_there) | (down_there < zero)
        work[REMAINDER, k] = work[REMAINDER, k] if stays else endless


@stage
def move_loads(block, count, limits):
    """Separation, and the shares of the load, Eq. 9, after the step."""
    work, series, results = block.work, block.series, block.results
    half = work.dtype.type(0.5)
    for k in range(count):
        step = work[STEP, k]
        square = half * step * step
        solid = series[SOLID, VALUE, k] + series[SOLID, SLOPE, k] * step
        solid = np.float64(solid + series[SOLID, CURVE, k] * square)
        film = series[FILM, VALUE, k] + series[FILM, SLOPE, k] * step
        film = np.float64(film + series[FILM, CURVE, k] * square)
        total = solid + film
        results[SOLID_SHARE, k] = solid / total  # Eq. 9
        results[FLUID_SHARE, k] = film / total  # Eq. 9
        results[GAP, k] = work[SEPARATION, k]
        results[BOUND, k] = work[ERROR, k] if work[REMAINDER, k] <= limits.allowed else np.nan


@stage
def move_areas(block, count, model):
    """A_t, Eq. 5, and the shares of both areas in it, Eq. 10, after the step."""
    work, series, results = block.work, block.series, block.results
    zero, half, one = work.dtype.type(0), work.dtype.type(0.5), work.dtype.type(1)
    for k in range(count):
        step = work[STEP, k]
        square = half * step * step
        area, area_1 = series[SUMMIT_AREA, VALUE, k], series[SUMMIT_AREA, SLOPE, k]
        moved = area + area_1 * step
        # the product of two series: of 1 less what is covered, and of A_ss
        bare = (
            (one - series[COVERED, VALUE, k]) * (moved + series[SUMMIT_AREA, CURVE, k] * square)
            - series[COVERED, SLOPE, k] * step * moved
            - series[COVERED, CURVE, k] * square * area
        )
        touching = series[TOUCHING, VALUE, k] + series[TOUCHING, SLOPE, k] * step
        touching = max(touching + series[TOUCHING, CURVE, k] * square, zero)
        particles, surfaces = np.float64(touching), np.float64(bare)
        together = particles + surfaces * model.summits.area_unit  # Eq. 5
        results[TOTAL_AREA, k] = together
        results[PARTICLE_SHARE, k] = particles / together  # Eq. 10
        results[SURFACE_SHARE, k] = surfaces / together * model.summits.area_unit  # Eq. 10
        bound = results[BOUND, k]
        counts = together > model.limits.least_area
        counts &= (surfaces * model.summits.area_unit > 0.0) | (together > PLAIN)
        results[BOUND, k] = bound if counts else np.nan
