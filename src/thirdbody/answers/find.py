"""``find``: where a variable has a level along any of the five axes.

The axis is swept at values evenly spaced in their logarithm.  Two neighbours on both sides of the level
enclose a crossing, which is then found to the error asked for.  Where a curve turns round next to the
level, the sweep is made finer, ``DEPTH`` times by ``FINER``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.conditions.checks import (
    check_count,
    check_ends,
    check_points,
    check_rtol,
    checked_array,
    checked_parameters,
)
from thirdbody.conditions.in_si import in_si
from thirdbody.curves.bracketing import bracketed_roots
from thirdbody.data.quantities import QUANTITIES
from thirdbody.messages import shown
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import SOLUTION_STATUSES
from thirdbody.progress import check_progress
from thirdbody.solver.solve import DEFAULT_RTOL, solve_arrays
from thirdbody.tabular import Tabular
from thirdbody.units import ENGINEERING, SEARCHED, UNITS, Unit, is_labelled, unit_of

if TYPE_CHECKING:
    import pandas as pd

SWEEP = 32  # values along the axis
FINER, DEPTH = 8, 2  # where a curve turns round next to the level
WIDER, ATTEMPTS = 8.0, 8  # until both sides of a crossing are certain


@dataclass(frozen=True)
class Crossings(Tabular):
    """Where a variable has levels: arrays with an element for each crossing, in the order of the queries.

    ``along`` is the axis by its name with a unit, ``shape`` that to which the level and the other axes
    broadcast, and ``query`` an index in its flat order.  ``value`` is where the crossing is, in the unit of
    ``along``, increasing of one query; ``rises`` whether the variable rises there, and ``solution_status``
    an index into ``thirdbody.model.regimes.SOLUTION_STATUSES``.  ``error`` bounds the error of ``value``: so
    far away on both sides the variable has been seen to be above and below the level by more than its
    ``error_bound``; infinite where float64 cannot tell that.
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

    def to_dataframe(self) -> pd.DataFrame:
        """A row a crossing: query, place in the unit of ``along``, its error, direction and status."""
        import pandas as pd

        columns = {"query": self.query, self.along: self.value, "error": self.error}
        status = np.array(SOLUTION_STATUSES)[self.solution_status]
        return pd.DataFrame(columns | {"rises": self.rises, "solution_status": status})


def find(
    variable: str,
    level: ArrayLike,
    along: str,
    *,
    parameters: Parameters | None = None,
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
        The axis, by its name in the unit that is wanted: ``load`` [1] or ``load_N``, ``viscosity``
        [m2/s] or ``viscosity_cSt``, ``particle_diameter`` [m] or ``particle_diameter_nm``,
        ``roughness`` [m] or ``roughness_nm``, ``particle_density`` or ``particle_density_per_m2``.
    between : pair of float, optional
        Ends of the search, positive, in the unit of ``along``.  By default 0.01 to 1000 N, 1 to
        1000 cSt, 10 to 10000 nm (diameter), 20 to 2000 nm (roughness) and 1e8 to 1e14 m-2.
    count : int
        Number of values of the sweep, from 2 to a million.
    parameters, rtol, progress
        As of ``thirdbody.solve``.
    **conditions : array_like
        The other four axes, by any of the names above, as numbers or quantities; they and ``level``
        broadcast.

    Returns
    -------
    Crossings
        Of every query all crossings; where there is none, its ``count`` is 0 and its ``first`` nan.

    Raises
    ------
    ValueError
        In one line: for an unknown variable or axis, a level that the variable cannot have, an axis
        that is missing or given twice, ends that are not positive and increasing, a ``count`` that is
        not whole or out of its range, and what ``solve`` refuses.

    Warns
    -----
    OutOfRangeWarning
        As ``solve``, in the units that were given.

    Notes
    -----
    Two crossings between neighbouring values of the sweep are missed, unless the curve is seen to turn
    round there: where the middle one of three values is nearest to the level, and within the larger
    of the steps beside it, both cells are swept again, down to a 64th of the spacing.  A crossing
    beside a value without solution is missed.  Where a curve jumps across the level, because a point
    has several separations, of which ``solve`` gives the largest, that is a crossing too.

    Examples
    --------
    From which viscosity on the solids carry less than 90 % and less than half of 10 N:

    >>> import thirdbody as tb
    >>> layer = dict(particle_diameter_nm=500, particle_density_per_m2=1e11, roughness_nm=300)
    >>> found = tb.find("solid_load_fraction", [0.9, 0.5], "viscosity_cSt", load_N=10, **layer)
    >>> found.count, bool(found.first[0] < found.first[1])
    (array([1, 1]), True)
    """
    parameters = checked_parameters(parameters)
    level = checked_levels(variable, level)
    check_progress(progress)
    unit, swept = sweep_values(along, between, count, parameters)
    shape, others = queries(conditions, parameters, unit.condition, level=level)
    limits = [(variable, others.pop("level"))]
    (found,) = crossings(limits, unit, swept, others, parameters, rtol, progress)
    return Crossings(along, shape, *found)


def checked_levels(variable: Any, level: ArrayLike) -> NDArray[np.float64]:
    """The levels of a variable; ``ValueError`` for an unknown variable, and levels it cannot have."""
    if not isinstance(variable, str) or variable not in QUANTITIES:
        raise ValueError(f"variable is {shown(variable)}; allowed: {', '.join(QUANTITIES)}")
    quantity = QUANTITIES[variable]
    levels = checked_array("level", level, f"numbers, in {quantity.units}")
    impossible = levels[~((levels >= 0.0) & (levels <= quantity.largest) & np.isfinite(levels))]
    if impossible.size:
        most = f"0 to {quantity.largest:g}" if quantity.largest < np.inf else "zero or positive"
        raise ValueError(f"level of {variable} is {impossible[0]:g}; allowed: {most}")
    return levels


def queries(
    conditions: Mapping[str, ArrayLike], parameters: Parameters, along: str, **more: NDArray
) -> tuple[tuple[int, ...], dict[str, NDArray]]:
    """The shape of queries, to which ``more`` columns and the conditions broadcast, and all of them flat,
    in SI; the condition ``along`` is not given."""
    for key, values in conditions.items():
        if is_labelled(values):
            raise ValueError(f"{key} has named dimensions; allowed: .values of it")
    given = more | in_si(conditions, parameters, without=along)
    check_points(given)
    columns = np.broadcast_arrays(*given.values())
    return columns[0].shape, dict(zip(given, map(np.ravel, columns)))


def sweep_values(
    along: str, between: tuple[float, float] | None, count: int, parameters: Parameters
) -> tuple[Unit, NDArray]:
    """The unit of an axis, and the values [SI] at which it is swept; arguments as of ``find``."""
    axis = unit = unit_of(along)
    if between is None:
        unit, between = UNITS[ENGINEERING[axis.condition]], SEARCHED[axis.condition]
    check_ends("between", between)
    check_count("count", count)
    return axis, np.geomspace(*unit.to_si(between, parameters.newtons_per_load), count)


def crossings(
    limits: Sequence[tuple[str, NDArray]],
    unit: Unit,
    swept: NDArray,
    others: Mapping[str, NDArray],
    parameters: Parameters,
    rtol: float,
    progress: bool = True,
) -> list[tuple]:
    """Find the crossings of several variables, which are solved together.

    ``limits`` are pairs of a variable and its level for each query; ``swept`` values of the axis and
    the ``others`` are in SI.  Returns for each limit the fields of ``Crossings`` from ``query`` on.
    """
    check_rtol(rtol)
    names, levels = [name for name, _ in limits], np.stack([level for _, level in limits])

    def enclosed(query, values, wanted, depth=DEPTH, progress=False):
        """Crossings between neighbouring ``values`` of the axis, shape (values, 1 or queries): limit,
        query, whether it rises, and ln of both neighbours."""
        given = {name: column[query] for name, column in others.items()} | {unit.condition: values}
        variables = {names[index] for index in wanted}
        found = solve_arrays(given, parameters, rtol, variables, progress)
        log_values = np.broadcast_to(np.log(values), (len(values), query.size))
        pieces = []
        for index in wanted:
            excess = getattr(found, names[index]) - levels[index, query]
            above, known = excess > 0.0, np.isfinite(excess)
            step, place = np.nonzero((above[:-1] != above[1:]) & known[:-1] & known[1:])
            ends = log_values[step, place], log_values[step + 1, place]
            limit = np.full(step.size, index)
            pieces.append((limit, query[place], above[step + 1, place], *ends))
            step, place = np.nonzero(_may_touch(excess))
            if depth and place.size:
                ends = log_values[step, place], log_values[step + 2, place]
                finer = np.exp(np.linspace(*ends, 2 * FINER + 1))
                pieces.append(enclosed(query[place], finer, [index], depth - 1))
        return tuple(map(np.concatenate, zip(*pieces)))

    every = np.arange(levels.shape[1])
    limit, query, rises, *ends = enclosed(
        every, swept[:, None], range(len(limits)), progress=progress
    )
    level = levels[limit, query]

    def excess_at(some, log_value, also=()):
        """By how much variables exceed their levels, nan without a solution, at ln of the condition for
        ``some`` of the crossings; and the solution, which has ``also`` other variables."""
        given = {name: column[query[some]] for name, column in others.items()}
        given[unit.condition] = np.exp(log_value)
        found = solve_arrays(given, parameters, rtol, {*names, *also})
        values = np.choose(limit[some], [getattr(found, name) for name in names])
        return values - level[some], found

    log_value, width = _roots(excess_at, ends, 0.1 * rtol)
    log_error, status = _certain(excess_at, level, log_value, 2.0 * (width + rtol))
    value = np.exp(log_value)
    error = value * np.expm1(log_error)
    place, error = (unit.from_si(each, parameters.newtons_per_load) for each in (value, error))
    fields = query, place, error, rises, status
    order = np.lexsort((value, query, limit))
    chosen = (order[limit[order] == index] for index in range(len(limits)))
    return [tuple(field[places] for field in fields) for places in chosen]


def _roots(excess_at, ends, tolerance):
    """ln of the condition where each variable passes its level between two ``ends``, and how narrowly
    that is enclosed."""
    place, value = np.full((2, ends[0].size), np.nan)

    def excess(log_value):
        moved = np.flatnonzero(log_value != place)  # a root that is found stays where it is
        place[moved] = log_value[moved]
        value[moved], _ = excess_at(moved, log_value[moved])
        return value.copy()

    return bracketed_roots(excess, *ends, tolerance)


def _certain(excess_at, level, root, error):
    """How far from ln ``root`` a variable is certain to be above the level on one side and below it on
    the other, from ``error`` on; and the status that far below."""
    left, status = np.arange(root.size), np.zeros(root.size, np.int8)
    for _ in range(ATTEMPTS if root.size else 0):
        sides = []
        for sign in (1.0, -1.0):
            there = root[left] + sign * error[left]
            excess, found = excess_at(left, there, ["error_bound", "solution_status"])
            margin = found.error_bound * np.abs(excess + level[left])
            sides.append(np.where(np.abs(excess) > margin, np.sign(excess), 0.0))
        status[left] = found.solution_status
        left = left[~(sides[0] * sides[1] < 0.0)]
        if left.size == 0:
            return error, status
        error[left] *= WIDER
    error[left] = np.inf
    return error, status


def _may_touch(excess):
    """Whether a curve turns round near its level between three neighbouring values, by the index of
    the first: the middle one is nearest to the level, and within the larger of the steps beside it."""
    distance, sign = np.abs(excess), np.sign(excess)
    first, middle, last = distance[:-2], distance[1:-1], distance[2:]
    same = (sign[:-2] == sign[1:-1]) & (sign[1:-1] == sign[2:])
    nearest = (middle < first) & (middle < last)
    return same & nearest & (middle <= np.maximum(first, last) - middle)
