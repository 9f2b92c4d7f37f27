"""The balance of forces (Eqs. 1, 2 and 4) at many points, in machine code.

``WIDTH`` points are solved side by side.  Each quantity is a row of one work array, and what is
calculated is written as loops along rows without a branch, which a compiler turns into
instructions for many numbers at a time; only pieces of tables are looked up point by point.  All
numbers are of the type of the work array.

Tables of loads and areas hold their sixteenth roots, which are ordinary numbers where a load is
e^-800; four squarings bring the load back.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numba import njit

WIDTH = 512  # points side by side
STEPS = 8  # a point that needs more is better left to bisection
ROOT = 16  # which root of loads and areas the tables hold
COMPILED = {"error_model": "numpy", "fastmath": {"contract"}, "nogil": True}
STAGE = njit(**COMPILED, no_cpython_wrapper=True, no_cfunc_wrapper=True)  # within the loop

ZERO, ONE, STRIDE = np.uintp(0), np.uintp(1), np.uintp(WIDTH + 16)  # unsigned: no index is negative
_row = iter(range(100))


def _rows(count):
    """The places of the next ``count`` rows in the work array."""
    return [np.uintp(next(_row)) * STRIDE for _ in range(count)]


# what a point has of its own: where it is, and what is given: 1/F_t*, of particles m, 1/S, by how
# much alpha is shifted where the elastic ones end, their area if all are plastic and M = 1, and the
# share of the interface that they leave bare, of the film 1/d where the terms of Eq. 7 are equal
# and the root of its share in F_t there; lengths are in units of sigma, loads in units of F_t
GIVEN = 8
SEPARATION, PER_LOAD, MEAN, PER_SPREAD, SHIFT, AREA, BARE, PER_LEVEL, FILM_ROOT = _rows(GIVEN + 1)
# where in a table it is, where within a piece, how far that is from zero in halves of the piece
POSITION, BEYOND, PIECE, LOCAL, HALVES = _rows(5)
COEFFICIENTS = _rows(8)[0]
# each with its slope and half of its curvature
SUMMITS, SUMMIT_AREA, HERE, THERE, SOLID, FILM, TOUCHING, COVERED = _rows(24)[::3]
UNSURE_1, STEP, LEFT, GAIN, UNSURE, ASTRAY, ERROR = _rows(7)
ROWS = next(_row)
# rows of the array of results, of float64 always
_row = iter(range(100))
RESULTS = 7
TOTAL_AREA, PARTICLE_SHARE, SURFACE_SHARE, SOLID_SHARE, FLUID_SHARE, GAP, BOUND = _rows(RESULTS)


class Table(NamedTuple):
    """Polynomials on equal pieces, one piece a row; what holds outside is the last row."""

    rows: np.ndarray
    start: float
    scale: float  # pieces a unit, negative where they are counted downwards


class OctaveTable(NamedTuple):
    """Polynomials on pieces that are equal within an octave of a positive variable, so that the
    bits of a number tell its piece; what holds outside is the last row."""

    rows: np.ndarray
    first: int  # leading bits of where the first piece begins
    shift: int  # bits that tell the place within a piece
    within: float  # a piece over one of these
    pieces: int  # of an octave


class Model(NamedTuple):
    """What all points on one surface share."""

    degree: int  # of all polynomials
    summits: Table  # roots of F_ss* and A_ss/A_n, side by side in a row, of t
    moment: Table  # M of alpha less that of the largest particles, from these on downwards
    film: OctaveTable  # root of F_f of d, both over those where the terms of Eq. 7 are equal
    summits_alone: OctaveTable  # d of F_t*, for first guesses
    film_alone: OctaveTable  # d of the film's root, for first guesses; over where terms are equal
    particles_alone: OctaveTable  # alpha of their area over that of M = 1, for first guesses
    summit_error: float  # relative, of loads and areas
    film_error: float
    level_error: float  # of a film's thickness where its terms are equal
    moment_error: float
    slope_error: float  # of the moment
    per_deviation: float  # sigma/sigma_s
    offset: float  # y_s
    elastic: float  # part of the elastic particles in the area, negative if they lie beyond alpha
    pressure: float  # F_sa/(A_sa E_ss)
    coverage: float  # coverage of Eq. 5 over the area of plastic particles
    contacting: float  # 1 if Eq. 4 takes the coverage of Eq. 5, else 0
    allowed: float  # relative error that steps may leave
    noise: float  # of a load
    rounding: float  # of a number
    least: float  # a smaller number has not all digits
    least_bare: float  # of the interface: a smaller difference has lost its digits
    least_area: float  # of all contacts, of A_n
    area_root: float  # by which the summits' area is held larger: they may have next to none
    area_unit: float  # by which it becomes that of A_n again


def solve_points(
    model, columns, has_particles, has_film, wants_areas, work, bits, results, places, found
):
    """Fill the rows of ``found``: A_t*, A_sa,t*, A_ss,t*, L_s, L_f, d/sigma and a bound on the
    relative error, which is nan where the loop does not find a solution.

    ``columns`` has a row for all that is given of a point and a column for each point; without
    film or particles what concerns them is not read.  ``work`` and ``results`` have ``ROWS`` and
    ``RESULTS`` rows of ``STRIDE`` numbers, ``bits`` are the bytes of ``work`` as integers, and
    ``places`` has ``WIDTH`` integers.

    Halley's method on the logarithm of the load that the interface bears at d, which falls with d.
    It starts at the largest of the d at which summits, particles or film alone bear the load, and
    what a last step changes comes from its Taylor series.
    """
    total = np.uintp(found.shape[1])
    work[FILM:STEP] = work.dtype.type(0)  # what is missing bears and covers nothing
    for start in range(ZERO, total, np.uintp(WIDTH)):
        count = min(np.uintp(WIDTH), total - start)
        for row in range(np.uintp(GIVEN)):
            for k in range(count):
                work[(row + ONE) * STRIDE + k] = columns[row, start + k]
        for k in range(count):
            places[k] = start + k
        _start(work, bits, count, model, has_particles, has_film)
        for step in range(STEPS):
            _summits_bear(work, bits, count, model, wants_areas)
            if has_particles:
                _particles_bear(work, bits, count, model)
            if has_film:
                _film_bears(work, bits, count, model)
            _step(work, count, model)
            if has_particles:
                _stop_before_contact(work, count, model)
            if wants_areas:
                _move_areas(work, results, count, model)
            _move_loads(work, results, count, model)
            if step == 0:  # of all points, in their order
                for row in range(np.uintp(RESULTS)):
                    for k in range(count):
                        found[row, start + k] = results[row * STRIDE + k]
            else:
                _store(work, results, count, places, model.allowed, found)
            count = _compress(work, count, places, model.allowed)
            if count == 0:
                break


@STAGE
def _store(work, results, count, places, allowed, found):
    """Put the results of points that are done in their places."""
    for k in range(count):
        if work[LEFT + k] <= allowed:
            for row in range(np.uintp(RESULTS)):
                found[row, places[k]] = results[row * STRIDE + k]


@STAGE
def _compress(work, count, places, allowed):
    """Bring points that are to take another step to the front; returns how many there are."""
    going_on = ZERO
    for k in range(count):
        if not work[LEFT + k] <= allowed and work[SEPARATION + k] > work.dtype.type(0):
            for row in range(np.uintp(GIVEN + 1)):
                work[row * STRIDE + going_on] = work[row * STRIDE + k]
            places[going_on] = places[k]
            going_on += ONE
    return going_on


@STAGE
def _start(work, bits, count, model, has_particles, has_film):
    """The largest of the separations at which something bears the load by itself."""
    one = work.dtype.type(1)
    for k in range(count):
        work[POSITION + k] = one / work[PER_LOAD + k]
    _guess(work, bits, count, model.summits_alone)
    for k in range(count):
        work[SEPARATION + k] = work[LOCAL + k]
    if has_film:
        for k in range(count):
            work[POSITION + k] = work[FILM_ROOT + k]
        _guess(work, bits, count, model.film_alone)
        for k in range(count):
            separation = work[LOCAL + k] / work[PER_LEVEL + k]
            work[SEPARATION + k] = max(work[SEPARATION + k], separation)
    if has_particles:
        for k in range(count):
            bears = work[PER_LOAD + k] * model.pressure * work[AREA + k]
            work[POSITION + k] = one / bears
        _guess(work, bits, count, model.particles_alone)
        for k in range(count):
            separation = work[MEAN + k] + work[LOCAL + k] / work[PER_SPREAD + k]
            work[SEPARATION + k] = max(work[SEPARATION + k], separation)


@STAGE
def _guess(work, bits, count, table):
    """``LOCAL`` becomes what a table of two columns, value and slope, holds at ``POSITION``."""
    last = table.rows.shape[0] - 1
    for k in range(count):
        number = bits[POSITION + k]
        bits[PIECE + k] = min(max((number >> table.shift) - table.first, 0), last)
        work[LOCAL + k] = work.dtype.type(number & ((1 << table.shift) - 1)) * table.within
    for k in range(count):
        piece = np.uintp(bits[PIECE + k])
        work[LOCAL + k] = table.rows[piece, ZERO] + table.rows[piece, ONE] * work[LOCAL + k]


@STAGE
def _find_piece(work, bits, count, table, position):
    """``PIECE`` and ``LOCAL`` of a row of positions in a ``Table``."""
    real = work.dtype.type
    pieces = table.rows.shape[0] - 1
    zero, one, end = real(0), real(1), real(pieces)
    for k in range(count):
        place = work[position + k]
        inside = (place >= zero) & (place < end)
        piece = np.int32(place if inside else end)
        bits[PIECE + k] = piece
        local = place - real(piece)
        work[LOCAL + k] = local + local - one


@STAGE
def _find_octave_piece(work, bits, count, table):
    """``PIECE``, ``LOCAL`` and ``HALVES`` of ``POSITION`` in an ``OctaveTable``."""
    real = work.dtype.type
    pieces = table.rows.shape[0] - 1
    one, within = real(1), table.within + table.within
    halves = real(2 * table.pieces + 1)
    for k in range(count):
        number = bits[POSITION + k]
        place = (number >> table.shift) - table.first
        inside = (place >= 0) & (place < pieces)
        bits[PIECE + k] = place if inside else pieces
        local = real(number & ((1 << table.shift) - 1)) * within - one
        work[LOCAL + k] = local
        work[HALVES + k] = local + (halves + real(2 * (place & (table.pieces - 1))))


def _reader(degree):
    """Function that evaluates polynomials of a degree: a constant count makes a loop fast."""
    degree, terms = np.uintp(degree), np.uintp(degree + 1)
    highest = COEFFICIENTS + degree * STRIDE

    @STAGE
    def read(work, bits, count, rows, first, into):
        zero = work.dtype.type(0)
        for k in range(count):
            piece = np.uintp(bits[PIECE + k])
            for power in range(terms):
                work[COEFFICIENTS + power * STRIDE + k] = rows[piece, first + power]
        for k in range(count):
            local = work[LOCAL + k]
            value, slope, curve = work[highest + k], zero, zero
            for power in range(degree):
                curve = curve * local + slope
                slope = slope * local + value
                value = value * local + work[highest - (power + ONE) * STRIDE + k]
            work[into + k] = value
            work[into + STRIDE + k] = slope
            work[into + STRIDE + STRIDE + k] = curve

    return read


_read_3, _read_5, _read_7 = _reader(3), _reader(5), _reader(7)


@STAGE
def _read(work, bits, count, rows, degree, first, into):
    """Value, slope and half the curvature at ``PIECE`` and ``LOCAL`` of the polynomials in ``rows``
    whose coefficients begin in column ``first``."""
    if degree == 3:
        _read_3(work, bits, count, rows, first, into)
    elif degree == 5:
        _read_5(work, bits, count, rows, first, into)
    else:
        _read_7(work, bits, count, rows, first, into)


@STAGE
def _power(value):
    """The ``ROOT``-th power, by four squarings."""
    square = value * value
    square = square * square
    square = square * square
    return square * square


@STAGE
def _slopes(work, row, inner, root, less):
    """Slope and curvature of the ``root``-th power of what stands in ``row``, over that power;
    ``inner`` is how fast the local variable of the polynomials changes, ``less`` the root less 1."""
    per_value = inner / work[row]
    slope = work[row + STRIDE] * per_value
    curve = work[row + STRIDE + STRIDE] * per_value * inner
    return root * slope, root * (curve + curve + less * slope * slope)


@STAGE
def _summits_bear(work, bits, count, model, wants_areas):
    """``SOLID`` and ``SUMMIT_AREA`` become the load and area of the summits, with slopes."""
    real = work.dtype.type
    one, root, less, invalid = real(1), real(ROOT), real(ROOT - 1), real(np.nan)
    pieces = model.summits.scale * model.per_deviation
    inner, wide = pieces + pieces, (model.rounding + model.rounding) / pieces
    for k in range(count):
        t = (work[SEPARATION + k] - model.offset) * model.per_deviation
        work[POSITION + k] = (t - model.summits.start) * model.summits.scale
    _find_piece(work, bits, count, model.summits, POSITION)
    _read(work, bits, count, model.summits.rows, model.degree, ZERO, SUMMITS)
    for k in range(count):
        load = _power(work[SUMMITS + k]) * work[PER_LOAD + k]
        slope, curve = _slopes(work, SUMMITS + k, inner, root, less)
        work[SOLID + k] = load
        work[SOLID + STRIDE + k] = slope * load
        work[SOLID + STRIDE + STRIDE + k] = curve * load
        astray = wide * work[POSITION + k] * abs(slope)  # where in the table is known to rounding
        work[ASTRAY + k] = astray
        work[UNSURE + k] = (model.summit_error + astray) * load
        work[GAIN + k] = max(-slope, one / abs(work[SEPARATION + k]))
    if wants_areas:
        first = np.uintp(model.degree + 1)
        _read(work, bits, count, model.summits.rows, model.degree, first, SUMMIT_AREA)
        for k in range(count):
            area = _power(work[SUMMIT_AREA + k] * model.area_root)
            area = area if area >= model.least else invalid
            slope, curve = _slopes(work, SUMMIT_AREA + k, inner, root, less)
            work[SUMMIT_AREA + k] = area
            work[SUMMIT_AREA + STRIDE + k] = slope * area
            work[SUMMIT_AREA + STRIDE + STRIDE + k] = curve * area


@STAGE
def _particles_bear(work, bits, count, model):
    """``SOLID`` loses what particles cover and wins what they bear; ``TOUCHING`` and ``COVERED``
    become their area and coverage, with slopes."""
    real = work.dtype.type
    zero, one, four, invalid = real(0), real(1), real(4), real(np.nan)
    scale, last = model.moment.scale, real(model.moment.rows.shape[0] - 1.5)
    for k in range(count):
        alpha = (work[SEPARATION + k] - work[MEAN + k]) * work[PER_SPREAD + k] - model.moment.start
        work[POSITION + k] = min(alpha * scale, last)
        work[BEYOND + k] = min((alpha + work[SHIFT + k]) * scale, last)
    for position, into in ((POSITION, HERE), (BEYOND, THERE)):
        _find_piece(work, bits, count, model.moment, position)
        _read(work, bits, count, model.moment.rows, model.degree, ZERO, into)
    elastic, pressure, cover = model.elastic, model.pressure, model.coverage
    contacting = model.contacting
    for k in range(count):
        inner = (scale + scale) * work[PER_SPREAD + k]
        here, here_1 = work[HERE + k], work[HERE + STRIDE + k] * inner
        here_2 = work[HERE + STRIDE + STRIDE + k] * inner * inner
        there_1 = work[THERE + STRIDE + k] * inner
        there_2 = work[THERE + STRIDE + STRIDE + k] * inner * inner
        here_2, there_2 = here_2 + here_2, there_2 + there_2
        plastic = work[AREA + k]
        share = here + elastic * (work[THERE + k] - here)
        area = plastic * share
        area_1 = plastic * (here_1 + elastic * (there_1 - here_1))
        area_2 = plastic * (here_2 + elastic * (there_2 - here_2))
        covering = cover * plastic
        covered, covered_1, covered_2 = covering * here, covering * here_1, covering * here_2
        counted = contacting * covered
        bare, bare_1 = work[BARE + k] - counted, contacting * covered_1
        bare_2 = contacting * covered_2
        load, load_1 = work[SOLID + k], work[SOLID + STRIDE + k]
        load_2 = work[SOLID + STRIDE + STRIDE + k]
        bears = pressure * work[PER_LOAD + k]
        valid = (min(bare, one - covered) > model.least_bare) & (area_1 <= zero)
        valid &= plastic >= model.least
        work[SOLID + k] = (load * bare + bears * area) if valid else invalid
        work[SOLID + STRIDE + k] = load_1 * bare - load * bare_1 + bears * area_1
        twice = load_1 * bare_1
        work[SOLID + STRIDE + STRIDE + k] = (
            load_2 * bare - (twice + twice) - load * bare_2 + bears * area_2
        )
        work[TOUCHING + k] = area
        work[TOUCHING + STRIDE + k] = area_1
        work[TOUCHING + STRIDE + STRIDE + k] = area_2
        work[COVERED + k] = covered
        work[COVERED + STRIDE + k] = covered_1
        work[COVERED + STRIDE + STRIDE + k] = covered_2
        # errors of a polynomial scale with its piece, which near the largest size is all there is;
        # those of a position with the slope
        first = abs(work[HERE + STRIDE + k])
        second = abs(work[THERE + STRIDE + k])
        scale_of_errors = (
            abs(here) + first + abs(elastic) * (abs(here) + first + abs(work[THERE + k]) + second)
        )
        moved = work[POSITION + k] * first * (one + abs(elastic))
        moved += work[BEYOND + k] * second * abs(elastic)
        unsure = four * model.moment_error * scale_of_errors + (moved + moved) * model.rounding
        onset = unsure / share if share > zero else zero
        work[UNSURE_1 + k] = model.slope_error * scale_of_errors * plastic * abs(inner) * bears
        work[ASTRAY + k] += onset
        work[UNSURE + k] = work[UNSURE + k] * bare + onset * bears * area
        falls = -area_1 / area
        falls = falls if area > zero else zero
        work[GAIN + k] = max(max(work[GAIN + k], falls), -covered_1)


@STAGE
def _film_bears(work, bits, count, model):
    """``FILM`` becomes the load of the film, with slopes."""
    real = work.dtype.type
    root, less, invalid = real(ROOT), real(ROOT - 1), real(np.nan)
    for k in range(count):
        work[POSITION + k] = work[SEPARATION + k] * work[PER_LEVEL + k]
    _find_octave_piece(work, bits, count, model.film)
    _read(work, bits, count, model.film.rows, model.degree, ZERO, FILM)
    for k in range(count):
        load = _power(work[FILM + k] * work[FILM_ROOT + k])
        load = load if load >= model.least else invalid
        inner = work[HALVES + k] / work[SEPARATION + k]
        slope, curve = _slopes(work, FILM + k, inner, root, less)
        work[FILM + k] = load
        work[FILM + STRIDE + k] = slope * load
        work[FILM + STRIDE + STRIDE + k] = curve * load
        astray = model.level_error * abs(slope) * work[SEPARATION + k]
        work[ASTRAY + k] += astray
        work[UNSURE + k] += (model.film_error + astray) * load
        work[GAIN + k] = max(work[GAIN + k], -slope)


@STAGE
def _step(work, count, model):
    """Halley's step of the separation, what is left after it, and the error then."""
    real = work.dtype.type
    zero, half, one, three, four, eight = real(0), real(0.5), real(1), real(3), real(4), real(8)
    endless, invalid = real(np.inf), real(np.nan)
    known = model.summit_error + model.film_error
    for k in range(count):
        total = work[SOLID + k] + work[FILM + k]
        total_1 = work[SOLID + STRIDE + k] + work[FILM + STRIDE + k]
        total_2 = work[SOLID + STRIDE + STRIDE + k] + work[FILM + STRIDE + STRIDE + k]
        # its logarithm but for a fifth power of what it differs from 1 by
        residual = three * (total * total - one) / (total * (total + four) + one)
        square = total_1 * total_1
        curve = total_2 * total - square
        step = -residual * total * total_1 / (square - half * residual * curve)
        gain, separation = work[GAIN + k], work[SEPARATION + k]
        condition = -gain * total / total_1
        moved = abs(gain * step)
        astray = work[UNSURE_1 + k] / abs(total_1)
        left = moved * moved * moved * (one + condition)
        # a load's own error counts as much as its part in the balance
        error = (
            left
            + moved * astray
            + known
            + work[ASTRAY + k]
            + condition * (work[UNSURE + k] / total + model.noise)
            + eight * model.rounding * gain * separation
        )
        valid = (total_1 < zero) & (work[SOLID + k] >= model.least) & (separation + step > zero)
        valid &= astray < half
        work[SEPARATION + k] = separation + step if valid else invalid
        work[STEP + k] = step
        work[LEFT + k] = left if valid & (abs(residual) < one) else endless
        work[ERROR + k] = error


@STAGE
def _stop_before_contact(work, count, model):
    """No Taylor series crosses where particles come into contact, and no rounding."""
    endless, eight = work.dtype.type(np.inf), work.dtype.type(8)
    for k in range(count):
        separation = work[SEPARATION + k]
        alpha = (separation - work[MEAN + k]) * work[PER_SPREAD + k] - model.moment.start
        close = min(abs(alpha), abs(alpha + work[SHIFT + k]))
        unsure = abs(work[STEP + k]) + eight * model.rounding * separation
        stays = unsure * work[PER_SPREAD + k] < close
        work[LEFT + k] = work[LEFT + k] if stays else endless


@STAGE
def _move_areas(work, results, count, model):
    """Areas after the step."""
    zero, half, one = work.dtype.type(0), work.dtype.type(0.5), work.dtype.type(1)
    invalid = work.dtype.type(np.nan)
    for k in range(count):
        step = work[STEP + k]
        square = half * step * step
        area, area_1 = work[SUMMIT_AREA + k], work[SUMMIT_AREA + STRIDE + k]
        moved = area + area_1 * step
        bare = (
            (one - work[COVERED + k]) * (moved + work[SUMMIT_AREA + STRIDE + STRIDE + k] * square)
            - work[COVERED + STRIDE + k] * step * moved
            - work[COVERED + STRIDE + STRIDE + k] * square * area
        )
        touching = work[TOUCHING + k] + work[TOUCHING + STRIDE + k] * step
        touching = max(touching + work[TOUCHING + STRIDE + STRIDE + k] * square, zero)
        particles, surfaces = np.float64(touching), np.float64(bare) * model.area_unit
        together = particles + surfaces
        results[TOTAL_AREA + k] = together
        results[PARTICLE_SHARE + k] = particles / together
        results[SURFACE_SHARE + k] = surfaces / together
        work[ERROR + k] = work[ERROR + k] if together > model.least_area else invalid


@STAGE
def _move_loads(work, results, count, model):
    """Loads after the step, and the separation; no bound on the error before the last."""
    half = work.dtype.type(0.5)
    for k in range(count):
        step = work[STEP + k]
        square = half * step * step
        solid = work[SOLID + k] + work[SOLID + STRIDE + k] * step
        solid = np.float64(solid + work[SOLID + STRIDE + STRIDE + k] * square)
        film = work[FILM + k] + work[FILM + STRIDE + k] * step
        film = np.float64(film + work[FILM + STRIDE + STRIDE + k] * square)
        total = solid + film
        results[SOLID_SHARE + k] = solid / total
        results[FLUID_SHARE + k] = film / total
        results[GAP + k] = work[SEPARATION + k]
        results[BOUND + k] = work[ERROR + k] if work[LEFT + k] <= model.allowed else np.nan
