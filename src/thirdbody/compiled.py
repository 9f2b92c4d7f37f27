"""Many points on one surface: a compiled loop over tables.

Whatever depends on one variable is read from a table: the summits' load and area from t, the
second moment of the particles from alpha, the load of a film from its thickness.  What is left to
do at a point is the balance of forces (Eqs. 1, 2 and 4), as a sum instead of the difference of
logarithms by which ``thirdbody.balance`` survives extremes.  Points for which this loop cannot
promise the error asked for are left to ``thirdbody.solution``.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numba import njit

from thirdbody.balance import Points, RoughSurface
from thirdbody.film import Film
from thirdbody.parameters import Parameters
from thirdbody.particles import ELASTIC_LIMITS, sampled_contact, unit_moment
from thirdbody.regimes import contact_mode, lubrication_regime
from thirdbody.roots import NOISE
from thirdbody.solution import CONVERGED, OUTSIDE_FILM_FORMULA, ROOT_SHARE
from thirdbody.tabulation import PiecewisePolynomial

EPSILON = np.finfo(float).eps
TOGETHER = 32  # points that take their steps side by side
# what is known of a point after an evaluation: loads and areas with slope and curvature
STATE = np.dtype(
    [
        (name, float)
        for quantity in ("x log_x step left error t", "solid solid_1 solid_2", "film film_1 film_2")
        + ("area area_1 area_2", "covered covered_1 covered_2")
        for name in quantity.split()
    ]
)
STEPS = 8  # a point that needs more is better left to bisection
LEAST_BARE = 1e-6  # of the interface, left to summits: less is a difference that lost its digits
LEAST_AREA = 1e-290  # of A_n; smaller ones have not all digits of float64
MOMENT_START, MOMENT_PIECES = -9.0, 16  # alpha where all particles are larger; pieces a unit
FILM_START, FILM_END, FILM_PIECES = -6.0, 14.0, 160  # ln H_c from where Eq. 7's terms are equal
GUESS_DEGREE, GUESS_PIECES = 3, 96
SUMMITS_START, SUMMITS_END = -5.0, 12.0  # t of first guesses
AREA_START, AREA_END = -16.0, 1.0  # ln of the particles' area over that of M = 1, of first guesses
COMPILED = {"error_model": "numpy", "fastmath": {"contract"}, "nogil": True}


class Table(NamedTuple):
    """A ``PiecewisePolynomial`` with one piece a row."""

    rows: np.ndarray
    start: float
    scale: float

    @classmethod
    def of(cls, function, start: float, end: float, pieces: int, degree: int) -> Table:
        """Table of ``function`` as a ``PiecewisePolynomial`` takes it."""
        return cls.like(PiecewisePolynomial(function, start, end, pieces, degree))

    @classmethod
    def like(cls, polynomial: PiecewisePolynomial) -> Table:
        """The same polynomials."""
        rows = np.ascontiguousarray(polynomial.coefficients.T)
        return cls(rows, polynomial.start, polynomial.scale)


class Model(NamedTuple):
    """What all points on one surface share; lengths in units of sigma."""

    load: Table  # ln F_ss* of t
    area: Table  # ln(A_ss/A_n) of t
    moment: Table  # M of alpha
    film: Table  # ln F_f* of ln d, both from where the terms of Eq. 7 are equal
    summits_alone: Table  # t of ln F_t*
    particles_alone: Table  # alpha of ln of their area
    summit_error: float  # of the tables of load and area
    film_error: float
    moment_error: float
    per_deviation: float  # sigma/sigma_s
    offset: float  # y_s
    truncation: float
    largest: float  # M at X_max
    near: float  # limits of the elastic integral, in h_e about d
    far: float
    elastic_factor: float
    pressure: float  # F_sa/(A_sa E_ss)
    coverage: float  # coverage of Eq. 5 over the area of plastic particles
    contacting: bool  # Eq. 4 takes the coverage of Eq. 5


class Columns(NamedTuple):
    """What each point has of its own, 1-D; empty where there is no film or are no particles."""

    load: np.ndarray  # F_t*
    log_load: np.ndarray
    mean: np.ndarray  # m
    spread: np.ndarray  # S
    depth: np.ndarray  # h_e/S
    area: np.ndarray  # A_sa/A_n of plastic particles over M
    bare: np.ndarray  # share that particles of all sizes leave bare
    film_alone: np.ndarray  # d where the film bears everything
    film_level: np.ndarray  # ln d where the terms of Eq. 7 are equal
    film_load: np.ndarray  # ln F_f* there


@lru_cache(maxsize=64)
def prepare_model(rough: RoughSurface, parameters: Parameters) -> Model:
    """Tables of everything on one surface, as good as those that ``rough`` has."""
    surface, degree = rough.surface, rough.log_load.degree
    moment_of = unit_moment(parameters)
    moment = PiecewisePolynomial(
        moment_of,
        MOMENT_START,
        parameters.truncation,
        math.ceil(MOMENT_PIECES * (parameters.truncation - MOMENT_START)),
        degree,
    )
    film = PiecewisePolynomial(_film_curve(parameters), FILM_START, FILM_END, FILM_PIECES, degree)
    t = np.linspace(SUMMITS_END, SUMMITS_START, 10 * GUESS_PIECES)
    log_load = rough.log_load(t)[0]
    areas, alpha = sampled_contact(parameters)
    areas = areas / parameters.hardness_surface_2
    guess = GUESS_PIECES, GUESS_DEGREE
    near, far = ELASTIC_LIMITS[parameters.elastic_limits]
    return Model(
        load=Table.like(rough.log_load),
        area=Table.like(rough.log_area),
        moment=Table.like(moment),
        film=Table.like(film),
        summits_alone=Table.of(
            lambda x: (np.interp(x, log_load, t),), log_load[0], log_load[-1], *guess
        ),
        particles_alone=Table.of(
            lambda x: (np.interp(np.exp(x), areas, alpha),), AREA_START, AREA_END, *guess
        ),
        summit_error=rough.table_error,
        film_error=film.error,
        moment_error=moment.error,
        per_deviation=surface.roughness / surface.summit_deviation,
        offset=surface.summit_offset / surface.roughness,
        truncation=parameters.truncation,
        largest=float(moment_of(parameters.truncation)[0]),
        near=near,
        far=far,
        elastic_factor=parameters.elastic_factor,
        pressure=parameters.hardness_surface_1 / parameters.elastic_modulus_surfaces,
        coverage=parameters.hardness_surface_1 / parameters.hardness_surface_2,
        contacting=parameters.coverage_limits == "contacting",
    )


def _film_curve(parameters):
    """The function of ln H_c that ln W is, both from where the terms of Eq. 7 are equal."""
    one = np.ones(1)
    like = Film.of(one, one, parameters)

    def log_parameter(log_thickness):
        zero = np.zeros_like(log_thickness)
        film = Film(zero, zero, like.smooth_exponent, like.rough_exponent, like.turning_ratio)
        return (film.load_parameter(np.exp(log_thickness)),)

    return log_parameter


def _columns(points: Points) -> Columns:
    """What the loop needs of each of ``points``."""
    none = np.empty(0)
    sigma, parameters = points.rough.roughness, points.parameters
    sizes, films = (none,) * 5, (none,) * 3
    if points.particles is not None:
        layer = points.particles
        area = layer.share * parameters.hardness_surface_2
        bare = none if parameters.coverage_limits == "contacting" else np.exp(layer.log_bare)
        sizes = layer.mean / sigma, layer.spread / sigma, layer.depth, area, bare
    if points.film is not None:
        log_parameter, log_thickness = points.film.crossing()
        films = (
            points.film_separation(0.0)[0] / sigma,
            log_thickness + np.log(parameters.ball_radius / sigma),
            log_parameter - points.log_load_parameter(-points.log_load),
        )
    return Columns(np.exp(points.log_load), points.log_load, *sizes, *films)


class CompiledPoints:
    """What ``SolvedPoints`` is, by the compiled loop; all of ``left`` are to be solved by that.

    ``points`` have tables, and their film, if any, bears the fluid load.  Areas, and what follows
    from them, are only there if ``areas`` says that they are wanted.
    """

    def __init__(self, points: Points, rtol: float, areas: bool):
        self._points = points
        count = points.log_load.size
        rough, parameters = points.rough, points.parameters
        found = np.empty((7, count))
        _loop()(
            prepare_model(rough, parameters),
            _columns(points),
            points.particles is not None,
            points.film is not None,
            areas,
            ROOT_SHARE * rtol,
            NOISE,
            np.empty(TOGETHER, STATE),
            found,
        )
        self.total_contact_area, self.particle_contact_area_ratio = found[:2]
        self.surface_contact_area_ratio, self.solid_load_fraction = found[2:4]
        self.fluid_load_fraction, depth, self.error_bound = found[4:]
        self.separation = rough.roughness * depth
        self.left = ~(self.error_bound <= rtol)

    @property
    def film_thickness(self):
        return self.separation / self._points.parameters.ball_radius

    @property
    def lubrication_regime(self):
        return lubrication_regime(self.solid_load_fraction)

    @property
    def contact_mode(self):
        return contact_mode(self.particle_contact_area_ratio, self._points.particles is not None)

    @property
    def solution_status(self):
        points = self._points
        status = np.full(self.left.shape, CONVERGED, dtype=np.int8)
        if points.film is not None:
            parameter = points.log_load_parameter(np.log(self.fluid_load_fraction))
            status[~points.film.is_meaningful(parameter)] = OUTSIDE_FILM_FORMULA
        return status


@lru_cache(maxsize=1)
def _loop():
    """The loop in machine code, which is kept beside this file for later processes; so it must not
    contain a constant of another file."""
    try:
        return njit(**COMPILED, cache=True)(_solve_points)
    except RuntimeError:  # no folder that it could be kept in
        return njit(**COMPILED)(_solve_points)


@njit(**COMPILED)
def _read(table, x):
    """Value, slope and curvature at ``x``; nan outside the table."""
    position = (x - table.start) * table.scale
    if not 0.0 <= position < table.rows.shape[0]:
        return np.nan, np.nan, np.nan
    piece = np.uintp(position)
    local = 2.0 * (position - piece) - 1.0
    degree = table.rows.shape[1] - 1
    if degree == 5:  # a constant count is what makes a loop fast
        value, slope, curvature = _horner(table.rows, piece, local, 5)
    else:
        value, slope, curvature = _horner(table.rows, piece, local, 7)
    inner = 2.0 * table.scale
    return value, inner * slope, 2.0 * inner * inner * curvature


@njit(**COMPILED)
def _horner(rows, piece, local, degree):
    """Value, slope and half the curvature of a row of powers at ``local``."""
    value, slope, curvature = rows[piece, degree], 0.0, 0.0
    for power in range(degree - 1, -1, -1):
        curvature = curvature * local + slope
        slope = slope * local + value
        value = value * local + rows[piece, power]
    return value, slope, curvature


@njit(**COMPILED)
def _guess(table, x):
    """Value of a table of guesses at ``x``, held within it."""
    position = min(max((x - table.start) * table.scale, 0.0), GUESS_PIECES - 1e-9)
    piece = np.uintp(position)
    return _horner(table.rows, piece, 2.0 * (position - piece) - 1.0, GUESS_DEGREE)[0]


@njit(**COMPILED)
def _moment(table, truncation, largest, alpha):
    """M with its slope and curvature in alpha, held at the truncation."""
    if alpha >= truncation:
        return largest, 0.0, 0.0
    return _read(table, max(alpha, MOMENT_START))


def _solve_points(
    model, columns, has_particles, has_film, wants_areas, allowed, noise, states, found
):
    """Fill the rows of ``found``: A_t*, A_sa,t*, A_ss,t*, L_s, L_f, d/sigma and a bound on the
    relative error, which is nan where the loop does not find a solution.

    Halley's method on the logarithm of the load that the interface bears at d, which falls with d.
    It starts at the largest of the d at which summits, particles or film alone bear the load, and
    what a last step changes comes from its Taylor series.  Points take their steps side by side, as
    many as ``states`` holds: the processor has work while one waits for a chain of operations.
    """
    # what is read from a tuple within the loop is counted as a reference each time
    load_of, area_of, moment_of, film_of = model.load, model.area, model.moment, model.film
    summits_alone, particles_alone = model.summits_alone, model.particles_alone
    summit_error, film_error = model.summit_error, model.film_error
    moment_error = model.moment_error
    per_deviation, offset, near, far = model.per_deviation, model.offset, model.near, model.far
    truncation, largest, contacting = model.truncation, model.largest, model.contacting
    elastic_factor, pressure, coverage = model.elastic_factor, model.pressure, model.coverage
    loads, log_loads, means, spreads, depths, areas, bares = columns[:7]
    films_alone, levels, film_loads = columns[7:]
    # the elastic particles lie between alpha and alpha + shift
    reach = near if near != 0.0 else far
    sign = elastic_factor if near != 0.0 else -elastic_factor
    waiting = np.empty(states.size, np.intp)
    for start in range(0, log_loads.size, states.size):
        count = min(states.size, log_loads.size - start)
        for k in range(count):
            i = start + k
            x = offset + _guess(summits_alone, log_loads[i]) / per_deviation
            if has_film:
                x = max(x, films_alone[i])
            if has_particles:
                alone = _guess(particles_alone, log_loads[i] - math.log(pressure * areas[i]))
                x = max(x, means[i] + alone * spreads[i])
            states[k].x = x
            states[k].log_x = math.log(x)
            waiting[k] = k
            found[6, i] = np.nan
        for _ in range(STEPS):
            for j in range(count):  # what takes tables and exponentials, by itself
                i, state = start + waiting[j], states[waiting[j]]
                if has_film:
                    value, slope, curve = _read(film_of, state.log_x - levels[i])
                    inner = 1.0 / state.x
                    state.film = math.exp(film_loads[i] + value)
                    state.film_1 = slope * inner
                    state.film_2 = (curve * inner - state.film_1) * inner
                state.t = (state.x - offset) * per_deviation
                value, slope, curve = _read(load_of, state.t)
                state.solid = math.exp(value)
                state.solid_1 = slope * per_deviation
                state.solid_2 = curve * per_deviation * per_deviation
            for j in range(count):
                i, state = start + waiting[j], states[waiting[j]]
                x = state.x
                state.x = np.nan
                summits, slope, curve = state.solid, state.solid_1, state.solid_2
                summits_1 = slope * summits
                summits_2 = (slope * slope + curve) * summits
                gain = max(-slope, 1.0 / x)
                area = area_1 = area_2 = covered = covered_1 = covered_2 = onset = 0.0
                if has_particles:
                    inner, plastic_area = 1.0 / spreads[i], areas[i]
                    alpha = (x - means[i]) * inner
                    beyond = alpha + depths[i] * reach
                    if min(alpha, beyond) < truncation:
                        here, here_1, here_2 = _moment(moment_of, truncation, largest, alpha)
                        there, there_1, there_2 = _moment(moment_of, truncation, largest, beyond)
                        share = here - largest + sign * (there - here)
                        area = plastic_area * share
                        area_1 = plastic_area * inner * (here_1 + sign * (there_1 - here_1))
                        area_2 = plastic_area * inner * inner * (here_2 + sign * (there_2 - here_2))
                        covering = coverage * plastic_area
                        covered = covering * (here - largest)
                        covered_1 = covering * inner * here_1
                        covered_2 = covering * inner * inner * here_2
                        gain = max(gain, -covered_1)
                        if area > 0.0:
                            gain = max(gain, -area_1 / area)
                            onset = 4.0 * (moment_error + EPSILON) / share
                    bare = 1.0 - covered if contacting else bares[i]
                    if contacting:
                        summits_2 = (
                            summits_2 * bare - 2.0 * summits_1 * covered_1 - summits * covered_2
                        )
                        summits_1 = summits_1 * bare - summits * covered_1
                    else:
                        summits_2 *= bare
                        summits_1 *= bare
                    summits *= bare
                    if not min(bare, 1.0 - covered) > LEAST_BARE:
                        continue
                film = film_1 = film_2 = 0.0
                if has_film:
                    film, slope, curve = state.film, state.film_1, state.film_2
                    film_1 = slope * film
                    film_2 = (slope * slope + curve) * film
                    gain = max(gain, -slope)
                solid = summits + pressure * area
                solid_1 = summits_1 + pressure * area_1
                solid_2 = summits_2 + pressure * area_2
                total = solid + film
                total_1, total_2 = solid_1 + film_1, solid_2 + film_2
                if (
                    area_1 > 0.0 or not total_1 < 0.0
                ):  # soft particles may make several gaps possible
                    continue
                # its logarithm but for a fifth power of what it differs from 1 by
                ratio = total / loads[i]
                residual = 3.0 * (ratio * ratio - 1.0) / (ratio * (ratio + 4.0) + 1.0)
                square = total_1 * total_1
                curve = total_2 * total - square
                step = -residual * total * total_1 / (square - 0.5 * residual * curve)
                condition = -gain * total / total_1
                moved = abs(gain * step)
                left = moved * moved * moved * (1.0 + condition)
                # a load's own error counts as much as its part in the balance
                borne = summit_error * summits + film_error * film + onset * pressure * area
                state.error = (
                    left
                    + summit_error
                    + film_error
                    + onset
                    + condition * (borne / total + noise)
                    + 4.0 * EPSILON * gain * x
                )
                state.x = x + step
                state.step = step
                state.left = left
                state.solid, state.solid_1, state.solid_2 = solid, solid_1, solid_2
                state.film, state.film_1, state.film_2 = film, film_1, film_2
                state.area, state.area_1, state.area_2 = area, area_1, area_2
                state.covered, state.covered_1, state.covered_2 = covered, covered_1, covered_2
            going_on = 0
            for j in range(count):
                i, state = start + waiting[j], states[waiting[j]]
                x, step = state.x, state.step
                if not x > 0.0:
                    continue
                settled = state.left <= allowed
                if has_particles:  # no Taylor series crosses where they come into contact
                    alpha = (x - means[i]) / spreads[i] - truncation
                    close = min(abs(alpha), abs(alpha + depths[i] * reach))
                    settled = settled and abs(step) < spreads[i] * close
                if not settled:
                    state.log_x = math.log(x)
                    waiting[going_on] = waiting[j]
                    going_on += 1
                    continue
                square = 0.5 * step * step
                if wants_areas:
                    value, slope, curve = _read(area_of, state.t)
                    slope *= per_deviation
                    curve = curve * per_deviation * per_deviation + slope * slope
                    bare = math.exp(value) * (
                        (1.0 - state.covered) * (1.0 + slope * step + curve * square)
                        - state.covered_1 * step * (1.0 + slope * step)
                        - state.covered_2 * square
                    )
                    area = max(state.area + state.area_1 * step + state.area_2 * square, 0.0)
                    together = area + bare
                    if not together > LEAST_AREA:
                        continue
                    found[0, i] = together
                    found[1, i] = area / together
                    found[2, i] = bare / together
                solid = state.solid + state.solid_1 * step + state.solid_2 * square
                film = state.film + state.film_1 * step + state.film_2 * square
                found[3, i] = solid / (solid + film)
                found[4, i] = film / (solid + film)
                found[5, i] = x
                found[6, i] = state.error
            count = going_on
            if count == 0:
                break
