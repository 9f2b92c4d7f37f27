"""What the compiled loop knows of a surface: tables of everything that depends on one variable."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import lru_cache

import numpy as np

from thirdbody.model.film import Film
from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import sampled_contact, unit_moment
from thirdbody.solver.compiled.loop import ROOT, Model, OctaveTable, Table
from thirdbody.solver.roots import NOISE
from thirdbody.solver.solution import ROOT_SHARE
from thirdbody.solver.surfaces import RoughSurface
from thirdbody.solver.tabulation import chebyshev_points, interpolants

SINGLE, DOUBLE = np.float32, np.float64
INTEGERS = {SINGLE: np.int32, DOUBLE: np.int64}  # of the same size
SINGLE_RTOL = 1e-3  # from which numbers of half the size have digits enough for most points
# by degree: pieces a unit of t, pieces a unit of alpha, pieces an octave of a film's thickness
PIECES = {3: (16, 48, 32), 5: (32, 16, 64), 7: (16, 16, 32)}
MOMENT_START = -9.0  # alpha where all particles are larger
FILM_OCTAVES = -9, 21  # of H_c over that where the terms of Eq. 7 are equal
LOAD_OCTAVES = -110, 2  # first guesses: of F_t*,
ROOT_OCTAVES = -12, 12  # of the root of W, where the terms are equal, over that of all loads,
AREA_OCTAVES = -24, 2  # and of the particles' area over that of M = 1
GUESS_PIECES = 8
LEVEL_ERROR = 5e-14  # of where the terms of Eq. 7 are equal, a quotient of small differences
# what rounding does to a number, and which are so small that they have lost digits, or will; single
# precision holds the summits' area 2^96-fold
LIMITS = {
    SINGLE: {
        "rounding": np.finfo(SINGLE).eps,
        "least": 1e-36,
        "least_bare": 0.05,
        "least_area": 1e-30,
        "area_root": 64.0,
    },
    DOUBLE: {
        "rounding": np.finfo(DOUBLE).eps,
        "least": 0.0,
        "least_bare": 1e-6,
        "least_area": 1e-290,
        "area_root": 1.0,
    },
}


def precisions(rtol: float) -> tuple:
    """Types of number to try in turn for a relative error ``rtol``."""
    return (SINGLE, DOUBLE) if rtol >= SINGLE_RTOL else (DOUBLE,)


@lru_cache(maxsize=64)
def prepare_model(rough: RoughSurface, parameters: Parameters, rtol: float, real: type) -> Model:
    """Tables of everything on one surface, for errors of ``rtol``, in numbers of type ``real``."""
    degree = 3 if real is SINGLE else rough.tables.log_load.degree
    summit_pieces, moment_pieces, film_pieces = PIECES[degree]
    rounding = float(LIMITS[real]["rounding"])
    first, last = rough.tables.log_load.start, rough.tables.log_load.end
    summits = first, last, summit_pieces, degree, real
    load, load_error = _table(_root(lambda t: rough.tables.log_load(t)[0]), *summits)
    area, area_error = _table(_root(lambda t: rough.tables.log_area(t)[0]), *summits)
    table_error = rough.tables.error + ROOT * max(load_error, area_error)
    # rounding at the largest t, which the loop counts by itself where a point is
    rounded = 3.0 * np.finfo(float).eps * abs(rough.tables.log_load(np.full(1, last))[0][0])
    end = parameters.truncation
    moment, moment_error = _table(
        _moment_above(unit_moment(parameters), end),
        *(end, end - math.ceil(end - MOMENT_START), -moment_pieces, degree, real),
        outside=0.0,
    )
    moment_error += rounding
    unit_film = _unit_film(parameters)
    film, film_error = _octave_table(_root(unit_film.load_parameter), film_pieces, degree, real)
    surface = rough.surface
    deviation = surface.summit_deviation / surface.roughness
    offset = surface.summit_offset / surface.roughness
    t = np.linspace(last, first, 1000)
    loads, separations = rough.tables.log_load(t)[0], offset + deviation * t
    areas, alpha = sampled_contact(parameters)
    areas = areas / parameters.hardness_surface_2
    numbers = {
        "summit_error": max(table_error - rounded, 0.0) + 2.0 * ROOT * rounding,
        "film_error": ROOT * (film_error + 6.0 * rounding),  # with those of powers of viscosity
        "level_error": max(4.0 * rounding, LEVEL_ERROR),
        "moment_error": moment_error,
        "slope_error": 2.0 * degree**2 * moment_error,
        "per_deviation": 1.0 / deviation,
        "offset": offset,
        "elastic": -parameters.readings.elastic_limits.side * parameters.elastic_factor,
        "pressure": parameters.hardness_surface_1 / parameters.elastic_modulus_surfaces,
        "coverage": parameters.hardness_surface_1 / parameters.hardness_surface_2,
        "contacting": parameters.readings.coverage_limits.contacting,
        "allowed": ROOT_SHARE * rtol,
        "noise": max(NOISE, 8.0 * rounding),
        **LIMITS[real],
    }
    return Model(
        degree=degree,
        summits=load._replace(rows=np.hstack([load.rows, area.rows])),
        moment=moment,
        film=film,
        summits_alone=_guesses(
            lambda load: np.interp(np.log(load), loads, separations), LOAD_OCTAVES, real
        ),
        film_alone=_guesses(
            lambda root: unit_film.thickness(-ROOT * np.log(root))[0], ROOT_OCTAVES, real
        ),
        particles_alone=_guesses(lambda area: np.interp(area, areas, alpha), AREA_OCTAVES, real),
        area_unit=LIMITS[real]["area_root"] ** -ROOT,
        **{name: real(number) for name, number in numbers.items()},
    )


def _moment_above(moment_of, end):
    """The function of alpha that M is, less M at the ``end``: next to that an integral of its slope,
    because a difference would lose its digits."""
    nodes, weights = np.polynomial.legendre.leggauss(16)

    def above(alpha):
        half = 0.5 * (end - alpha)
        slopes = moment_of(end - half[..., None] * (1.0 - nodes))[1]
        close = -half * (weights * slopes).sum(-1)
        return np.where(half < 0.5, close, moment_of(alpha)[0] - moment_of(end)[0])

    return above


def _root(logarithm):
    """The function that is the root, as tables hold it, of what has this ``logarithm``."""
    return lambda x: np.exp(logarithm(x) / ROOT)


def _unit_film(parameters):
    """The film whose terms are equal at W = 1, and 1 there: all films of one ellipticity, seen from
    where their terms are equal."""
    one = np.ones(1)
    return replace(Film.of(one, one, parameters), smooth=0.0, rough=0.0)


def _table(function, start, end, pieces, degree, real, outside=np.nan):
    """``Table`` with so many pieces a unit, negative if they are counted downwards, and its largest
    relative error in the middle of one."""
    centres = start + (np.arange(round((end - start) * pieces)) + 0.5) / pieces
    halves = np.full(centres.size, 0.5 / pieces)
    rows, error = _rows_and_error(function, centres, halves, degree, real, outside)
    return Table(rows, real(start), real(pieces)), error


def _octave_table(function, pieces, degree, real):
    """``OctaveTable`` with so many pieces an octave, and its largest relative error."""
    edges = _octave_edges(*FILM_OCTAVES, pieces)
    halves = 0.5 * np.diff(edges)
    rows, error = _rows_and_error(function, edges[:-1] + halves, halves, degree, real, np.nan)
    return OctaveTable(rows, *_bits(FILM_OCTAVES[0], pieces, real), pieces), error


def _rows_and_error(function, centres, halves, degree, real, outside):
    """Polynomials of pieces, one a row, and a last row of what holds outside."""
    x = centres + halves * np.append(chebyshev_points(degree), 0.0)[:, None]
    *at_nodes, middle = function(x)
    powers = interpolants(at_nodes)
    rows = np.concatenate([powers.T, np.zeros((1, degree + 1))]).astype(real)
    rows[-1, 0] = outside
    return rows, np.abs(middle / powers[0] - 1.0).max()


def _guesses(function, octaves, real):
    """``OctaveTable`` of value and difference over a piece."""
    values = function(_octave_edges(*octaves, GUESS_PIECES))
    rows = np.stack([values[:-1], np.diff(values)], axis=1).astype(real)
    return OctaveTable(rows, *_bits(octaves[0], GUESS_PIECES, real), GUESS_PIECES)


def _octave_edges(start, end, pieces):
    """Edges of pieces of equal width within the octaves from 2^start to 2^end."""
    within = 1.0 + np.arange(pieces) / pieces
    return np.append((2.0 ** np.arange(start, end)[:, None] * within).ravel(), 2.0**end)


def _bits(start, pieces, real):
    """The bits of 2^start but those within a piece, how many these are, and 1 over their range."""
    shift = np.finfo(real).nmant - int(math.log2(pieces))
    first = int(np.array(2.0**start, real).view(INTEGERS[real])) >> shift
    return first, shift, real(2.0**-shift)
