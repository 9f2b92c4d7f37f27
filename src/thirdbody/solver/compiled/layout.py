"""What the compiled loop works on: rows of numbers, tables of a sheet, and the block of points.

Lengths are in units of sigma, loads in units of F_t, areas in units of A_n.  Tables hold not a load
or an area but its root of order ``ROOT``, which is an ordinary number where the load is e^-800.
"""

from __future__ import annotations

from functools import lru_cache
from threading import local
from typing import NamedTuple

import numpy as np

# Points in a block.  Rows as long as a power of two would fight for the same lines of the cache.
WIDTH = 496
SQUARINGS = 4
ROOT = 2**SQUARINGS
MOST_COEFFICIENTS = 8  # of a polynomial
CELL_TERMS = {3: 4, 5: 8, 7: 10}  # powers of the place in a cell, by degree

# Rows of ``given`` and of the columns that it is taken from: what is known of a point.
PER_LOAD = 0  # 1/F_t*
MEAN = 1  # m/sigma of the sizes of particles
PER_SPREAD = 2  # sigma/S
ELASTIC_SHIFT = 3  # from alpha at d to alpha at the other limit of the elastic integral, d -+ h_e
PLASTIC_AREA = 4  # A_sa/A_n where all particles are plastic and the moment is 1
BARE = 5  # the bracket of Eq. 4 if it counts all sizes; 1 if it counts those that touch
PER_CROSSING = 6  # sigma/h_c where both terms of Eq. 7 are equal
CROSSING_ROOT = 7  # root of F_f/F_t there
# in their place of a film whose thickness is known, because F_t determines it:
FILM_GAP = 6  # d/sigma that it keeps
FILM_ERROR = 7  # relative error of that
OFFSET = 8  # y_s/sigma
PER_DEVIATION = 9  # sigma/sigma_s
SUMMIT_PARAMETER = 10  # eta_s R sigma_s
PLACE = 11  # of w_1 between the ends of the sheet's cell, from -1 to 1
GIVEN = 12

# Rows of ``work``: single numbers that change from step to step.
SEPARATION = 0  # d/sigma
POSITION = 1  # what is looked up in a table
ELASTIC_POSITION = 2  # the same at the other limit of the elastic integral
LOCAL = 3  # where within the piece of a table, from -1 to 1
HALF_PIECES = 4  # from zero to there in an ``OctaveTable``, counted in half pieces
STEP = 5  # by which the separation changes
REMAINDER = 6  # relative error that the Taylor series after this step leave
STEEPEST = 7  # largest relative slope of the results
LOAD_ERROR = 8  # of F_s + F_f, by tables and rounding
SLOPE_ERROR = 9  # of the slope of F_s + F_f
PART_ERROR = 10  # relative, of single loads and areas
ERROR = 11  # relative, of all results
UNSURE = 12  # what F_s + F_f may be wrong by
WORK = 13

# Rows of ``series``: quantities that become Taylor series about d,
SUMMITS = 0  # root of F_ss*, still in the variable of its table
SUMMIT_AREA = 1  # A_ss as if there were no particles; its root before
MOMENT = 2  # of the sizes above d, in the variable of its table
ELASTIC_MOMENT = 3  # the same at the other limit of the elastic integral
SOLID = 4  # F_s
FILM = 5  # F_f; its root before
TOUCHING = 6  # A_sa
COVERED = 7  # share of the interface under particles larger than d, as Eq. 5 subtracts it
SERIES = 8
# and the terms of each: the value, its slope and half of its second derivative.
VALUE, SLOPE, CURVE = 0, 1, 2
TERMS = 3

# Rows of the results.
TOTAL_AREA = 0  # A_t*
PARTICLE_SHARE = 1  # A_sa,t*
SURFACE_SHARE = 2  # A_ss,t*
SOLID_SHARE = 3  # L_s
FLUID_SHARE = 4  # L_f
GAP = 5  # d/sigma
BOUND = 6  # on the relative error of the others, nan where no solution was found
RESULTS = 7


class Table(NamedTuple):
    """Polynomials on pieces of equal width; the last row is what holds outside of all pieces.

    A row holds coefficients of powers of where a point is in its piece, -1 to 1, for each power of
    its ``PLACE`` on the sheet.
    """

    rows: np.ndarray  # shape (pieces + 1, terms, coefficients)
    start: float
    scale: float  # pieces a unit, negative where they are counted downwards


class OctaveTable(NamedTuple):
    """Polynomials on pieces of equal width within each octave of a positive variable.

    The leading bits of a number tell its piece, so that no logarithm is needed.  The last row is
    what holds outside of all pieces.  Rows are those of a ``Table``, or, where first guesses are
    read off, pairs of a value and its change over the piece.
    """

    rows: np.ndarray
    first: int  # leading bits of the number at which the first piece begins
    shift: int  # how many bits are left to tell the place within a piece
    within: float  # width of a piece over the number of places in it
    pieces: int  # an octave


class SummitModel(NamedTuple):
    """Summits in contact with no particles between the surfaces, whose eta_s R sigma_s is 1."""

    table: Table  # roots of F_ss* and A_ss/A_n, side by side in a row, of t = (d - y_s)/sigma_s
    alone: OctaveTable  # first guess of t of F_t*, if they bear it alone
    error: float  # relative, of loads and areas
    area_root: float  # factor of the root of areas: the smallest must stay ordinary numbers
    area_unit: float  # factor by which an area so enlarged becomes one of A_n


class ParticleModel(NamedTuple):
    """Particles between the surfaces."""

    table: Table  # the moment, from the largest size downwards
    alone: OctaveTable  # first guess of alpha, of the moment
    of_all: float  # the moment of all sizes, the largest that there is
    error: float  # of the moment, relative to it and its slope
    slope_error: float  # of its slope
    smallest: float  # alpha of the smallest size, next to which moments hardly fall
    smallest_third: float  # and what the third derivative of the moment has there, besides
    own_weight: float  # of the moment at d in A_sa
    other_weight: float  # and of that at the other limit of the elastic integral
    bears_here: float  # by how much more moment d needs to bear a load by itself
    bears_there: float  # the same for the other limit
    pressure: float  # F_sa/(A_sa E_ss)
    coverage: float  # coverage of Eq. 5 over the area of particles that are all plastic
    contacting: float  # 1 if the bracket of Eq. 4 is that of Eq. 5, else 0


class FilmModel(NamedTuple):
    """The film, in units of where both terms of Eq. 7 are equal; then all films are one curve."""

    table: OctaveTable  # root of F_f of d
    alone: OctaveTable  # first guess of d of the root of 1/F_f, if it bears the load alone
    error: float  # relative, of loads
    crossing_error: float  # relative, of the thickness that is the unit


class Limits(NamedTuple):
    """How exact the results are to be, and how exact numbers are."""

    allowed: float  # relative error that Taylor series may leave
    noise: float  # relative rounding error of a load
    rounding: float  # relative rounding error of a number
    least: float  # a smaller number has not all of its digits
    least_bare: float  # a smaller bare share of the interface has lost too many digits
    least_area: float  # a smaller A_t* has lost too many digits


class Model(NamedTuple):
    """What all points on one sheet share; numbers are of the type of the points'."""

    degree: int  # 3, 5 or 7, of all polynomials but first guesses, which are lines
    summits: SummitModel
    particles: ParticleModel
    film: FilmModel
    limits: Limits


class Blocks(local):
    """Blocks for points of each kind, made once by each thread."""

    def __init__(self):
        self.of = lru_cache(make_block)


def make_block(real: type, integer: type, *kind: bool) -> np.void:
    """Room for the points of a block.

    Parameters
    ----------
    real, integer : type
        Types of numbers that are of one size, for instance ``numpy.float64`` and ``numpy.int64``.
    *kind : bool
        What distinguishes points that need a block of their own, because other rows stay zero.

    Returns
    -------
    numpy.void
        A record of arrays, all zero: what is missing bears and covers nothing.  The compiler reads
        their shapes in its type, and so knows that no two rows overlap; that halves the time.

    Notes
    -----
    numba names machine code after the types of its arguments, but a record after a number that
    another process may give to another record.  Each function that takes a block therefore takes
    something else in numbers of type ``real``, by which its names for both precisions differ.
    """
    fields = [
        ("given", real, (GIVEN, WIDTH)),
        ("work", real, (WORK, WIDTH)),
        ("series", real, (SERIES, TERMS, WIDTH)),
        ("coefficients", real, (MOST_COEFFICIENTS, WIDTH)),
        ("pieces", integer, (WIDTH,)),  # which row of a table a point looks up
        ("results", np.float64, (RESULTS, WIDTH)),
        ("places", np.uintp, (WIDTH,)),  # column that a point was taken from
    ]
    return np.zeros((), np.dtype(fields, align=True))[()]
