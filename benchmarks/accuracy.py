"""True errors and times of the library and of a plain solver, for each ``rtol`` and class of
points.

Methods are ``library`` (``thirdbody.solve``), ``library_grid`` (``thirdbody.grid``) and
``nested_roots`` (``NestedRoots`` of ``baselines``).
"""

import math
import warnings
from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np

import thirdbody as tb
from benchmarks.baselines import NestedRoots
from benchmarks.classes import (
    CLASSES,
    MICROSECONDS,
    TIMED,
    PointClass,
    grid_axes,
    least_seconds,
    random_conditions,
)
from benchmarks.points import CLASS, VARIABLES, grouped, relative_error

# a grid is solved on a curve over the load: these multiples of the load of a golden point
CURVE = np.geomspace(0.1, 10.0, 40)


def error_rows(
    rows: Iterable[dict[str, str]], rtols: Sequence[float], plain: ModuleType
) -> list[dict[str, Any]]:
    """Errors of every variable at golden ``rows``, for each of ``rtols``: rows of the table
    ``errors``.
    """
    groups = grouped(rows)
    table = []
    for rtol in rtols:
        for method, solve in (("library", _library), ("library_grid", _library_grid)):
            table += _error_rows_of(method, rtol, groups, partial(solve, rtol=rtol))

    def solve_plainly(group):
        with _quiet():
            return NestedRoots(plain, group.parameters).solve(**group.conditions)

    return table + _error_rows_of("nested_roots", None, groups, solve_plainly)


def _library(group, rtol):
    with _quiet():
        found = tb.solve(**group.conditions, parameters=group.parameters, rtol=rtol)
    return _claimed(found, rtol)


def _library_grid(group, rtol):
    """Solve each point in the middle of a curve over the load."""
    found = []
    for place in range(len(group.rows)):
        axes = {name: values[place : place + 1] for name, values in group.conditions.items()}
        axes["load"] = np.unique(np.append(axes["load"], axes["load"] * CURVE))
        index = np.searchsorted(axes["load"], group.conditions["load"][place])
        with _quiet():
            data = tb.grid(**axes, parameters=group.parameters, rtol=rtol, progress=False)
        found.append([data[name].values.ravel()[index] for name in (*VARIABLES, "error_bound")])
    values = dict(zip((*VARIABLES, "error_bound"), np.transpose(found), strict=True))
    return _claimed(SimpleNamespace(**values), rtol)


def _claimed(solution, rtol):
    """The variables, nan where the library itself says that a point misses ``rtol``."""
    good = solution.error_bound <= rtol
    kept = {name: np.where(good, getattr(solution, name), np.nan) for name in VARIABLES}
    return SimpleNamespace(**kept)


def _quiet():
    """Silence two warnings: of unusual conditions, and of rounding that limits quad."""
    return warnings.catch_warnings(action="ignore")


def _error_rows_of(method, rtol, groups, solve):
    """Rows of one method and ``rtol``."""
    found = {kind: [] for kind in CLASSES}
    for group in groups:
        solution = solve(group)
        errors = [relative_error(getattr(solution, v), group.expected[v]) for v in VARIABLES]
        found[PointClass(*(group.rows[0][name] for name in CLASS))].append(errors)
    return [
        {"method": method, "rtol": rtol, **kind._asdict(), "variable": name, **_summary(each, rtol)}
        for kind, parts in found.items()
        if parts
        for name, each in zip(VARIABLES, np.concatenate(parts, axis=1), strict=True)
    ]


def _summary(errors, rtol):
    """Counts of points and measures of their errors."""
    solved = errors[np.isfinite(errors)]
    return {
        "points": errors.size,
        "unsolved": errors.size - solved.size,
        "beyond_rtol": None if rtol is None else int(np.count_nonzero(solved > rtol)),
        "largest_error": float(solved.max(initial=0.0)),
        "percentile_99_error": float(np.percentile(solved, 99.0)) if solved.size else 0.0,
    }


def time_rows(
    parameters: tb.Parameters, budget: Mapping[str, Any], plain: ModuleType
) -> list[dict[str, Any]]:
    """Processor time of a point, as ``config/accuracy.yaml`` asks for it: rows of the table
    ``times``.
    """
    return [row for kind in TIMED for row in _time_rows_of(kind, parameters, budget, plain)]


def _time_rows_of(kind, parameters, budget, plain):
    sizes = budget["points"][kind.span]
    axes = grid_axes(kind, budget["grid"][kind.span], parameters)
    points = sizes | {"library_grid": math.prod(axis.size for axis in axes.values())}
    drawn = {method: random_conditions(kind, count, parameters) for method, count in sizes.items()}
    runs = {}
    for rtol in budget["rtol"]:
        asked = {"parameters": parameters, "rtol": rtol, "progress": False}
        runs["library", rtol] = partial(tb.solve, **drawn["library"], **asked)
        runs["library_grid", rtol] = partial(tb.grid, **axes, **asked)
    solver = NestedRoots(plain, parameters)
    runs["nested_roots", None] = partial(solver.solve, **drawn["nested_roots"])
    with _quiet():
        seconds = least_seconds(runs, budget["rounds"])
    for (method, rtol), time in seconds.items():
        count = points[method]
        cost = {"points": count, "microseconds_per_point": MICROSECONDS * time / count}
        yield {"method": method, "rtol": rtol, **kind._asdict(), **cost}
