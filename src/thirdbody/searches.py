"""Searches along an axis.

``find`` finds crossings of a level, ``transitions`` those of the limits between regimes and modes.
``turning_point`` and ``turning_window`` find maxima of A_sa,t*.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, Unpack

import numpy as np
import pandas as pd
from numpy.typing import ArrayLike, NDArray

from thirdbody.conditions import (
    ConditionArguments,
    Conditions,
    axis_of,
    check_count,
    check_rtol,
    checked_variables,
    common_index,
    from_si,
    indexed,
    numbers_in,
    read_conditions,
    read_ends,
    searched_ends,
)
from thirdbody.core.contact import Contact
from thirdbody.core.crossings import Crossings, crossings
from thirdbody.core.parameters import Parameters
from thirdbody.core.regimes import LIMITS, LubricationRegime, states_of
from thirdbody.core.solve import DEFAULT_RTOL, solve_points
from thirdbody.core.turning_points import PROMINENCE, load_at, turning_points
from thirdbody.core.windows import WindowSearch, turning_point_windows
from thirdbody.ensembles import MEMBER, Ensemble
from thirdbody.inputs import or_calibrated
from thirdbody.progress import progress_bar
from thirdbody.variables import AXES, CONDITIONS, QUANTITIES

LOADS = AXES["load"].paper  # first and last [N] of a curve
SWEEP = 32  # values along the axis
LOADS_SWEPT = 60  # number of loads between which maxima are sought
RATIOS = np.linspace(0.2, 3.0, 113)  # sampled x_a/sigma of a window
TOLERANCE = 1e-6  # of the ends of a window
DRY = {"viscosity": 0.0, "particle_diameter": 0.0}  # of a window; the diameter has no effect


def find(
    variable: str,
    level: ArrayLike,
    along: str,
    *,
    parameters: Parameters | Ensemble | None = None,
    members: bool = False,
    between: tuple[float, float] | None = None,
    count: int = SWEEP,
    rtol: float = DEFAULT_RTOL,
    progress: bool = True,
    **conditions: Unpack[ConditionArguments],
) -> pd.DataFrame:
    """Find all crossings of a level by a variable along one of the five axes.

    Parameters
    ----------
    variable : str
        Name of a number in ``Solution``, such as ``solid_load_fraction`` or
        ``total_contact_area``, but not ``error_bound``.
    level : array_like
        Value of the variable in SI, also a column of pandas.  ``thirdbody.core.regimes`` has the
        limits between regimes and modes.
    along : str
        Name of the axis, which also sets the unit of the results: ``load`` [1] or ``load_N``, ...
    between : pair of float
        Ends of the search in the unit of ``along``, or quantities.  By default 0.01 to 1000 N, 1 to
        1000 cSt, 10 to 10000 nm (particle size), 20 to 2000 nm (roughness) and 1e8 to 1e14 m-2.
    count : int
        Number of samples along the axis, 2 or more.
    parameters, members, rtol, progress, **conditions
        As in ``thirdbody.solve``, without the condition ``along``.  The conditions and ``level``
        broadcast.

    Returns
    -------
    pandas.DataFrame
        A row for each crossing, sorted by query and then by value.  The index is that of columns of
        pandas, or ``query``, the flat index into the broadcast shape.  With ``members`` the first
        level of the index is ``member``, the best first.

        The columns are the conditions, in the units of the call; the ``level``; the value of the
        axis at the crossing, under the name ``along``; a bound on the ``error`` of this value;
        whether the variable ``rises`` at the crossing; and the ``solution_status``.  At the
        distance ``error`` on both sides the variable is above and below the level by more than its
        ``error_bound``.  Where float64 cannot decide this, ``error`` is infinite.

    Raises
    ------
    ValueError
        For an impossible level, ends that are not positive and increasing, a ``count`` below 2, and
        as in ``solve``.

    Notes
    -----
    Two crossings between neighbouring samples can be missed.  The search looks for them at an
    extremum near the level: if the middle of three samples is nearest to the level, and within the
    larger step to its neighbours, the intervals on both sides are sampled again, down to a 64th of
    the spacing.  A crossing next to a sample without solution is missed.  A jump across the level
    counts as a crossing.  It occurs where the force balance has several roots, as ``solve`` returns
    the largest.

    Examples
    --------
    The viscosities above which the solids carry less than 90 % and less than half of 10 N:

    >>> import thirdbody as tb
    >>> layer = dict(particle_diameter_nm=500, particle_density_per_m2=1e11, roughness_nm=300)
    >>> table = tb.find("solid_load_fraction", [0.9, 0.5], "viscosity_cSt", load_N=10, **layer)
    >>> print(table[["level", "viscosity_cSt"]].round(1).to_string(index=False))
     level  viscosity_cSt
       0.9           83.1
       0.5          143.3
    """
    ensemble = or_calibrated(parameters)
    check_rtol(rtol)
    levels = _read_levels(variable, level)
    check_count(count)
    best, axis = ensemble.best, axis_of(along)
    ends = (
        searched_ends(axis, best) if between is None else read_ends("between", between, along, best)
    )
    read = read_conditions(conditions, best, without=axis.name)
    index = common_index({**conditions, "level": level})

    def search(inputs: Ensemble) -> pd.DataFrame:
        samples = np.geomspace(*ends.with_load(inputs.best), count)
        queries = replace(Queries.of(read, inputs.best, level=levels), index=index)
        limits = [(variable, queries.columns["level"])]
        crossed = _crossings(queries, along, limits, samples, inputs, rtol, progress)
        table = queries.table(crossed.query) | _columns(crossed, along, inputs.best)
        table |= {
            "rises": crossed.rises,
            "solution_status": _names("solution_status", crossed.solution_status),
        }
        return _indexed(table, queries, crossed.query)

    return _of_members(search, ensemble, members)


def transitions(
    along: str = "load",
    *,
    parameters: Parameters | Ensemble | None = None,
    members: bool = False,
    between: tuple[float, float] | None = None,
    count: int = SWEEP,
    rtol: float = DEFAULT_RTOL,
    progress: bool = True,
    **conditions: Unpack[ConditionArguments],
) -> pd.DataFrame:
    """Find where lubrication regime and contact mode change along one of the five axes.

    Arguments, search and errors are as in ``thirdbody.find``.  Changes of the contact mode in a
    full film are left out, because hardly anything touches.

    Returns
    -------
    pandas.DataFrame
        A row for each change, as in ``find``.  The columns ``level`` and ``rises`` are replaced by
        the ``flag`` that changes, and its states ``before`` and ``after``, at smaller and larger
        values.

    Examples
    --------
    >>> import thirdbody as tb
    >>> layer = dict(particle_diameter_nm=500, particle_density_per_m2=1e11, roughness_nm=300)
    >>> table = tb.transitions("viscosity_cSt", load_N=10, **layer)
    >>> print(table[["before", "after", "viscosity_cSt"]].round(1).to_string(index=False))
      before            after  viscosity_cSt
    boundary            mixed           83.1
      hybrid particle_surface          159.4
       mixed        full_film          309.0
    """
    ensemble = or_calibrated(parameters)
    check_rtol(rtol)
    check_count(count)
    best, axis = ensemble.best, axis_of(along)
    ends = (
        searched_ends(axis, best) if between is None else read_ends("between", between, along, best)
    )
    read = read_conditions(conditions, best, without=axis.name)

    def search(inputs: Ensemble) -> pd.DataFrame:
        samples = np.geomspace(*ends.with_load(inputs.best), count)
        queries = Queries.of(read, inputs.best)
        limits = [(quantity, np.full(queries.size, level)) for quantity, level, *_ in LIMITS]
        crossed = _crossings(queries, along, limits, samples, inputs, rtol, progress)
        points = {name: column[crossed.query] for name, column in queries.columns.items()}
        points = inputs.setup.without_speed(points | {axis.name: crossed.value}, inputs.best)
        solved = solve_points(points, inputs.best, rtol, ["lubrication_regime"])
        is_full = solved["lubrication_regime"] == LubricationRegime.full_film.code
        _, _, flag, below, above = np.array(LIMITS, object)[crossed.limit].T.reshape(5, -1)
        table = queries.table(crossed.query)
        table |= {
            "flag": flag,
            "before": np.where(crossed.rises, below, above),
            "after": np.where(crossed.rises, above, below),
        }
        table |= _columns(crossed, along, inputs.best)
        table |= {"solution_status": _names("solution_status", crossed.solution_status)}
        return _indexed(table, queries, crossed.query)[~(is_full & (flag == "contact_mode"))]

    return _of_members(search, ensemble, members)


def turning_point(
    *,
    parameters: Parameters | Ensemble | None = None,
    members: bool = False,
    between_N: tuple[float, float] = LOADS,
    count: int = LOADS_SWEPT,
    rtol: float = DEFAULT_RTOL,
    progress: bool = True,
    **conditions: Unpack[ConditionArguments],
) -> pd.DataFrame:
    """Find the turning point of the contact area over the load: the maximum of A_sa,t*.

    Parameters
    ----------
    between_N : pair of float
        First and last load of the curve [N], by default those of the paper (Table 2).  The maximum
        must exceed the least value before it and the least value after it on this curve.
    count : int
        Number of loads between which maxima are sought.  Two maxima within one step are missed.
    parameters, members, rtol, progress, **conditions
        As in ``thirdbody.solve``, without the load.  The conditions broadcast.

    Returns
    -------
    pandas.DataFrame
        A row for each curve.  The index is that of columns of pandas, or ``query``.  The columns
        are the conditions, in the units of the call; whether the turning point ``exists``; F_TPCA
        as ``load`` [1] and ``load_N``; ``load_error``, a bound on the error of ``load``;
        ``peak_ratio``, the maximum of A_sa,t* [1]; ``solid_load_fraction``; ``separation_m``;
        ``prominence`` [1]; and ``is_cut``.  A curve ``is_cut`` if A_sa,t* rises by the prominence
        of a turning point, but does not fall by as much up to the last load: it may turn at a
        higher load.

    Raises
    ------
    ValueError
        For loads that do not increase, a ``count`` below 2, and as in ``solve``.

    Examples
    --------
    >>> import thirdbody as tb
    >>> layer = dict(particle_diameter_nm=[20, 300], particle_density_per_m2=1e11, roughness_nm=300)
    >>> tb.turning_point(viscosity_cSt=0, **layer)["exists"].tolist()
    [False, True]
    """
    ensemble = or_calibrated(parameters)
    check_rtol(rtol)
    check_count(count)
    ends = read_ends("between_N", between_N, "load_N", ensemble.best)
    read = read_conditions(conditions, ensemble.best, without="load")

    def search(inputs: Ensemble) -> pd.DataFrame:
        best = inputs.best
        loads = np.geomspace(*ends.with_load(best), count)
        queries = Queries.of(read, best)
        curves = inputs.setup.without_speed(queries.columns, best)
        points = {"load": loads[:, None]} | curves
        names = ["separation", "particle_contact_area_ratio"]
        with progress_bar(count * queries.size, progress) as bar:
            solved = solve_points(points, best, rtol, names, bar.update)
        maxima = turning_points(solved["separation"], **curves, parameters=best, rtol=rtol)
        ratio = solved["particle_contact_area_ratio"]
        rise = np.fmax.reduce(ratio - np.fmin.accumulate(ratio))
        every = np.arange(queries.size)
        table = queries.table(every)
        table |= {
            "exists": maxima.exists,
            "load_N": maxima.load * best.newtons_per_load,
            "load": maxima.load,
            "load_error": maxima.load_error,
            "peak_ratio": maxima.peak_ratio,
            "solid_load_fraction": maxima.solid_load_fraction,
            "separation_m": maxima.separation,
            "prominence": maxima.prominence,
            "is_cut": ~maxima.exists & (rise >= PROMINENCE),
        }
        return _indexed(table, queries, every)

    return _of_members(search, ensemble, members)


def turning_window(
    *,
    parameters: Parameters | Ensemble | None = None,
    members: bool = False,
    between_N: tuple[float, float] = LOADS,
    **conditions: Unpack[ConditionArguments],
) -> pd.DataFrame:
    """Find the longest range of x_a/sigma, from 0.2 to 3, in which dry contact has a turning point.

    Arguments and errors are as in ``turning_point``.  The conditions are the roughness and the
    particle density.  The curves end at the largest load that all these sizes carry dry, if it is
    below the last load.

    Returns
    -------
    pandas.DataFrame
        A row for each pair of conditions.  It has the ends ``low`` and ``high`` [1] of the range,
        and bounds ``low_error`` and ``high_error`` on their errors.  All are nan without a range.

    Examples
    --------
    >>> import thirdbody as tb
    >>> table = tb.turning_window(roughness_nm=[100, 300], particle_density_per_m2=1e11)
    >>> bool((table["low"] < 1.0).all() and (table["high"] > 1.0).all())
    True
    """
    for key in conditions:
        if axis_of(key).name in ("load", "speed", *DRY):
            message = "allowed: roughness and particle density"
            raise ValueError(f"{key} is not a condition of a window in dry contact; {message}")
    ensemble = or_calibrated(parameters)
    loads = read_ends("between_N", between_N, "load_N", ensemble.best)
    read = read_conditions(DRY | {**conditions}, ensemble.best, without="load")

    def search(inputs: Ensemble) -> pd.DataFrame:
        best = inputs.best
        queries = Queries.of(read, best)
        windows_of = WindowSearch(RATIOS, tolerance=TOLERANCE)
        roughness, density = queries.columns["roughness"], queries.columns["particle_density"]
        ends = pd.DataFrame(index=range(queries.size), columns=WINDOW_COLUMNS, dtype=float)
        first, last = loads.with_load(best)
        lasts = np.array([_last_load(first, last, *row, best) for row in zip(roughness, density)])
        for level, end in {*zip(density, lasts)}:
            rows = np.flatnonzero((density == level) & (lasts == end))
            windows = turning_point_windows(windows_of, roughness[rows], level, (first, end), best)
            ends.loc[rows, WINDOW_COLUMNS] = [
                [getattr(window, name) for name in WINDOW_COLUMNS] for window in windows
            ]
        every = np.arange(queries.size)
        table = queries.table(every)
        table = {key: column for key, column in table.items() if key not in DRY}
        return _indexed(table | ends.to_dict("series"), queries, every)

    return _of_members(search, ensemble, members)


def _last_load(first, last, roughness, density, parameters):
    """The ``last`` load F_t* [1] of the curves of a window, or the largest that all sizes carry dry
    if this is less.

    It stays where not even the ``first`` load is carried.
    """
    sigma, zero = np.full(RATIOS.shape, roughness), np.zeros(RATIOS.shape)
    solids = Contact.of(RATIOS * roughness, sigma, np.full(RATIOS.shape, density), parameters)
    carried, _, _ = load_at(solids, viscosity=zero, roughness=sigma, separation=zero)
    most = (1.0 - TOLERANCE) * carried.min()
    return most if first < most < last else last


WINDOW_COLUMNS = ["low", "low_error", "high", "high_error"]


@dataclass(frozen=True, eq=False)
class Queries:
    """Combinations of the fixed conditions, with a search along the remaining axis for each.

    ``columns`` are 1-D arrays of conditions [SI] and other numbers by name.  ``keys`` are the names
    of the conditions in tables, ``given`` their values there, and ``index`` is that of columns of
    pandas.
    """

    columns: dict[str, NDArray]
    keys: dict[str, str]
    given: dict[str, NDArray]
    index: pd.Index | None

    @classmethod
    def of(cls, read: Conditions, parameters: Parameters, **others: Any) -> Queries:
        """The combinations of conditions and ``others``; loads are F_t* of ``parameters``."""
        if read.labelled:
            names = ", ".join(read.labelled)
            raise ValueError(f"{names} have named dimensions; allowed: their .values")
        arrays = read.with_load(parameters) | others
        every = [*arrays.values(), *read.given.values()]
        flat = [*map(np.ravel, np.broadcast_arrays(*every))]
        return cls(
            columns=dict(zip(arrays, flat)),
            keys=read.keys,
            given=dict(zip(read.given, flat[len(arrays) :])),
            index=read.index,
        )

    @property
    def size(self) -> int:
        """The number of combinations."""
        return next(iter(self.columns.values())).size

    def table(self, rows: NDArray) -> dict[str, NDArray]:
        """The columns at ``rows``; conditions have the names and units of tables."""
        columns = self.columns | self.given
        return {self.keys.get(name, name): column[rows] for name, column in columns.items()}


def _of_members(
    search: Callable[[Ensemble], pd.DataFrame], ensemble: Ensemble, members: bool
) -> pd.DataFrame:
    """The table of the best set; with ``members`` the tables of all, the number of the member as
    the first level of the index."""
    if not members:
        return search(ensemble)
    tables = dict(enumerate(map(search, ensemble)))
    return pd.concat(tables, names=[MEMBER])


def _crossings(
    queries: Queries,
    along: str,
    limits: Sequence[tuple[str, NDArray]],
    samples: NDArray,
    inputs: Ensemble,
    rtol: float,
    progress: bool,
) -> Crossings:
    """Crossings along a condition.  For the speed the search is along the viscosity instead."""
    axis = axis_of(along).name
    others = {name: column for name, column in queries.columns.items() if name in CONDITIONS}
    scale = 1.0
    if axis == "speed" or (axis == "viscosity" and "speed" in others):
        name = "viscosity" if axis == "speed" else "speed"
        column = others.pop(name)
        if column.min() != column.max() or column[0] == 0.0:
            key = queries.keys[name]
            message = f"{key} is not one positive number"
            raise ValueError(f"{message}; allowed: one positive number, if along is {along}")
        one = {"viscosity": np.ones(1), "speed": np.ones(1)} | {name: column[:1]}
        scale = inputs.setup.without_speed(one, inputs.best)["viscosity"].item()
    others = inputs.setup.without_speed(others, inputs.best)
    solved = "viscosity" if axis == "speed" else axis
    with progress_bar(samples.size * queries.size, progress) as bar:
        crossed = crossings(limits, solved, scale * samples, others, inputs.best, rtol, bar.update)
    return crossed._replace(value=crossed.value / scale, error=crossed.error / scale)


def _columns(crossed: Crossings, along: str, parameters: Parameters) -> dict[str, NDArray]:
    """The values and errors of crossings in the unit of ``along``."""
    newtons = parameters.newtons_per_load
    return {
        along: from_si(along, crossed.value, newtons),
        "error": from_si(along, crossed.error, newtons),
    }


def _names(flag, codes):
    """The names of the states with these codes."""
    return [str(state) for state in states_of(flag, codes)]


def _indexed(columns, queries, rows):
    """The table of ``columns``, with the index of the queries ``rows``."""
    table = pd.DataFrame(columns, index=pd.Index(rows, name="query"))
    return indexed(table, queries.index, rows)


def _read_levels(variable: str, level: ArrayLike) -> NDArray:
    """The levels of a variable [SI]; ``ValueError`` for a level that the variable never has."""
    checked_variables([variable], QUANTITIES)
    unit = QUANTITIES[variable].unit
    levels = numbers_in("level", level, unit)
    most = 0.01 if unit == "m" else 1.0
    impossible = levels[~((levels >= 0.0) & (levels <= most))]
    if impossible.size:
        raise ValueError(f"level of {variable} is {impossible[0]:g}; allowed: 0 to {most:g} {unit}")
    return levels
