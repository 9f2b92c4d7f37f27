"""The interface that a set of points describes: puts together what they need, and no more.

Dry points get no film, two-body points no particles, each roughness is prepared once, equal
points are solved once, and only the variables that are asked for are evaluated.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from functools import lru_cache
from numbers import Real

import numpy as np

from thirdbody.asperity import SummitPopulation
from thirdbody.balance import Points, RoughSurface
from thirdbody.film import Film
from thirdbody.parameters import Parameters
from thirdbody.particles import ParticleLayer
from thirdbody.solution import FLAGS, VARIABLES, Solution, SolvedPoints
from thirdbody.tabulation import PiecewisePolynomial

DEFAULT_RTOL = 1e-9
CHUNK = 16384  # points solved together: their arrays stay in the processor's cache
TABLE_WORTH = 500  # points on one roughness from which its table costs less than it saves
FIRST_SAMPLES = np.linspace(-5.0, 40.0, 46)  # t where a first guess is read off
TABLE_START, TABLE_END = -5.0, 40.0  # summit separations t [1]
MIXERS = np.random.default_rng(0).integers(1, 2**64, 5, dtype=np.uint64) | np.uint64(1)
# (least rtol, pieces, degree): tables whose error in ln F_ss and ln A_ss is a tenth of it or less
TABLE_SIZES = ((1e-4, 90, 3), (1e-7, 180, 5), (0.0, 180, 7))


def solve(
    load,
    viscosity,
    particle_diameter,
    roughness,
    particle_density,
    parameters: Parameters,
    rtol: float = DEFAULT_RTOL,
    variables: Collection[str] = VARIABLES,
) -> Solution:
    """Contact state of the interface at each point (Eqs. 1-10).

    ``load`` F_t* = F_t/(A_n E_ss) [1], ``viscosity`` [m2/s] (0: dry), ``particle_diameter`` x_a
    [m] and ``particle_density`` eta_a [m-2] (0 in either: two-body), ``roughness`` sigma [m]
    broadcast against each other.  ``rtol`` in [1e-11, 1e-2] is the relative error asked for in
    every returned variable; ``variables`` names those that are wanted, the others being None.
    Raises ``ValueError`` for a negative, non-finite or, where zero has no meaning, zero argument
    and for an unknown variable; what cannot be solved is marked in ``solution_status`` instead.
    """
    check_rtol(rtol)
    check_variables(variables)
    given = {
        "load": load,
        "viscosity": viscosity,
        "particle_diameter": particle_diameter,
        "roughness": roughness,
        "particle_density": particle_density,
    }
    columns = np.broadcast_arrays(*(checked_axis(name, value) for name, value in given.items()))
    shape = columns[0].shape
    with np.errstate(all="ignore"):  # what cannot be computed gets a status
        columns, places = _distinct([np.ravel(column) for column in columns])
        result = {name: np.empty(columns[0].size, type_of(name)) for name in variables}
        for part, solved in _solved_parts(columns, parameters, rtol):
            for name, values in result.items():
                values[part] = getattr(solved, name)
    return Solution(**{name: values[places].reshape(shape) for name, values in result.items()})


def _solved_parts(columns, parameters, rtol):
    """Pairs of a part of the points, as a slice or an array of indices, and these solved; points
    that magnify the errors of tables and roots beyond ``rtol`` come again, solved without."""
    for roughness, table_rtol, part in _parts(columns, rtol):
        rough = prepare_surface(roughness, parameters, table_rtol)
        points = make_points(rough, parameters, *(column[part] for column in columns))
        solved = SolvedPoints(points, rtol)
        yield part, solved
        if table_rtol is not None and solved.imprecise.any():
            again = np.flatnonzero(solved.imprecise)
            rough = prepare_surface(roughness, parameters, None)
            exact = SolvedPoints(replace(points.take(again), rough=rough), rtol)
            yield np.arange(columns[0].size)[part][again], exact


def type_of(variable: str) -> type:
    """Of the values of a variable of ``Solution``."""
    return np.int8 if variable in FLAGS else float


def check_variables(variables) -> None:
    """Raises ``ValueError`` unless ``variables`` is a collection of names of variables."""
    unknown = [name for name in variables if name not in VARIABLES]
    if isinstance(variables, str) or unknown:
        shown = variables if isinstance(variables, str) else unknown[0]
        raise ValueError(f"variables has {shown!r}; allowed: a list out of {', '.join(VARIABLES)}")


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
    samples, error = FIRST_SAMPLES, 0.0
    if rtol is not None:
        pieces, degree = next(size for least, *size in TABLE_SIZES if rtol >= least)
        functions = tuple(
            PiecewisePolynomial(function, TABLE_START, TABLE_END, pieces, degree)
            for function in functions
        )
        samples, error = functions[0].centres, max(function.error for function in functions)
    sampled = functions[0](samples)[0][::-1], samples[::-1]
    return RoughSurface(surface, *functions, sampled, error)


def _distinct(columns):
    """The distinct points among ``columns``, and the place of each point among them.

    Equal points have equal sums of their columns' bits in fixed proportions: whether there are any
    shows at the cost of a sort.  Densities of particles without a size are equal, and vice versa.
    """
    everything = slice(None)
    size = columns[0].size
    three_body = has_particles(columns[2], columns[4])
    if not three_body.all():
        columns = list(columns)
        for place in (2, 4):
            columns[place] = np.where(three_body, columns[place], 0.0)
    sums = np.zeros(size, dtype=np.uint64)
    for factor, column in zip(MIXERS, columns, strict=True):
        sums += np.ascontiguousarray(column).view(np.uint64) * factor
    in_order = np.sort(sums)
    if (in_order[1:] != in_order[:-1]).all():
        return columns, everything
    order = np.argsort(sums)
    new = np.ones(size, dtype=bool)
    new[1:] = np.any([column[order[1:]] != column[order[:-1]] for column in columns], axis=0)
    places = np.empty(size, dtype=np.intp)
    places[order] = np.cumsum(new) - 1
    return [column[order[new]] for column in columns], places


def _parts(columns, rtol):
    """Roughness, ``rtol`` of its table or None, and points that are solved together: a chunk at a
    time, all with or all without film and all with or all without particles."""
    _, viscosity, diameter, roughness, density = columns
    kind = 2 * (viscosity > 0.0) + has_particles(diameter, density)
    values, surface = _labelled(roughness)
    numbers = np.bincount(surface, minlength=values.size)
    for some in _runs(4 * surface + kind):
        here = surface[some][0]
        yield float(values[here]), rtol if numbers[here] >= TABLE_WORTH else None, some


def _labelled(values):
    """The distinct among 1-D ``values``, and which of them each is."""
    if (values == values[:1]).all():
        return values[:1], np.zeros(values.size, dtype=np.intp)
    return np.unique(values, return_inverse=True)


def _runs(labels):
    """Chunks of the places of equal ``labels``: slices if all are equal, else arrays."""
    if (labels == labels[:1]).all():
        for start in range(0, labels.size, CHUNK):
            yield slice(start, start + CHUNK)
        return
    order = np.argsort(labels, kind="stable")
    edges = np.flatnonzero(np.diff(labels[order])) + 1
    for run in np.split(order, edges):
        yield from (run[start : start + CHUNK] for start in range(0, run.size, CHUNK))


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
