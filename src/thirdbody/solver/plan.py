"""How points are solved: the only place that chooses a way, for the solver and for its searches.

There are three ways.  By *quadrature* each load and area of the summits is an integral: the most
precise, and the fastest for a few points.  By *tables* they are read off tables of a roughness, or of
a cell that many roughnesses share, which many points repay.  The *compiled* loop solves in machine
code, which is the fastest once it is there: a process has to import the compiler first, and to
compile where no earlier one did, which very many points repay.

A way leaves the points for which it cannot promise the error that is asked for to a more precise one,
that which takes less time for so many; the way that settles a point is the last that stores it.

By default the choice depends on what a process has loaded and solved before, and so do the last
digits.  What is to be made again byte by byte asks for ``REPEATABLE``, a choice between tables and
quadrature by the numbers of points alone.
"""

from __future__ import annotations

import os
from collections import Counter, defaultdict, deque
from collections.abc import Callable, Collection, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass, field, replace
from functools import lru_cache, partial
from itertools import compress
from threading import Lock

import numpy as np
from numpy.typing import NDArray

from thirdbody.extras import require
from thirdbody.messages import shown
from thirdbody.model.parameters import Parameters
from thirdbody.solver import availability
from thirdbody.solver.points import Axis, Conditions
from thirdbody.solver.solution import OF_AREAS, SolvedPoints, type_of
from thirdbody.solver.surfaces import (
    TABLE_SIZES,
    Sheet,
    are_equal,
    cells_of,
    few_surfaces,
    log_yields,
    sheet_of_one,
    summits_of,
    table_size,
)

COMPILED, TABLES, QUADRATURE = WAYS = "compiled", "tables", "quadrature"  # each more precise
REPEATABLE = "repeatable"  # the second or the third, whatever else a process has done
ALLOWED = (*WAYS, REPEATABLE)

# Numbers of points from which a way costs less than it saves, measured by `python -m
# benchmarks.starts`: on one roughness, from which its finest table does,
TABLE_WORTH = 500
# from which the tables of the loop do where the process has called it before,
LOOP_WORTH = 250
# and in all, from which it does to load the loop from disk, or to compile it.
LOADING_WORTH = 600_000
COMPILING_WORTH = 6_000_000
# How many points by quadrature take as long as a call does before it solves any, and as the loop
# does for each group of points, however few, whose tables it has; and how many points by tables take
# as long as one by quadrature.
CALL_WORTH = 100
GROUP_WORTH = 12
QUADRATURE_WORTH = 20
# Points from which it does to start threads, and to begin in single precision, which has machine
# code of its own.
THREADS_WORTH = SINGLE_WORTH = 100_000
# A search looks at a surface so often that tables as coarse as for this rtol always pay.
CHEAP_TABLES = 1e-5

NONE = np.zeros(0, np.intp)  # no places
NO_TURNS = nullcontext()
CHUNK = 16384  # points solved together: their arrays stay in the processor's cache
QUADRATURE_CHUNK = 1024  # the same without tables, where each has some hundred nodes


def check_way(way: str | None) -> None:
    """Refuse a way that does not exist or cannot be had.

    Raises
    ------
    ValueError
        Unless ``way`` is one of ``ALLOWED`` or None.
    ImportError
        If the compiled loop is asked for and numba is not installed.
    """
    if way is not None and not (isinstance(way, str) and way in ALLOWED):
        raise ValueError(f"way is {shown(way)}; allowed: {', '.join(ALLOWED)}, or None to choose")
    if way == COMPILED and not availability.is_loaded():
        require("compiled", "numba")


def search_ways(roughness: NDArray, separations: int, rtol: float) -> Iterator[tuple]:
    """Choose between tables and quadrature for searches along curves.

    Parameters
    ----------
    roughness : array, shape (curves,)
        sigma [m] of each curve.
    separations : int
        About how often each curve is looked at.
    rtol : float
        Relative error asked for.

    Yields
    ------
    way : str
        ``TABLES`` or ``QUADRATURE``.
    table_rtol : float or None
        What tables are good for; None by quadrature.
    curves : array of int
        Indices of all curves that are best searched so.
    """
    _, surface, curves = np.unique(roughness, return_inverse=True, return_counts=True)
    tables = rtol >= CHEAP_TABLES or _tables_pay(curves * separations, rtol)
    worthwhile = np.broadcast_to(tables, curves.shape)[surface]
    for way, table_rtol, chosen in ((TABLES, rtol, worthwhile), (QUADRATURE, None, ~worthwhile)):
        if chosen.any():
            yield way, table_rtol, np.flatnonzero(chosen)


def expect_points(points: int) -> None:
    """Prepare for points that will be solved in several calls.

    Each call sees only its own; if all ``points`` together repay the loading of the compiled loop,
    it is loaded now, and the calls find it there.
    """
    if _loop_pays(points):
        import thirdbody.solver.compiled.points  # noqa: F401


def solve_points(
    conditions: Conditions,
    axes: Mapping[str, Axis],
    parameters: Parameters,
    rtol: float,
    variables: Collection[str],
    way: str | None = None,
    settled: Callable[[int], None] | None = None,
) -> dict[str, NDArray]:
    """Solve points by the way that takes least time.

    Parameters
    ----------
    conditions : Conditions
        The points.
    axes : mapping
        The axis from which each of the conditions was taken, by its name.
    parameters : Parameters
        Inputs of the model.
    rtol : float
        Relative error asked for.
    variables : collection of str
        Names of the variables of ``Solution`` that are wanted.
    way : str, optional
        One of ``WAYS``, by which all points are solved first; or ``REPEATABLE``.
    settled : callable, optional
        Is told, from any thread, how many more points are settled.

    Returns
    -------
    dict
        A 1-D array of each variable, one element a point.
    """
    result = {name: np.empty(conditions.size, type_of(name)) for name in variables}
    roughness, axis = conditions.roughness, axes["roughness"]
    few = few_surfaces(roughness, axis.least == axis.greatest)
    may_be_single = way == COMPILED or conditions.size >= SINGLE_WORTH
    task = _Task(conditions, parameters, rtol, few is None, may_be_single, result, settled)
    groups = list(groups_of(conditions, parameters, few, axes))
    if way is None:
        ways = fastest_ways(groups, parameters, rtol)
    else:
        ways = repeatable_ways(groups, rtol) if way == REPEATABLE else [way] * len(groups)
    first = {each: [] for each in WAYS}
    for group, chosen in zip(groups, ways, strict=True):
        first[chosen].append(group)
    left = task.solve_by_loop(first[COMPILED])
    for group, chosen in zip(left, repeatable_ways(left, rtol), strict=True):
        first[chosen].append(group)
    for places in _of_each_kind(first[TABLES]):
        task.solve_by_quadrature(task.solve_by_tables(places))
    for places in _of_each_kind(first[QUADRATURE]):
        task.solve_by_quadrature(places)
    return result


@dataclass(frozen=True)
class Group:
    """Points on one sheet and of one kind: all with a film or all without, all with particles or
    all without.

    ``places`` are their indices, or the slice of all points.  On the sheet of one w_1 they have one
    roughness.
    """

    sheet: Sheet
    kind: int
    places: slice | NDArray

    @property
    def size(self) -> int:
        """Number of points."""
        places = self.places
        return places.stop - places.start if isinstance(places, slice) else places.size


def groups_of(
    conditions: Conditions,
    parameters: Parameters,
    few: NDArray | None,
    axes: Mapping[str, Axis] | None = None,
) -> Iterator[Group]:
    """The groups of points, by sheet and then by kind; ``few`` is as ``few_surfaces`` says, and ``axes``
    are what the conditions were taken from, if that is known."""
    kinds = labels = conditions.kinds(axes)
    if few is None:
        cells = np.concatenate(
            [
                cells_of(log_yields(summits_of(conditions.roughness[piece], parameters)[1]))
                for piece in _pieces(slice(0, conditions.size), CHUNK)
            ]
        )
        labels = (4 * (cells - cells.min()) + kinds).astype(np.int16)
    elif few.size > 1:
        labels = (4 * np.searchsorted(few, conditions.roughness) + kinds).astype(np.int16)
    for places in _runs(labels, conditions.size):
        first = places.start if isinstance(places, slice) else places[0]
        sheet = sheet_of_one(float(conditions.roughness[first]), parameters)
        if few is None:
            sheet = Sheet.of_cell(cells[first], sheet.materials)
        yield Group(sheet, int(kinds[first] if np.ndim(kinds) else kinds), places)


def _runs(labels, count):
    """The places of equal ``labels``, of ``count`` points or one for all: a slice if all are equal, else
    arrays."""
    if np.ndim(labels) == 0 or are_equal(labels):
        return [slice(0, count)] if count else []
    order = np.argsort(labels, kind="stable")
    edges = np.flatnonzero(np.diff(labels[order])) + 1
    return np.split(order, edges)


def _of_each_kind(groups):
    """Places of all points of a kind, whatever their roughness, kind by kind."""
    kinds = defaultdict(list)
    for group in groups:
        kinds[group.kind].append(group.places)
    for places in kinds.values():
        yield places[0] if len(places) == 1 else np.concatenate(places)


def repeatable_ways(groups: list[Group], rtol: float) -> list[str]:
    """Tables or quadrature for each of ``groups``, which are solved in one call: what takes less time
    for so many points."""
    on_sheet = Counter()
    for group in groups:
        on_sheet[group.sheet] += group.size
    shared = (on_sheet[group.sheet] // group.sheet.terms(rtol) for group in groups)
    return [TABLES if _tables_pay(points, rtol) else QUADRATURE for points in shared]


def fastest_ways(groups: list[Group], parameters: Parameters, rtol: float) -> list[str]:
    """The way that takes least time, for each of ``groups``, which are solved in one call."""
    compiled = _repaid(groups, parameters, rtol)
    if not (availability.is_loaded() or _loading_repaid(list(compress(groups, compiled)))):
        compiled = [False] * len(groups)
    if all(compiled):
        return [COMPILED] * len(groups)
    others = repeatable_ways(groups, rtol)
    return [COMPILED if by_loop else way for by_loop, way in zip(compiled, others, strict=True)]


def solve_numbers(
    numbers: Mapping[str, float], parameters: Parameters, rtol: float, variables: Collection[str]
) -> dict[str, NDArray] | None:
    """Solve one point by what is at hand: the loop, if it is loaded and its tables of the surface are
    made.

    What ``solve_points`` does around the loop takes longer than to solve a point.  Parameters are as
    there, but for ``numbers``, which are the five conditions by name.

    Returns
    -------
    dict or None
        An array of no dimension of each variable; None where ``solve_points`` is to choose a way.
    """
    if not availability.is_loaded():
        return None
    from thirdbody.solver.compiled.points import CompiledPoints, interface_of_one

    load, *others = numbers.values()
    sheet = sheet_of_one(numbers["roughness"], parameters)
    if _spent(sheet, parameters, rtol).points < LOOP_WORTH + CALL_WORTH:
        return None
    interface = interface_of_one(*others, parameters, rtol)
    found = CompiledPoints(interface, np.array([load]), not OF_AREAS.isdisjoint(variables))
    if found.left[0]:
        return None
    return {name: np.array(getattr(found, name)) for name in variables}


def _repaid(groups, parameters, rtol):
    """Which ``groups`` the loop, once it is loaded, solves in less time than the other ways.

    Its tables of a sheet are made as soon as solving there, in this call and all before, has cost as
    much as they do: so no sequence of calls takes more than about twice the time that it has to.
    """
    worth = [LOOP_WORTH * group.sheet.terms(rtol) for group in groups]
    spent = [_spent(group.sheet, parameters, rtol) for group in groups]
    for each, group in zip(spent, groups, strict=True):
        each.points += group.size + CALL_WORTH / len(groups)
    repaid = [each.points >= own + CALL_WORTH for each, own in zip(spent, worth, strict=True)]
    few = [group.size for group in compress(groups, repaid) if group.size < GROUP_WORTH]
    if GROUP_WORTH * len(few) > CALL_WORTH + sum(few):  # by quadrature they are solved together
        return [
            by_loop and group.size >= GROUP_WORTH
            for by_loop, group in zip(repaid, groups, strict=True)
        ]
    return repaid


def _loading_repaid(groups):
    """Whether the loop, which is not loaded, is worth loading for ``groups`` that repay its tables.

    It is once their points are many, or once solving such groups in all calls before has cost as much
    as it takes to load a loop that is kept.
    """
    if not groups:
        return False
    spent = _spent_unloaded()
    repaid = QUADRATURE_WORTH * spent.points >= LOADING_WORTH and _loop_pays(LOADING_WORTH)
    spent.points += CALL_WORTH
    for group in groups:
        spent.points += min(group.size, TABLE_WORTH + group.size / QUADRATURE_WORTH)
    return repaid or _loop_pays(sum(group.size for group in groups))


@dataclass
class _Spent:
    """What solving on a sheet would have cost without the loop, in points by quadrature."""

    points: float = 0.0


@lru_cache(maxsize=256)
def _spent(sheet, parameters, rtol):
    return _Spent()


@lru_cache
def _spent_unloaded():
    """What solving groups that repay the tables of the loop has cost while it is not loaded."""
    return _Spent()


def _tables_pay(points, rtol):
    """Whether so many ``points`` on one roughness are worth a table that is good for ``rtol``;
    tables cost in proportion to their samples."""
    sizes = TABLE_SIZES[-1][1:], table_size(rtol)
    finest, table = (pieces * degree for pieces, degree, _ in sizes)
    return points * finest >= TABLE_WORTH * table


def _loop_pays(points):
    """Whether so many ``points`` in all are worth the wait until the loop is in this process."""
    if points < LOADING_WORTH or not availability.is_installed():
        return False
    return points >= COMPILING_WORTH or availability.is_kept()


def threads_worth(points: int) -> int:
    """How many threads solve so many points by the loop: no more than the process has processors, or
    than ``OMP_NUM_THREADS`` allows, as for other libraries."""
    if points < THREADS_WORTH:
        return 1
    given = os.environ.get("OMP_NUM_THREADS", "")
    if given.isdecimal() and int(given) > 0:
        return int(given)
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class _Turns:
    """Turns of threads at all but machine code: only one has the interpreter at a time, and to hand it
    over at every operation on small arrays would take as long as the operations."""

    def __init__(self):
        self._turn = Lock()

    def __enter__(self):
        self._turn.acquire()

    def __exit__(self, *_):
        self._turn.release()

    @contextmanager
    def given_up(self):
        """Context in which it is the others' turn."""
        self._turn.release()
        try:
            yield
        finally:
            self._turn.acquire()


@dataclass(frozen=True)
class _Task:
    """What is asked of points, and the arrays of their solution.

    Each method solves the points at ``places``, indices or a slice, in one way, stores them and
    returns the places of those that it leaves, which mean nothing until another way has stored them.
    """

    conditions: Conditions
    parameters: Parameters
    rtol: float
    shared: bool  # whether surfaces share tables
    may_be_single: bool  # whether the loop begins in single precision where that has the digits
    result: dict[str, NDArray]
    settled: Callable[[int], None] | None
    # separations of points that the loop leaves, by their places
    near: dict[int, float] = field(default_factory=dict)

    def solve_by_loop(self, groups: list[Group]) -> list[Group]:
        """As the other methods, but for groups, because the points of a call share a sheet."""
        if not groups:
            return []
        from thirdbody.solver.compiled.points import CompiledPoints, Interfaces
        from thirdbody.solver.compiled.tables import precisions

        areas = not OF_AREAS.isdisjoint(self.result)
        reals = precisions(self.rtol)[0 if self.may_be_single else -1 :]
        threads = threads_worth(sum(group.size for group in groups))
        turns, apart = NO_TURNS, nullcontext
        if threads > 1:
            turns = _Turns()
            apart = turns.given_up

        def solved(sheet, real, places):
            some = self.conditions.take(places)
            interfaces = Interfaces(sheet, some, self.parameters, self.rtol, real)
            found = CompiledPoints(interfaces, some.load, areas, apart)
            if found.left.any():  # who solves these begins there
                separations = np.atleast_1d(found.separation)[found.left]
                left = _chosen(places, found.left)
                self.near.update(zip(left.tolist(), separations.tolist(), strict=True))
            return found

        def left_of(group):
            places = group.places
            for real in reals:
                places = self._settle(
                    places, CHUNK, partial(solved, group.sheet, real), threads, turns
                )
            return places

        return [
            replace(group, places=places)
            for group, places in zip(groups, map(left_of, groups), strict=True)
            if places.size
        ]

    def solve_by_tables(self, places):
        """Points of one kind, by tables of their surfaces."""
        return self._settle(places, CHUNK, partial(self._solved, self.rtol))

    def solve_by_quadrature(self, places):
        """Points of one kind, by quadrature."""
        return self._settle(places, QUADRATURE_CHUNK, partial(self._solved, None))

    def _solved(self, table_rtol, places):
        some = self.conditions.take(places)
        points = some.points(self.parameters, table_rtol, self.shared)
        if table_rtol is None and self.near:
            indices = range(places.start, places.stop) if isinstance(places, slice) else places
            near = np.array([self.near.get(int(each), np.nan) for each in indices])
            points = replace(points, near=near)
        return SolvedPoints(points, self.rtol)

    def _settle(self, places, size, solved, threads=1, turns=NO_TURNS):
        """Solve points in pieces of ``size`` at most by ``solved(places)``, each by itself; threads take
        ``turns`` at it."""
        pieces = list(_pieces(places, size, threads))
        threads = min(threads, len(pieces))
        if threads > 1:
            left = self._left_by_threads(pieces, solved, threads, turns)
        else:
            with turns:
                left = [self._left_of(piece, solved) for piece in pieces]
        return left[0] if len(left) == 1 else np.concatenate([NONE, *left])

    def _left_by_threads(self, pieces, solved, threads, turns):
        """What ``_left_of`` each of ``pieces``, which ``threads``, this one among them, solve by
        ``turns``."""
        left, todo = [None] * len(pieces), deque(enumerate(pieces))

        def settle_pieces():
            with np.errstate(all="ignore"), turns:  # errors are those of a thread
                while todo:
                    number, piece = todo.popleft()
                    left[number] = self._left_of(piece, solved)

        with ThreadPoolExecutor(threads - 1) as pool:
            working = [pool.submit(settle_pieces) for _ in range(threads - 1)]
            try:
                settle_pieces()
                for each in working:
                    each.result()
            finally:
                todo.clear()  # so that all end where one was interrupted
        return left

    def _left_of(self, piece, solved):
        """Solve the points of a ``piece`` and store them; who solves those that are left stores them
        again, which takes less time than to pick out the others."""
        found = solved(piece)
        left = _chosen(piece, found.left)
        if left.size < found.left.size:
            for name, values in self.result.items():
                values[piece] = getattr(found, name)
        if self.settled is not None:
            self.settled(found.left.size - left.size)
        return left


def _pieces(places, size, threads=1):
    """Pieces of ``size`` at most of a slice or of an array of indices; as large and as many for each of
    several ``threads``, so that none waits for another at the end."""
    start, stop = (places.start, places.stop) if isinstance(places, slice) else (0, places.size)
    if stop - start > size and threads > 1:
        rounds = -(-(stop - start) // (size * threads))
        size = -(-(stop - start) // (rounds * threads))
    for first in range(start, stop, size):
        piece = slice(first, min(first + size, stop))
        yield piece if isinstance(places, slice) else places[piece]


def _chosen(piece, mask):
    """Indices of the points of a piece, a slice or an array of indices, that a mask chooses."""
    (chosen,) = mask.nonzero()
    return chosen + piece.start if isinstance(piece, slice) else piece[chosen]
