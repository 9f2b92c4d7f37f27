"""Tables in the compiled loop: a row of numbers looked up, with slope and curvature.

All take the ``block`` of points and the ``count`` of points that are left in its first columns.
"""

from __future__ import annotations

import numpy as np

from thirdbody.solver.compiled.layout import (
    CELL_TERMS,
    CURVE,
    HALF_PIECES,
    LOCAL,
    PLACE,
    POSITION,
    ROOT,
    SLOPE,
    SQUARINGS,
    VALUE,
)
from thirdbody.solver.compiled.machine_code import stage


@stage
def look_up_guess(block, count, table, position):
    """``LOCAL`` becomes what an ``OctaveTable`` of values and differences holds at the numbers in row
    ``position``."""
    work, pieces = block.work, block.pieces
    bits, last = work[position].view(pieces.dtype), table.rows.shape[0] - 1
    for k in range(count):
        piece = (bits[k] >> table.shift) - table.first
        pieces[k] = min(max(piece, 0), last)
        work[LOCAL, k] = work.dtype.type(bits[k] & ((1 << table.shift) - 1)) * table.within
    for k in range(count):
        piece = np.uintp(pieces[k])
        work[LOCAL, k] = table.rows[piece, 0] + table.rows[piece, 1] * work[LOCAL, k]


@stage
def find_piece(block, count, table, position):
    """Which piece of a ``Table`` holds the numbers in row ``position``, and where within it."""
    work, pieces = block.work, block.pieces
    real, last = work.dtype.type, table.rows.shape[0] - 1
    zero, one, end = real(0), real(1), real(last)
    for k in range(count):
        place = work[position, k]
        inside = (place >= zero) & (place < end)
        piece = np.int32(place if inside else end)
        pieces[k] = piece
        local = place - real(piece)
        work[LOCAL, k] = local + local - one


@stage
def find_octave_piece(block, count, table):
    """Which piece of an ``OctaveTable`` holds ``POSITION``, where within it and within the octave."""
    work, pieces = block.work, block.pieces
    bits, last = work[POSITION].view(pieces.dtype), table.rows.shape[0] - 1
    real = work.dtype.type
    one, within = real(1), table.within + table.within
    before = real(2 * table.pieces + 1)  # half pieces from zero to the middle of an octave's first
    for k in range(count):
        place = (bits[k] >> table.shift) - table.first
        inside = (place >= 0) & (place < last)
        pieces[k] = place if inside else last
        local = real(bits[k] & ((1 << table.shift) - 1)) * within - one
        work[LOCAL, k] = local
        work[HALF_PIECES, k] = local + (before + real(2 * (place & (table.pieces - 1))))


def _reader(degree, terms):
    """Stage that evaluates polynomials of a degree, and so many terms in the place on the sheet: the
    compiler unrolls loops of known length."""

    @stage
    def read(block, count, rows, first, into):
        given, work, series = block.given, block.work, block.series
        coefficients, pieces = block.coefficients, block.pieces
        zero = work.dtype.type(0)
        for k in range(count):
            piece, place = np.uintp(pieces[k]), given[PLACE, k]
            for power in range(degree + 1):
                coefficient = rows[piece, terms - 1, first + power]
                for term in range(2, terms + 1):
                    coefficient = coefficient * place + rows[piece, terms - term, first + power]
                coefficients[power, k] = coefficient
        for k in range(count):
            local = work[LOCAL, k]
            value, slope, curve = coefficients[degree, k], zero, zero
            for power in range(degree):
                curve = curve * local + slope
                slope = slope * local + value
                value = value * local + coefficients[degree - 1 - power, k]
            series[into, VALUE, k] = value
            series[into, SLOPE, k] = slope
            series[into, CURVE, k] = curve

    return read


# of tables of one variable,
_read_3, _read_5, _read_7 = _reader(3, 1), _reader(5, 1), _reader(7, 1)
# and of the summits of a cell
_read_cell_3, _read_cell_5, _read_cell_7 = (_reader(each, CELL_TERMS[each]) for each in (3, 5, 7))


@stage
def look_up(block, count, rows, degree, first, into):
    """Series ``into`` become the polynomials whose coefficients start in column ``first``."""
    if degree == 3:
        _read_3(block, count, rows, first, into)
    elif degree == 5:
        _read_5(block, count, rows, first, into)
    else:
        _read_7(block, count, rows, first, into)


@stage
def look_up_summits(block, count, rows, degree, first, into):
    """The same in the table of the summits, of one w_1 or of a cell."""
    if rows.shape[1] == 1:
        look_up(block, count, rows, degree, first, into)
    elif degree == 3:
        _read_cell_3(block, count, rows, first, into)
    elif degree == 5:
        _read_cell_5(block, count, rows, first, into)
    else:
        _read_cell_7(block, count, rows, first, into)


@stage
def power(root):
    """What has this ``root``."""
    for _ in range(SQUARINGS):
        root = root * root
    return root


@stage
def relative_terms(series, quantity, k, inner):
    """Slope and half curvature, both over the value, of a ``quantity`` whose root is in ``series``.

    ``inner`` is the slope of the variable of its table.
    """
    order, less = series.dtype.type(ROOT), series.dtype.type(ROOT - 1)
    per_value = inner / series[quantity, VALUE, k]
    slope = series[quantity, SLOPE, k] * per_value
    curve = series[quantity, CURVE, k] * per_value * inner
    return order * slope, order * (curve + curve + less * slope * slope)
