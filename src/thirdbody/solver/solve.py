"""The interface that a set of points describes: puts together what they need, and no more.

Dry points get no film, two-body points no particles, each roughness is prepared once, equal
points are solved once, and only the variables that are asked for are evaluated.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection
from numbers import Real

import numpy as np

from thirdbody.model.contact import Contact
from thirdbody.model.film import Film
from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import ParticleLayer, has_particles
from thirdbody.solver.balance import Points
from thirdbody.solver.solution import FLAGS, OF_AREAS, VARIABLES, Solution, SolvedPoints
from thirdbody.solver.surfaces import TABLE_SIZES, RoughSurfaces, prepare_surface, table_size

DEFAULT_RTOL = 1e-9
BLOCK = 2**18  # points among which equal ones are looked for
CHUNK = 16384  # points solved together: their arrays stay in the processor's cache
QUADRATURE_CHUNK = 256  # the same without tables, where each has some hundred nodes
COMPILATION_WORTH = 10_000  # points from which a compiled loop solves them
TABLE_WORTH = 500  # points on one roughness from which its finest table costs less than it saves
MIXERS = np.random.default_rng(0).integers(1, 2**64, 5, dtype=np.uint64) | np.uint64(1)


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
    shape, size = columns[0].shape, columns[0].size
    columns = [np.ravel(column) for column in columns]
    result = {name: np.empty(size, type_of(name)) for name in variables}
    with np.errstate(all="ignore"):  # what cannot be computed gets a status
        for block in _pieces(slice(0, size), BLOCK):
            into = {name: values[block] for name, values in result.items()}
            _solve_block([column[block] for column in columns], parameters, rtol, into)
    return Solution(**{name: values.reshape(shape) for name, values in result.items()})


def _solve_block(columns, parameters, rtol, into):
    """Fill the arrays ``into``, by name of a variable, with the solution at the points."""
    columns, places = _distinct(columns)
    found = into
    if places is not None:
        found = {name: np.empty(columns[0].size, values.dtype) for name, values in into.items()}
    for part, solved in _solved_parts(columns, parameters, rtol, into):
        for name, values in found.items():
            values[part] = getattr(solved, name)
    if places is not None:
        for name, values in found.items():
            into[name][:] = values[places]


def _solved_parts(columns, parameters, rtol, variables):
    """Pairs of a part of the points, as a slice or an array of indices, and these solved; points
    that are beyond the fastest way of solving them come again, solved in a slower one."""
    together = defaultdict(list)
    for roughness, table_rtol, kind, group in _groups(columns, rtol):
        if _size(group) >= COMPILATION_WORTH and parameters.readings.film_load.depends_on_shares:
            rough = prepare_surface(roughness, parameters, rtol)
            areas = not OF_AREAS.isdisjoint(variables)
            group = yield from _compiled_parts(columns, group, rough, parameters, rtol, areas)
            table_rtol = rtol if tables_pay(group.size, rtol) else None
        together[table_rtol, kind].append(group)
    for (table_rtol, _), groups in together.items():
        for part in _pieces(_joined(groups), CHUNK if table_rtol else QUADRATURE_CHUNK):
            solved = SolvedPoints(_points(columns, part, parameters, table_rtol), rtol)
            yield part, solved
            if table_rtol is not None and solved.imprecise.any():
                again = _chosen(part, solved.imprecise)
                yield again, SolvedPoints(_points(columns, again, parameters, None), rtol)


def _compiled_parts(columns, group, rough, parameters, rtol, areas):
    """Pairs as of ``_solved_parts`` from the compiled loop; returns the points it leaves."""
    from thirdbody.solver.compiled.points import CompiledPoints  # what compiles is slow to import
    from thirdbody.solver.compiled.tables import precisions

    for real in precisions(rtol):
        left = []
        for part in _pieces(group, CHUNK):
            load, viscosity, diameter, _, density = (column[part] for column in columns)
            solved = CompiledPoints(
                rough, parameters, load, viscosity, diameter, density, rtol, real, areas
            )
            yield part, solved
            left.append(_chosen(part, solved.left))
        group = np.concatenate(left)
        if not group.size:
            break
    return group


def _points(columns, part, parameters, table_rtol):
    """The points of one kind in a part of ``columns``; ``table_rtol`` is that of their surfaces."""
    load, viscosity, diameter, roughness, density = (column[part] for column in columns)
    contact = make_contact(diameter, roughness, density, parameters, table_rtol)
    film = Film.of(viscosity, roughness, parameters) if viscosity[0] > 0.0 else None
    return Points(contact, film, np.log(load))


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
    array = np.asarray(array, float)
    zero_allowed = name not in ("load", "roughness")
    least = 0.0 if zero_allowed else np.nextafter(0.0, 1.0)
    if not (array.min(initial=1.0) >= least and array.max(initial=1.0) < np.inf):
        bad = array[~((array >= least) & np.isfinite(array))].flat[0]
        sign = "zero or positive" if zero_allowed else "positive"
        raise ValueError(f"{name} is {bad:g}; allowed: {sign} finite numbers")
    return array


def tables_pay(points, rtol: float):
    """Whether so many ``points`` on one roughness are worth a table that is good for ``rtol``.

    Tables cost in proportion to their samples.
    """
    finest, table = (pieces * degree for pieces, degree in (TABLE_SIZES[-1][1:], table_size(rtol)))
    return points * finest >= TABLE_WORTH * table


def _distinct(columns):
    """The distinct points among ``columns``, and the place of each point among them, or None where
    all are distinct.

    Equal points have equal sums of their columns' bits in fixed proportions: whether there are any
    shows at the cost of a sort.  Densities of particles without a size are equal, and vice versa.
    """
    size = columns[0].size
    three_body = has_particles(columns[2], columns[4])
    if not three_body.all():
        columns = list(columns)
        for place in (2, 4):
            columns[place] = np.where(three_body, columns[place], 0.0)
    sums, product = np.zeros((2, size), dtype=np.uint64)
    for factor, column in zip(MIXERS, columns, strict=True):
        sums += np.multiply(np.ascontiguousarray(column).view(np.uint64), factor, out=product)
    in_order = np.sort(sums)
    if (in_order[1:] != in_order[:-1]).all():
        return columns, None
    order = np.argsort(sums)
    new = np.ones(size, dtype=bool)
    new[1:] = np.any([column[order[1:]] != column[order[:-1]] for column in columns], axis=0)
    places = np.empty(size, dtype=np.intp)
    places[order] = np.cumsum(new) - 1
    return [column[order[new]] for column in columns], places


def _groups(columns, rtol):
    """Groups of points of one roughness and one kind, all with or without film and particles.

    Their roughness; the ``rtol`` of its tables, None if it is not worth any; the number of their
    kind; their places as a slice or an array of indices.
    """
    _, viscosity, diameter, roughness, _ = columns
    wet, three_body = viscosity > 0.0, diameter > 0.0
    kinds = labels = 2 * wet.view(np.int8) + three_body.view(np.int8)
    numbers = {}
    if (roughness != roughness[:1]).any():
        values, surface = np.unique(roughness, return_inverse=True)
        numbers = dict(zip(values, np.bincount(surface), strict=True))
        labels = 4 * surface + kinds
    for group in _runs(labels):
        first = group.start if isinstance(group, slice) else group[0]
        sigma = float(roughness[first])
        points = numbers.get(sigma, roughness.size)
        yield sigma, rtol if tables_pay(points, rtol) else None, kinds[first], group


def _runs(labels):
    """The places of equal ``labels``: a slice if all are equal, else arrays."""
    if (labels == labels[:1]).all():
        return [slice(0, labels.size)] if labels.size else []
    order = np.argsort(labels, kind="stable")
    edges = np.flatnonzero(np.diff(labels[order])) + 1
    return np.split(order, edges)


def _joined(groups):
    """The places in ``groups``, which are one slice or arrays of indices."""
    return groups[0] if len(groups) == 1 else np.concatenate(groups)


def _size(group) -> int:
    return group.stop - group.start if isinstance(group, slice) else group.size


def _chosen(part, mask):
    """Indices of the points of a part, a slice or an array of indices, that a mask chooses."""
    chosen = np.flatnonzero(mask)
    return chosen + part.start if isinstance(part, slice) else part[chosen]


def _pieces(group, size):
    """Pieces of ``size`` at most of a slice or an array of indices."""
    if isinstance(group, slice):
        for start in range(group.start, group.stop, size):
            yield slice(start, min(start + size, group.stop))
    else:
        yield from (group[start : start + size] for start in range(0, group.size, size))


def make_contact(
    particle_diameter, roughness, particle_density, parameters: Parameters, table_rtol
) -> Contact:
    """Contact at points of one kind: 1-D arrays (SI) that all have particles or all have none.

    ``table_rtol`` is as in ``prepare_surface``.
    """
    particles = None
    if has_particles(particle_diameter[0], particle_density[0]):
        particles = ParticleLayer.of(particle_diameter, roughness, particle_density, parameters)
    return Contact(RoughSurfaces.of(roughness, parameters, table_rtol), particles, parameters)
