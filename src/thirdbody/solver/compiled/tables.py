"""What the compiled loop knows of a sheet: a table of whatever depends on one variable.

These are the summits' load and area, functions of t = (d - y_s)/sigma_s; the second moment M of the
sizes of particles, a function of alpha = (d - m)/S; and the load of a film, a function of its
thickness.  Further tables hold the first guess of the separation.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from thirdbody.model.film import Film
from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import LOWEST, Moment, parts_bearing
from thirdbody.solver.compiled.layout import (
    CELL_TERMS,
    ROOT,
    FilmModel,
    Limits,
    Model,
    OctaveTable,
    ParticleModel,
    SummitModel,
    Table,
)
from thirdbody.solver.solution import ROOT_SHARE
from thirdbody.solver.surfaces import Sheet, prepare_tables, table_size
from thirdbody.solver.tabulation import ELSEWHERE, chebyshev_points, interpolants

SINGLE, DOUBLE = np.float32, np.float64
INTEGERS = {SINGLE: np.int32, DOUBLE: np.int64}  # of the same size
SINGLE_RTOL = 1e-3  # from which single precision has digits enough for most points

# Pieces of tables by their degree: in a unit of t, in a unit of alpha, in an octave of thickness.
PIECES = {3: (16, 48, 32), 5: (32, 16, 64), 7: (16, 16, 32)}
# Tables over octaves reach from one power of two to another:
FILM_OCTAVES = -9, 21  # of h_c over that where both terms of Eq. 7 are equal,
LOAD_OCTAVES = -110, 8  # of F_t* over eta_s R sigma_s,
ROOT_OCTAVES = -12, 12  # of the root of W where both terms are equal, over W of F_t,
AREA_OCTAVES = -24, 2  # and of the area of particles over that where M = 1.
GUESS_PIECES = 8  # of an octave

# Root of loads and areas beyond the last t: an area that is a number 2^256-fold, and zero in float64
NOTHING = 3e-23

NOISE = 1e-14  # of a load in double precision
CROSSING_ERROR = 5e-14  # of where the terms of Eq. 7 are equal, a quotient of small differences

# Numbers smaller than these have lost digits, or will.
SMALLEST = {
    SINGLE: {"least": 1e-36, "least_bare": 0.05, "least_area": 1e-30},
    DOUBLE: {"least": 1e-290, "least_bare": 1e-6, "least_area": 1e-290},
}
# Areas are held 2^96-fold and 2^256-fold: they are smaller than numbers can be.
AREA_ROOT = {SINGLE: 64.0, DOUBLE: 65536.0}


def precisions(rtol: float) -> tuple[type, ...]:
    """Types of number that are worth trying, the fastest first.

    Parameters
    ----------
    rtol : float
        Relative error asked for.

    Returns
    -------
    tuple of type
        ``SINGLE`` or ``DOUBLE`` or both; points that need more digits are left by the first.
    """
    return (SINGLE, DOUBLE) if rtol >= SINGLE_RTOL else (DOUBLE,)


@lru_cache(maxsize=128)
def prepare_model(sheet: Sheet, parameters: Parameters, rtol: float, real: type) -> Model:
    """What all points on one sheet share, prepared once.

    Parameters
    ----------
    sheet : Sheet
        The sheet of their surfaces.
    parameters : Parameters
        Inputs of the model.
    rtol : float
        Relative error asked for.
    real : type
        Type of number that points are solved in, ``SINGLE`` or ``DOUBLE``.

    Returns
    -------
    Model
        Tables and numbers for the loop.
    """
    degree = 3 if real is SINGLE else table_size(rtol)[1]
    return Model(
        degree=degree,
        summits=_summits(sheet, rtol, degree, real),
        particles=_particles(parameters, degree, real),
        film=_film(parameters, degree, real),
        limits=Limits(
            allowed=real(ROOT_SHARE * rtol),
            noise=real(max(NOISE, 8.0 * _rounding(real))),
            rounding=real(_rounding(real)),
            **{name: real(number) for name, number in SMALLEST[real].items()},
        ),
    )


@lru_cache(maxsize=128)
def _summits(sheet, rtol, degree, real) -> SummitModel:
    """The summits of the surfaces on a sheet."""
    tables, rounding = prepare_tables(sheet, rtol), _rounding(real)
    first, last = tables.log_load.start, tables.log_load.end
    size = first, last, PIECES[degree][0], degree
    places = chebyshev_points(CELL_TERMS[degree] - 1) if sheet.is_cell else [0.0]
    sides, errors = zip(
        *(_summit_rows(curve, places, *size) for curve in (tables.log_load, tables.log_area)),
        strict=True,
    )
    error = tables.error + ROOT * max(errors)
    t = np.linspace(*tables.log_load.centres[[-1, 0]], 1000)
    loads = tables.log_load(t)[0]
    # rounding of t: this is at the largest, but the loop counts it where a point is
    rounded = 3.0 * np.finfo(float).eps * abs(loads[0])
    return SummitModel(
        table=Table(
            np.concatenate(sides, axis=-1).astype(real), real(first), real(PIECES[degree][0])
        ),
        alone=_guesses(lambda load: np.interp(np.log(load), loads, t), LOAD_OCTAVES, real),
        error=real(max(error - rounded, 0.0) + 2.0 * ROOT * rounding),
        area_root=real(AREA_ROOT[real]),
        area_unit=AREA_ROOT[real] ** -ROOT,
    )


def _summit_rows(curve, places, *size):
    """Rows of the root of a ``curve`` of t that is known at some places on a sheet, and their error."""
    curves = [curve.at(place) for place in (*places, 0.0)]
    found = [_rows(_root_of(lambda t, one=one: one(t)[0]), *size) for one in curves]
    (*at_places, middle), errors = zip(*found, strict=True)
    rows = interpolants(at_places)
    ends_and_centre = np.vander([-1.0, 0.0, 1.0], rows.shape[-1], increasing=True)
    between = np.abs((rows[0] - middle) @ ends_and_centre.T).max(axis=-1) / middle[:, 0]
    return _with_outside(rows.swapaxes(0, 1), NOTHING, np.nan), max(errors) + between.max()


@lru_cache(maxsize=64)
def _particles(parameters, degree, real) -> ParticleModel:
    """Particles of any size and density."""
    moment = Moment.of_all_layers(parameters)
    lowest = max(moment.smallest, LOWEST)
    pieces = math.ceil((moment.largest - lowest) * PIECES[degree][1])
    scale = -pieces / (moment.largest - lowest)
    size = moment.largest, lowest, scale, degree
    rows, error = _rows(lambda alpha: moment(alpha)[0], *size)
    # a piece for all smaller sizes, which there are none of, and one for the larger ones
    rows = _with_outside(rows[:, None], moment.of_all, 0.0).astype(real)
    table = Table(rows, real(moment.largest), real(scale))
    error += _rounding(real)
    limits, contacting = parameters.readings.elastic_limits, parameters.readings.coverage_limits
    own, other = limits.weights(parameters.elastic_factor)
    here, there = parts_bearing(parameters)
    return ParticleModel(
        table=table,
        alone=_guesses(lambda part: np.interp(part, *moment.samples()), AREA_OCTAVES, real),
        of_all=real(moment.of_all),
        error=real(error),
        slope_error=real(2.0 * degree**2 * error),
        smallest=real(moment.smallest),
        smallest_third=real(_third_of_smallest(moment)),
        own_weight=real(own),
        other_weight=real(other),
        bears_here=real(here),
        bears_there=real(there),
        pressure=real(parameters.particle_pressure),
        coverage=real(parameters.hardness_surface_1 / parameters.hardness_surface_2),
        contacting=real(contacting.contacting),
    )


@lru_cache(maxsize=64)
def _film(parameters, degree, real) -> FilmModel:
    """Films of any viscosity: seen from where both terms of Eq. 7 are equal, all are one curve."""
    rounding, one = _rounding(real), np.ones(1)
    unit = replace(Film.of(one, one, parameters), smooth=0.0, rough=0.0)  # both are 1 at W = 1
    table, error = _octave_table(_root_of(unit.load_parameter), PIECES[degree][2], degree, real)
    return FilmModel(
        table=table,
        alone=_guesses(lambda root: unit.thickness(-ROOT * np.log(root))[0], ROOT_OCTAVES, real),
        error=real(ROOT * (error + 6.0 * rounding)),  # with those of powers of viscosity
        crossing_error=real(max(4.0 * rounding, CROSSING_ERROR)),
    )


def _rounding(real):
    """Relative rounding error of a number."""
    return float(np.finfo(real).eps)


def _third_of_smallest(moment):
    """Largest third derivative of the moment of the smallest sizes, from differences of slopes."""
    alpha = np.linspace(moment.smallest, moment.smallest + 0.5, 101)
    _, slopes = moment(alpha[1:-1])
    return np.abs(np.diff(slopes, 2)).max() / (alpha[1] - alpha[0]) ** 2


def _root_of(logarithm):
    """The function that is the root, as tables hold it, of what has this ``logarithm``."""
    return lambda x: np.exp(logarithm(x) / ROOT)


def _rows(function, start, end, pieces, degree) -> tuple[NDArray, float]:
    """Rows of a ``Table`` of a function, but for those outside, and a bound on its relative error.

    It has so many ``pieces`` a unit, negative if they are counted downwards from ``start``.
    """
    centres = start + (np.arange(round((end - start) * pieces)) + 0.5) / pieces
    return _polynomials(function, centres, np.full(centres.size, 0.5 / pieces), degree)


def _octave_table(function, pieces, degree, real) -> tuple[OctaveTable, float]:
    """Table of a function of thickness, and a bound on its relative error.

    It has so many ``pieces`` an octave, a power of two.
    """
    edges = _octave_edges(*FILM_OCTAVES, pieces)
    halves = 0.5 * np.diff(edges)
    rows, error = _polynomials(function, edges[:-1] + halves, halves, degree)
    rows = _with_outside(rows[:, None], np.nan).astype(real)
    return OctaveTable(rows, *_bits(FILM_OCTAVES[0], pieces, real), pieces), error


def _polynomials(function, centres, halves, degree):
    """Polynomials on pieces of given centres and half widths, one a row, and their error."""
    x = centres + halves * np.append(chebyshev_points(degree), 0.0)[:, None]
    *at_nodes, middle = function(x)
    powers = interpolants(at_nodes)
    return powers.T, ELSEWHERE * np.abs(middle / powers[0] - 1.0).max()


def _with_outside(rows, *values):
    """Rows followed by one for each of the constant ``values``, which hold outside of them."""
    outside = np.zeros((len(values), *rows.shape[1:]))
    outside[:, 0, 0] = values
    return np.concatenate([rows, outside])


def _guesses(function: Callable, octaves, real) -> OctaveTable:
    """Table of first guesses, with two columns: values, and their differences over a piece."""
    values = function(_octave_edges(*octaves, GUESS_PIECES))
    rows = np.stack([values[:-1], np.diff(values)], axis=1).astype(real)
    return OctaveTable(rows, *_bits(octaves[0], GUESS_PIECES, real), GUESS_PIECES)


def _octave_edges(start, end, pieces) -> NDArray:
    """Edges of pieces that are of equal width within each octave from 2^start to 2^end."""
    within = 1.0 + np.arange(pieces) / pieces
    return np.append((2.0 ** np.arange(start, end)[:, None] * within).ravel(), 2.0**end)


def _bits(start, pieces, real):
    """``first``, ``shift`` and ``within`` of an ``OctaveTable`` that begins at 2^start."""
    shift = np.finfo(real).nmant - int(math.log2(pieces))
    first = int(np.array(2.0**start, real).view(INTEGERS[real])) >> shift
    return first, shift, real(2.0**-shift)
