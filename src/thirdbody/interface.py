"""The interface that a set of points describes: puts together what they need, and no more.

Dry points get no film, two-body points no particles, and each roughness is prepared once.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import lru_cache
from numbers import Real

import numpy as np
from scipy.special import expit, log_expit

from thirdbody.asperity import SummitPopulation
from thirdbody.balance import LOAD_SHARES, Points, RoughSurface, dry_separation
from thirdbody.film import Film
from thirdbody.parameters import Parameters
from thirdbody.particles import ParticleLayer
from thirdbody.regimes import SOLUTION_STATUSES, contact_mode, lubrication_regime
from thirdbody.tabulation import PiecewisePolynomial

DEFAULT_RTOL = 1e-9
NO_FLAG = np.int8(-1)  # regime and mode of a point without values
CHUNK = 16384  # points solved together: their arrays stay in the processor's cache
TABLE_WORTH = 500  # points on one roughness from which its table costs less than it saves
FIRST_SAMPLES = np.linspace(-5.0, 40.0, 46)  # t where a first guess is read off
TABLE_START, TABLE_END = -5.0, 40.0  # summit separations t [1]
# (least rtol, pieces, degree): tables whose error in ln F_ss and ln A_ss is a tenth of it or less
TABLE_SIZES = ((1e-4, 90, 3), (1e-9, 180, 5), (0.0, 180, 7))

CONVERGED, OUTSIDE_FILM_FORMULA, COVERAGE_EXCEEDED, NOT_CONVERGED = range(len(SOLUTION_STATUSES))


@dataclass(frozen=True)
class Solution:
    """Solved points; every attribute has the broadcast shape of the five arguments.

    Lengths in m, all else dimensionless; the last three are indices into the tuples of
    ``thirdbody.regimes``.  Unsolved points hold nan, or ``NO_FLAG`` for
    regime and mode, and ``solution_status`` says why.
    """

    total_contact_area: np.ndarray
    particle_contact_area_ratio: np.ndarray
    surface_contact_area_ratio: np.ndarray
    solid_load_fraction: np.ndarray
    fluid_load_fraction: np.ndarray
    separation: np.ndarray
    film_thickness: np.ndarray
    lubrication_regime: np.ndarray
    contact_mode: np.ndarray
    solution_status: np.ndarray


def solve(
    load,
    viscosity,
    particle_diameter,
    roughness,
    particle_density,
    parameters: Parameters,
    rtol: float = DEFAULT_RTOL,
) -> Solution:
    """Contact state of the interface at each point (Eqs. 1-10).

    ``load`` F_t* = F_t/(A_n E_ss) [1], ``viscosity`` [m2/s] (0: dry), ``particle_diameter`` x_a
    [m] and ``particle_density`` eta_a [m-2] (0 in either: two-body), ``roughness`` sigma [m]
    broadcast against each other.  ``rtol`` in [1e-11, 1e-2] is the relative error asked for in
    every returned variable.  Raises ``ValueError`` for a negative, non-finite or, where zero has
    no meaning, zero argument; what cannot be solved is marked in ``solution_status`` instead.
    """
    check_rtol(rtol)
    given = {
        "load": load,
        "viscosity": viscosity,
        "particle_diameter": particle_diameter,
        "roughness": roughness,
        "particle_density": particle_density,
    }
    columns = np.broadcast_arrays(*(checked_axis(name, value) for name, value in given.items()))
    shape = columns[0].shape
    columns = [np.ravel(column) for column in columns]
    result = {
        field.name: np.full(columns[0].size, *_EMPTY.get(field.name, (np.nan,)))
        for field in fields(Solution)
    }
    with np.errstate(all="ignore"):  # what cannot be computed gets a status
        for roughness_value in np.unique(columns[3]):
            chosen = np.flatnonzero(columns[3] == roughness_value)
            table_rtol = rtol if chosen.size >= TABLE_WORTH else None
            rough = prepare_surface(float(roughness_value), parameters, table_rtol)
            for part in _parts(columns, chosen):
                points = make_points(rough, parameters, *(column[part] for column in columns))
                for name, values in _solve_points(points, rtol).items():
                    result[name][part] = values
    return Solution(**{name: values.reshape(shape) for name, values in result.items()})


_EMPTY = dict.fromkeys(
    ("lubrication_regime", "contact_mode", "solution_status"), (NOT_CONVERGED, np.int8)
)


def check_rtol(rtol) -> None:
    """Raises ``ValueError`` unless ``rtol`` is within what float64 and the tables can promise."""
    if not isinstance(rtol, Real) or not 1e-11 <= rtol <= 1e-2:
        raise ValueError(f"rtol is {rtol!r}; allowed: 1e-11 to 1e-2")


def checked_axis(name: str, values):
    """``values`` as float64, or a ``ValueError`` that names the argument and its first bad value."""
    try:
        array = np.asarray(values)
    except ValueError:
        raise ValueError(f"{name} is a ragged list; allowed: numbers of one shape") from None
    if np.ma.is_masked(values):
        raise ValueError(f"{name} has masked values; allowed: numbers at every point")
    if array.dtype.kind not in "iuf":
        raise ValueError(f"{name} is of type {array.dtype}; allowed: numbers")
    array = array.astype(float)
    zero_allowed = name not in ("load", "roughness")
    good = np.isfinite(array) & ((array >= 0.0) if zero_allowed else (array > 0.0))
    if not good.all():
        bad = array[~good].flat[0]
        sign = "zero or positive" if zero_allowed else "positive"
        raise ValueError(f"{name} is {bad:g}; allowed: {sign} finite numbers")
    return array


@lru_cache(maxsize=64)
def prepare_surface(roughness: float, parameters: Parameters, rtol: float | None) -> RoughSurface:
    """Summits at ``roughness`` sigma [m], as tables good for ``rtol`` or, if None, by quadrature.

    Prepared once for all that share it.
    """
    surface = parameters.surface(roughness)
    population = SummitPopulation.of(surface, parameters)
    functions = population.log_load, population.log_area
    samples = FIRST_SAMPLES
    if rtol is not None:
        pieces, degree = next(size for least, *size in TABLE_SIZES if rtol >= least)
        functions = tuple(
            PiecewisePolynomial(function, TABLE_START, TABLE_END, pieces, degree)
            for function in functions
        )
        samples = functions[0].centres
    return RoughSurface(surface, *functions, (functions[0](samples)[0][::-1], samples[::-1]))


def _parts(columns, chosen):
    """The points ``chosen`` in chunks, divided by whether film and particles take part."""
    _, viscosity, diameter, _, density = (column[chosen] for column in columns)
    lubricated = viscosity > 0.0
    three_body = has_particles(diameter, density)
    for film in (False, True):
        for particles in (False, True):
            some = chosen[(lubricated == film) & (three_body == particles)]
            yield from (some[start : start + CHUNK] for start in range(0, some.size, CHUNK))


def has_particles(diameter, density):
    """Whether particles of ``diameter`` [m] and ``density`` [m-2] cover more than float64's zero."""
    return diameter**2 * density > np.finfo(float).tiny


def make_points(
    rough, parameters, load, viscosity, particle_diameter, roughness, particle_density
) -> Points:
    """Points of one kind on one surface: 1-D arrays that all have a film or all have none, and
    all have particles or all have none."""
    particles = film = None
    if has_particles(particle_diameter[0], particle_density[0]):
        particles = ParticleLayer.of(particle_diameter, roughness, particle_density, parameters)
    if viscosity[0] > 0.0:
        film = Film.of(viscosity, roughness, parameters)
    return Points(rough, parameters, np.log(load), particles, film)


def _solve_points(points: Points, rtol: float) -> dict:
    """All variables of ``Solution`` for points of one kind."""
    tolerance = 0.5 * rtol
    if points.film is None:
        separation = dry_separation(points, tolerance)
        logit = np.where(np.isnan(separation), np.nan, np.inf)
    else:
        logit, separation = LOAD_SHARES[points.parameters.film_load](points, tolerance)
    particle_area, log_summit_area, covered = points.areas(separation)
    status = _status(points, logit, separation, covered)
    void = status >= COVERAGE_EXCEEDED
    for values in (logit, separation, particle_area, log_summit_area):
        values[void] = np.nan
    odds = np.log(particle_area) - log_summit_area
    solid, ratio = expit(logit), expit(odds)
    return {
        "total_contact_area": particle_area + np.exp(log_summit_area),
        "particle_contact_area_ratio": ratio,
        "surface_contact_area_ratio": expit(-odds),
        "solid_load_fraction": solid,
        "fluid_load_fraction": expit(-logit),
        "separation": separation,
        "film_thickness": separation / points.parameters.ball_radius,
        "lubrication_regime": np.where(void, NO_FLAG, lubrication_regime(solid)),
        "contact_mode": np.where(void, NO_FLAG, contact_mode(ratio, points.particles is not None)),
        "solution_status": status,
    }


def _status(points: Points, logit, separation, covered):
    """Index into ``SOLUTION_STATUSES`` of each point; what voids a point outranks a warning."""
    status = np.full(separation.shape, CONVERGED, dtype=np.int8)
    if points.film is not None:
        shared = 0.0 if points.parameters.film_load == "total" else log_expit(-logit)
        meaningful = points.film.is_meaningful(points.log_load_parameter(shared))
        status[~meaningful] = OUTSIDE_FILM_FORMULA
    status[np.isnan(separation)] = NOT_CONVERGED
    status[covered] = COVERAGE_EXCEEDED
    return status
