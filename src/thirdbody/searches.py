"""Searches along an axis: ``find`` and ``transitions`` for crossings of levels, and of the limits
between regimes and modes; ``turning_point`` and ``turning_window`` for maxima of A_sa,t*."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.conditions import (
    axis_of,
    check_count,
    check_rtol,
    common_index,
    ends_in_si,
    from_si,
    numbers_in,
    read_conditions,
    to_si,
)
from thirdbody.core.crossings import crossings
from thirdbody.core.parameters import Parameters
from thirdbody.core.regimes import LUBRICATION_REGIMES, SOLUTION_STATUSES
from thirdbody.core.solve import DEFAULT_RTOL, solve_points
from thirdbody.core.transitions import LIMITS
from thirdbody.core.turning_points import TurningPoints, turning_points
from thirdbody.core.windows import Window, WindowSearch, turning_point_windows
from thirdbody.inputs import or_calibrated
from thirdbody.printed import LOADS
from thirdbody.progress import Progress
from thirdbody.tabular import Tabular, indexed
from thirdbody.variables import QUANTITIES, decimal

if TYPE_CHECKING:
    import pandas as pd

SWEEP = 32  # values along the axis
LOADS_SWEPT = 60  # between which maxima are sought
RATIOS = np.linspace(0.2, 3.0, 113)  # sampled x_a/sigma of a window
TOLERANCE = 1e-6  # of its ends
DRY = {"viscosity": 0.0, "particle_diameter": 0.0}  # for a window; any diameter


@dataclass(frozen=True, eq=False)
class Crossings(Tabular):
    """Where a variable crosses levels: arrays with an element per crossing, in the order of the queries.

    ``along`` is the axis, by its name with a unit, ``shape`` the broadcast shape of the level and
    the other axes, and ``query`` a flat index into it.  ``conditions`` are the level and axes that differ
    between queries, an element per query.  ``value`` is the place of the crossing in
    the unit of ``along``, increasing within a query; ``rises`` is whether the variable increases
    there, and ``solution_status`` an index into ``thirdbody.core.regimes.SOLUTION_STATUSES``.
    ``error`` bounds the error of ``value``: at this distance on both sides, the variable is above
    and below the level by more than its ``error_bound``; infinite if float64 cannot decide that.
    """

    along: str
    shape: tuple[int, ...]
    conditions: Mapping[str, NDArray]
    query: NDArray
    value: NDArray
    error: NDArray
    rises: NDArray
    solution_status: NDArray
    index: pd.Index | None = None

    @property
    def count(self) -> NDArray:
        """Number of crossings of each query, of ``shape``; 0 if there is none in the range."""
        return np.bincount(self.query, minlength=np.prod(self.shape, dtype=int)).reshape(self.shape)

    @property
    def first(self) -> NDArray:
        """The smallest crossing of each query, of ``shape``; nan if there is none."""
        first = np.full(self.shape, np.nan)
        first.ravel()[self.query[::-1]] = self.value[::-1]  # the last assignment wins
        return first

    def __repr__(self) -> str:
        """The crossings as a table."""
        return f"Crossings along {self.along}:\n{super().__str__()}"

    __str__ = __repr__

    def to_dataframe(self) -> pd.DataFrame:
        """One row per crossing: query, conditions that differ, value in the unit of ``along``, its error,
        direction and status."""
        import pandas as pd

        columns = {"query": self.query} | _of_queries(self.conditions, self.query)
        columns |= {self.along: self.value, "error": self.error}
        status = np.array(SOLUTION_STATUSES)[self.solution_status]
        table = pd.DataFrame(columns | {"rises": self.rises, "solution_status": status})
        return indexed(table, self.index, self.query)


class Border(NamedTuple):
    """A limit between two states of a flag, ``lubrication_regime`` or ``contact_mode``."""

    flag: str
    below: str
    above: str

    @property
    def name(self) -> str:
        """Both states."""
        return f"{self.below}_and_{self.above}"


@dataclass(frozen=True, eq=False)
class TurningLoads(TurningPoints, Tabular):
    """``TurningPoints``, also with F_TPCA, the load in newtons."""

    load_N: NDArray
    index: pd.Index | None = None


class TurningWindow(Window, Tabular):
    """``Window`` as a table."""


IN_FULL_FILM = "full_film"
FULL_FILM = LUBRICATION_REGIMES.index(IN_FULL_FILM)
BORDERS = (  # at each of ``LIMITS``
    Border("lubrication_regime", "mixed", "boundary"),
    Border("lubrication_regime", "full_film", "mixed"),
    Border("contact_mode", "hybrid", "particle_surface"),
    Border("contact_mode", "surface_surface", "hybrid"),
)


@dataclass(frozen=True)
class Transition:
    """A change of regime or mode along an axis.

    ``query`` is the flat index into the broadcast shape of the other axes; ``before`` and ``after``
    are the regime or mode at smaller and larger values; ``value`` is the place of the change in the
    unit of the axis, and ``error`` bounds its error; ``solution_status``, one of
    ``thirdbody.core.regimes.SOLUTION_STATUSES``, is whether the equations are valid there.
    """

    query: int
    border: Border
    before: str
    after: str
    value: float
    error: float
    solution_status: str


class Transitions(Tabular, list):
    """A list of ``Transition`` ``along`` an axis, sorted by query, then by value; ``conditions`` are those
    that differ between queries, as in ``Crossings``."""

    def __init__(
        self,
        along: str,
        conditions: Mapping[str, NDArray],
        changes: Iterable[Transition],
        index: pd.Index | None = None,
    ) -> None:
        super().__init__(changes)
        self.along, self.conditions, self.index = along, conditions, index

    def to_dataframe(self) -> pd.DataFrame:
        """One row per change: query, conditions that differ, and its place in a column named ``along``."""
        import pandas as pd

        table = pd.DataFrame([vars(each) for each in self], columns=[*Transition.__annotations__])
        table = table.assign(border=[each.border.flag for each in self])
        query = table.pop("query").to_numpy(int)
        columns = {"query": query} | _of_queries(self.conditions, query)
        table = pd.DataFrame(columns).join(table.rename(columns={"value": self.along}))
        return indexed(table, self.index, query)


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
    """Find all crossings of a level by a variable along one of the five axes.

    Without any crossing, ``count`` of the result is 0 and ``first`` nan.  Raises ``ValueError`` for an
    unknown variable or axis, an impossible level, ends that are not positive and increasing, a
    ``count`` out of range, and where ``solve`` does.

    Parameters
    ----------
    variable : str
        A number of ``Solution``: ``solid_load_fraction``, ``total_contact_area``, ...
    level : array_like
        Its value, in SI, or a column of pandas; ``thirdbody.core.regimes`` has the limits between regimes and modes.
    along : str
        The axis, by its name in the unit of the results: ``load`` [1] or ``load_N``, ...
    between : pair of float, optional
        Ends of the search in the unit of ``along``, or quantities.  By default 0.01 to 1000 N, 1 to 1000 cSt, 10 to
        10000 nm (diameter), 20 to 2000 nm (roughness) and 1e8 to 1e14 m-2.
    count : int
        Number of sampled values, from 2 to a million.
    parameters, rtol, progress, **conditions
        As in ``thirdbody.solve``, without the axis; the conditions and ``level`` broadcast.

    Notes
    -----
    Two crossings between neighbouring samples are missed, unless the curve is seen to have an
    extremum there: where the middle of three samples is nearest to the level, and within the larger
    of the steps beside it, both cells are sampled again, down to a 64th of the spacing.  A crossing
    next to a value without solution is missed.  A jump across the level, at a point with several
    roots, of which ``solve`` gives the largest, also counts as a crossing.

    Examples
    --------
    The viscosities above which the solids carry less than 90 % and less than half of 10 N:

    >>> import thirdbody as tb
    >>> layer = dict(particle_diameter_nm=500, particle_density_per_m2=1e11, roughness_nm=300)
    >>> found = tb.find("solid_load_fraction", [0.9, 0.5], "viscosity_cSt", load_N=10, **layer)
    >>> found.count, bool(found.first[0] < found.first[1])
    (array([1, 1]), True)
    """
    parameters = or_calibrated(parameters)
    check_rtol(rtol)
    levels = _read_levels(variable, level)
    samples = sample(along, between, count, parameters)
    asked = queries(conditions, parameters, along, level=levels)
    others = dict(asked.columns)
    limits = [(variable, others.pop("level"))]
    with Progress(count * asked.size, "points", progress) as bar:
        found = crossings(limits, axis_of(along).name, samples, others, parameters, rtol, bar.add)
    newtons = parameters.newtons_per_load
    return Crossings(
        along=along,
        shape=asked.shape,
        conditions=asked.differing(newtons),
        query=found.query,
        value=from_si(along, found.value, newtons),
        error=from_si(along, found.error, newtons),
        rises=found.rises,
        solution_status=found.solution_status,
        index=common_index(conditions | {"level": level}),
    )


def transitions(
    along: str = "load",
    *,
    parameters: Parameters | None = None,
    between: tuple[float, float] | None = None,
    count: int = SWEEP,
    rtol: float = DEFAULT_RTOL,
    progress: bool = True,
    **conditions: ArrayLike,
) -> Transitions:
    """Find where lubrication regime and contact mode change along one of the five axes.

    Arguments, units, search and errors are those of ``thirdbody.find``.  Changes of the contact mode in a
    full film, where hardly anything touches, are left out.

    Examples
    --------
    >>> import thirdbody as tb
    >>> layer = dict(particle_diameter_nm=500, particle_density_per_m2=1e11, roughness_nm=300)
    >>> found = tb.transitions("viscosity_cSt", load_N=10, **layer)
    >>> [(each.before, each.after) for each in found if each.border.flag == "lubrication_regime"]
    [('boundary', 'mixed'), ('mixed', 'full_film')]
    """
    parameters = or_calibrated(parameters)
    check_rtol(rtol)
    samples = sample(along, between, count, parameters)
    asked = queries(conditions, parameters, along)
    changes = all_changes(along, samples, asked, parameters, rtol, progress)
    kept = [change for change in changes if change.solution_status != IN_FULL_FILM]
    return Transitions(along, asked.differing(parameters.newtons_per_load), kept, asked.index)


def all_changes(
    along: str,
    samples: NDArray,
    asked: Queries,
    parameters: Parameters,
    rtol: float = DEFAULT_RTOL,
    progress: bool = True,
) -> list[Transition]:
    """The changes of ``transitions`` for values from ``sample`` and conditions from ``queries``, and those of the
    contact mode in a full film, with the status ``IN_FULL_FILM``."""
    axis = axis_of(along)
    limits = [(quantity, np.full(asked.size, level)) for quantity, level in LIMITS]
    with Progress(samples.size * asked.size, "points", progress) as bar:
        found = crossings(limits, axis.name, samples, asked.columns, parameters, rtol, bar.add)
    newtons = parameters.newtons_per_load
    value, error = (from_si(along, numbers, newtons) for numbers in (found.value, found.error))
    points = {name: column[found.query] for name, column in asked.columns.items()}
    points[axis.name] = to_si(along, value, newtons)
    solved = solve_points(points, parameters, rtol, ["lubrication_regime"])
    is_full = solved["lubrication_regime"] == FULL_FILM
    columns = found._replace(value=value, error=error)
    changes = []
    for limit, query, value, error, rises, status, full in zip(
        *map(np.ndarray.tolist, (*columns, is_full))
    ):
        border = BORDERS[limit]
        states = (border.below, border.above) if rises else (border.above, border.below)
        is_left_out = full and border.flag == "contact_mode"
        status = IN_FULL_FILM if is_left_out else SOLUTION_STATUSES[status]
        changes.append(Transition(query, border, *states, value, error, status))
    return changes


def turning_point(
    *,
    parameters: Parameters | None = None,
    between_N: tuple[float, float] = LOADS,
    count: int = LOADS_SWEPT,
    rtol: float = DEFAULT_RTOL,
    progress: bool = True,
    **conditions: ArrayLike,
) -> TurningLoads:
    """Find the turning point of the contact area over the load: the maximum of A_sa,t*.

    The result has arrays of the broadcast shape; ``exists`` marks the curves with a turning point.
    ``load`` is F_t* [1], ``load_N`` the same in newtons.  Raises ``ValueError`` for loads that do not
    increase, a ``count`` out of range, and where ``solve`` does.

    Parameters
    ----------
    between_N : pair of float
        First and last load of the curve [N], by default those of the paper (Table 2).  The maximum
        must exceed the least values on both sides of it between them.
    count : int
        Number of loads between which maxima are sought; two within one step are missed.
    parameters, rtol, progress, **conditions
        As in ``thirdbody.solve``, without the load; the conditions broadcast.

    Examples
    --------
    >>> import thirdbody as tb
    >>> layer = dict(particle_diameter_nm=[20, 300], particle_density_per_m2=1e11, roughness_nm=300)
    >>> tb.turning_point(viscosity_cSt=0, **layer).exists
    array([False,  True])
    """
    parameters = or_calibrated(parameters)
    check_rtol(rtol)
    check_count(count)
    loads = np.geomspace(*ends_in_si("between_N", between_N, "load_N", parameters), count)
    asked = queries(conditions, parameters, "load")
    points = {"load": loads[:, None]} | asked.columns
    with Progress(count * asked.size, "points", progress) as bar:
        solved = solve_points(points, parameters, rtol, ["separation"], bar.add)
    found = turning_points(solved["separation"], **asked.columns, parameters=parameters, rtol=rtol)
    columns = vars(found) | {"load_N": found.load * parameters.newtons_per_load}
    columns = {name: column.reshape(asked.shape) for name, column in columns.items()}
    return TurningLoads(**columns, index=asked.index)


def turning_window(
    *,
    parameters: Parameters | None = None,
    between_N: tuple[float, float] = LOADS,
    **conditions: float,
) -> TurningWindow:
    """Find the longest range of x_a/sigma, from 0.2 to 3, in which dry contact has a turning point.

    Arguments and errors are those of ``turning_point``; the conditions are one roughness and one
    particle density.  The ends are nan if there is no such range.

    Examples
    --------
    >>> import thirdbody as tb
    >>> window = tb.turning_window(roughness_nm=300, particle_density_per_m2=1e11)
    >>> bool(window.low < 1.0 < window.high)
    True
    """
    for key in conditions:
        if axis_of(key).name in ("load", *DRY):
            message = "allowed: roughness and particle density"
            raise ValueError(f"{key} is not a condition of a window in dry contact; {message}")
    parameters = or_calibrated(parameters)
    asked = queries(DRY | conditions, parameters, "load")
    if asked.shape:
        names = " and ".join(conditions)
        raise ValueError(f"{names} have shape {asked.shape}; allowed: one number each")
    loads = ends_in_si("between_N", between_N, "load_N", parameters)
    search = WindowSearch(RATIOS, tolerance=TOLERANCE)
    (density,) = asked.columns["particle_density"].tolist()
    roughness = asked.columns["roughness"]
    (window,) = turning_point_windows(search, roughness, density, loads, parameters)
    return TurningWindow(**vars(window))


class Queries(NamedTuple):
    """The combinations of conditions along whose remaining axis is searched.

    ``columns`` are conditions [SI] and other numbers by name, flat, of the broadcast ``shape``; ``keys`` the names of
    the conditions in tables, and ``index`` that of columns of pandas.
    """

    shape: tuple[int, ...]
    columns: dict[str, NDArray]
    keys: dict[str, str]
    index: pd.Index | None

    @property
    def size(self) -> int:
        """Their number."""
        return next(iter(self.columns.values())).size

    def differing(self, newtons_per_load: float) -> dict[str, NDArray]:
        """The columns that differ between queries; conditions by their names in tables, and in these units."""
        differ = {}
        for name, column in self.columns.items():
            if np.unique(column).size > 1:
                if name in self.keys:
                    name = self.keys[name]
                    column = decimal(from_si(name, column, newtons_per_load))
                differ[name] = column
        return differ


def queries(
    conditions: Mapping[str, ArrayLike], parameters: Parameters, along: str, **others: NDArray
) -> Queries:
    """The combinations of ``others`` and of the conditions, except the one ``along`` which is searched."""
    read = read_conditions(conditions, parameters, without=axis_of(along).name)
    if read.labelled:
        raise ValueError(
            f"{', '.join(read.labelled)} have named dimensions; allowed: their .values"
        )
    arrays = others | read.arrays
    columns = np.broadcast_arrays(*arrays.values())
    flat = dict(zip(arrays, map(np.ravel, columns), strict=True))
    return Queries(shape=columns[0].shape, columns=flat, keys=read.keys, index=read.index)


def sample(
    along: str, between: tuple[float, float] | None, count: int, parameters: Parameters
) -> NDArray:
    """The sampled values of an axis [SI]; arguments as in ``find``."""
    check_count(count)
    if between is None:
        axis = axis_of(along)
        ends = to_si(axis.alias, axis.searched, parameters.newtons_per_load)
    else:
        ends = ends_in_si("between", between, along, parameters)
    return np.geomspace(*ends, count)


def _of_queries(conditions, query) -> dict[str, NDArray]:
    """The ``conditions`` of each row with a ``query``."""
    return {name: column[query] for name, column in conditions.items()}


def _read_levels(variable: str, level: ArrayLike) -> NDArray:
    """The levels of a variable [SI]; ``ValueError`` for those that it cannot have."""
    unit = QUANTITIES[variable].unit
    levels = numbers_in("level", level, unit)
    most = 0.01 if unit == "m" else 1.0
    impossible = levels[~((levels >= 0.0) & (levels <= most))]
    if impossible.size:
        raise ValueError(f"level of {variable} is {impossible[0]:g}; allowed: 0 to {most:g} {unit}")
    return levels
