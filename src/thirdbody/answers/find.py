"""``find``: where a variable has a level along any of the five axes.

The axis is swept at values evenly spaced in their logarithm; every two neighbours between which the
variable passes the level enclose a crossing, which is then found to the error asked for.  Where a
curve turns round next to the level, the sweep is made finer, ``DEPTH`` times by ``FINER``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.answers.arguments import check_count, check_ends, checked_levels
from thirdbody.answers.units import Unit, in_si
from thirdbody.conditions.checks import check_points, check_rtol
from thirdbody.curves.crossings import excess_over, level_roots
from thirdbody.model.parameters import Parameters
from thirdbody.progress import Progress, check_progress
from thirdbody.solver.solve import DEFAULT_RTOL, solve

SWEEP = 32  # values along the axis
FINER, DEPTH = 8, 2  # where a curve turns round next to the level
CHUNK = 500_000  # points solved together
WIDER, ATTEMPTS = 8.0, 8  # until both sides of a crossing are certain


@dataclass(frozen=True)
class Crossings:
    """Where variables have levels: one element a crossing, in the order of the queries.

    Attributes
    ----------
    along : str
        The axis and its unit, by its name.
    shape : tuple of int
        Shape of the queries: that to which the level and the other axes broadcast.
    query : array of int, shape (n,)
        Index of the query, in the flat order of ``shape``.
    value : array, shape (n,)
        Where the crossing is, in the unit of ``along``; of one query increasing.
    error : array, shape (n,)
        Bound on the error of ``value``, in the same unit: on both sides of it, so far away, the
        variable has been seen to be above and below the level by more than its ``error_bound``;
        infinite where float64 cannot tell that.
    rises : array of bool, shape (n,)
        Whether the variable rises along the axis there.
    solution_status : array of int8, shape (n,)
        Index into ``thirdbody.model.regimes.SOLUTION_STATUSES``: whether the equations mean
        something there.
    """

    along: str
    shape: tuple[int, ...]
    query: NDArray
    value: NDArray
    error: NDArray
    rises: NDArray
    solution_status: NDArray

    @property
    def count(self) -> NDArray:
        """How many crossings each query has, of ``shape``; 0: there is none in the range."""
        return np.bincount(self.query, minlength=np.prod(self.shape, dtype=int)).reshape(self.shape)

    @property
    def first(self) -> NDArray:
        """The least of the crossings of each query, of ``shape``; nan where there is none."""
        first = np.full(self.shape, np.nan)
        first.ravel()[self.query[::-1]] = self.value[::-1]  # the last one to be stored stays
        return first


def find(
    variable: str,
    level: ArrayLike,
    along: str,
    *,
    parameters: Parameters,
    between: tuple[float, float] | None = None,
    count: int = SWEEP,
    rtol: float = DEFAULT_RTOL,
    progress: bool = True,
    **conditions: ArrayLike,
) -> Crossings:
    """Find where a variable has a level along one of the five axes: all crossings.

    Parameters
    ----------
    variable : str
        A number of ``Solution``: ``solid_load_fraction``, ``total_contact_area``, ...
    level : array_like
        Its value: those between regimes and modes stand in ``thirdbody.model.regimes``.
    along : str
        The axis, by its name in the unit that is wanted: ``load`` [1], ``load_N``, ``viscosity``
        [m2/s], ``viscosity_cSt``, ``particle_diameter`` [m], ``particle_diameter_nm``, ``roughness``
        [m], ``roughness_nm``, or ``particle_density_per_m2``.
    parameters : Parameters
        Inputs of the model.
    between : pair of float, optional
        Ends of the search, positive, in the unit of ``along``.  By default 0.01 to 1000 N, 1 to
        1000 cSt, 10 to 10000 nm (diameter), 20 to 2000 nm (roughness) and 1e8 to 1e14 m-2.
    count : int
        Number of values of the sweep, from 2 to a million.
    rtol : float
        Relative error asked for, as of ``solve``.
    progress : bool
        Whether a search that takes long says how far it has come, as ``solve``.
    **conditions : array_like
        The other four axes, by any of the names above; they and ``level`` broadcast.

    Returns
    -------
    Crossings
        Of every query all crossings; where there is none, its ``count`` is 0 and its ``first`` nan.

    Raises
    ------
    ValueError
        In one line: for an unknown variable or axis, a level that is no number, an axis that is
        missing or given twice, ends that are not positive and increasing, a ``count`` that is not
        whole or out of its range, and what ``solve`` refuses.

    Notes
    -----
    The values of the sweep are evenly spaced in their logarithm.  Two crossings between neighbours
    are missed, unless the curve is seen to turn round there: where the middle one of three values is
    nearest to the level, and no farther from it than the larger of the steps beside it, which for a
    parabola is eight times as far as needed, both cells are swept again, down to a 64th of the
    spacing.  A crossing between a value without solution and the next is missed.
    Several separations of a point, of which ``solve`` gives the largest, make curves jump: where
    one jumps across the level, that is a crossing too.  Dry contact and contact without particles
    (0) are no values of a search; as ``conditions`` they are.

    Examples
    --------
    From which viscosity on the solids bear less than 90 % and less than half of 10 N:

    >>> import thirdbody as tb
    >>> inputs = tb.load_parameters()
    >>> found = tb.find(
    ...     "solid_load_fraction",
    ...     [0.9, 0.5],
    ...     "viscosity_cSt",
    ...     between=(20, 1000),
    ...     parameters=inputs,
    ...     load_N=10,
    ...     particle_diameter_nm=500,
    ...     roughness_nm=300,
    ...     particle_density_per_m2=1e11,
    ... )
    >>> found.count, bool(found.first[0] < found.first[1])
    (array([1, 1]), True)
    """
    level = checked_levels(variable, level)
    check_progress(progress)
    unit, swept = sweep_values(along, between, count, parameters)
    given = in_si(conditions, parameters, but=unit.axis.name)
    check_points({"level": level, **given})
    columns = np.broadcast_arrays(level, *given.values())
    levels, *others = map(np.ravel, columns)
    (found,) = crossings(
        [(variable, levels)], unit, swept, dict(zip(given, others)), parameters, rtol, progress
    )
    return Crossings(along, columns[0].shape, *found)


def sweep_values(
    along: str, between: tuple[float, float] | None, count: int, parameters: Parameters
) -> tuple[Unit, NDArray]:
    """The unit of an axis, and the values [SI] at which it is swept; arguments as of ``find``."""
    unit = Unit.of(along, parameters)
    ends = unit.searched(parameters) if between is None else between
    check_ends("between", ends)
    check_count("count", count)
    return unit, np.geomspace(*unit.to_si(ends), count)


def crossings(
    limits: list[tuple[str, NDArray]],
    unit: Unit,
    swept: NDArray,
    others: Mapping[str, NDArray],
    parameters: Parameters,
    rtol: float,
    progress: bool = True,
) -> list[tuple]:
    """Find the crossings of several variables, which are solved together.

    Parameters
    ----------
    limits : list
        Pairs of a variable and its level for each query, shape (queries,).
    unit : Unit
        The axis, and the unit of the result.
    swept : array
        Increasing values of the axis [SI].
    others : mapping
        The other axes [SI], each of shape (queries,).
    parameters, rtol, progress
        As of ``find``.

    Returns
    -------
    list of tuple
        For each limit the fields of ``Crossings`` from ``query`` on.
    """
    check_rtol(rtol)
    search = _Search(limits, unit.axis.name, others, parameters, rtol)
    queries = next(iter(others.values())).size
    step = max(1, CHUNK // swept.size)
    pieces = [np.arange(start, min(start + step, queries)) for start in range(0, queries, step)]
    enclosed = []
    with Progress(queries, "curves searched", progress) as shown:
        for piece in pieces:
            enclosed.append(search.enclosed(piece, swept[:, None]))
            shown.add(piece.size)
    limit, query, rises, *ends = map(np.concatenate, zip(*enclosed)) if pieces else [_NONE] * 5
    log_value, log_error, status = search.refined(limit, query, *ends)
    value = np.exp(log_value)
    error = value * np.expm1(log_error)
    fields = query, unit.from_si(value), unit.from_si(error), rises, status
    order = np.lexsort((value, query, limit))
    chosen = (order[limit[order] == index] for index in range(len(limits)))
    return [tuple(field[places] for field in fields) for places in chosen]


_NONE = np.zeros(0, int)


@dataclass(frozen=True)
class _Search:
    """What is searched: limits, the name of the axis along which, and what each query holds."""

    limits: list[tuple[str, NDArray]]
    along: str
    others: Mapping[str, NDArray]
    parameters: Parameters
    rtol: float

    def enclosed(self, query, values, limits=None, depth=DEPTH):
        """The crossings between neighbouring ``values`` of the axis, shape (values, 1 or queries).

        Returns the limit and the query of each, whether it rises, and ln of both neighbours.
        """
        limits = range(len(self.limits)) if limits is None else limits
        given = {name: column[query] for name, column in self.others.items()}
        wanted = {self.limits[index][0] for index in limits}
        found = solve(
            **given,
            **{self.along: values},
            parameters=self.parameters,
            rtol=self.rtol,
            variables=wanted,
            progress=False,
        )
        log_values = np.broadcast_to(np.log(values), (len(values), query.size))
        pieces = []
        for index in limits:
            name, level = self.limits[index]
            excess = getattr(found, name) - level[query]
            above = excess > 0.0
            known = np.isfinite(excess)
            step, place = np.nonzero((above[:-1] != above[1:]) & known[:-1] & known[1:])
            ends = log_values[step, place], log_values[step + 1, place]
            rises = above[step + 1, place]
            pieces.append((np.full(step.size, index), query[place], rises, *ends))
            if depth:
                step, place = np.nonzero(_may_touch(excess))
                if place.size:
                    ends = log_values[step, place], log_values[step + 2, place]
                    finer = np.exp(np.linspace(*ends, 2 * FINER + 1))
                    pieces.append(self.enclosed(query[place], finer, [index], depth - 1))
        return tuple(map(np.concatenate, zip(*pieces)))

    def refined(self, limit, query, low, high):
        """ln of each crossing and of its error as a ratio, and the status there."""
        if query.size == 0:
            return np.zeros(0), np.zeros(0), np.zeros(0, np.int8)
        names = [name for name, _ in self.limits]
        level = np.stack([levels for _, levels in self.limits])[limit, query]
        given = {name: column[query] for name, column in self.others.items()}
        asked = names, limit, level, given, self.parameters, self.rtol
        root, width = level_roots(self.along, (low, high), *asked)
        return root, *self._certain(root, 2.0 * (width + self.rtol), asked)

    def _certain(self, root, error, asked):
        """How far from ``root`` it is certain that a variable is above the level on one side and
        below it on the other; begins with ``error``.  Also the status that far below ``root``."""
        names, limit, level, given, *how = asked
        left, status = np.arange(root.size), np.zeros(root.size, np.int8)
        for _ in range(ATTEMPTS):
            here = {name: column[left] for name, column in given.items()}
            sides = []
            for sign in (-1.0, 1.0):
                value = np.exp(root[left] + sign * error[left])
                point = here | {self.along: value}
                asked_for = (
                    names,
                    limit[left],
                    level[left],
                    point,
                    *how,
                    ["error_bound", "solution_status"],
                )
                excess, also = excess_over(*asked_for)
                if sign < 0.0:
                    status[left] = also["solution_status"]
                margin = also["error_bound"] * np.abs(excess + level[left])
                sides.append(np.where(np.abs(excess) > margin, np.sign(excess), 0.0))
            left = left[~(sides[0] * sides[1] < 0.0)]
            if left.size == 0:
                return error, status
            error[left] *= WIDER
        error[left] = np.inf
        return error, status


def _may_touch(excess):
    """Whether a curve turns round near its level between three neighbouring values, by the index of
    the first: the middle one is nearest to the level, and within the larger of the steps beside it."""
    first, middle, last = np.abs(excess[:-2]), np.abs(excess[1:-1]), np.abs(excess[2:])
    same = (np.sign(excess[:-2]) == np.sign(excess[1:-1])) & (
        np.sign(excess[1:-1]) == np.sign(excess[2:])
    )
    nearest = (middle < first) & (middle < last)
    return same & nearest & (middle <= np.maximum(first, last) - middle)
