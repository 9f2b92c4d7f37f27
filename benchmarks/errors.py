"""Errors of the library and of the baselines at points known in multiple precision."""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Sequence
from functools import partial
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np

from benchmarks.baselines import ElementwiseRoots, NestedRoots
from benchmarks.classes import CLASSES, PointClass
from benchmarks.library import solutions
from benchmarks.points import CLASS, VARIABLES, grouped, relative_errors


def error_rows(
    rows: Iterable[dict[str, str]], rtols: Sequence[float], plain: ModuleType
) -> list[dict[str, Any]]:
    """Measure the errors of every variable, by method, relative error asked for, and class.

    The library solves each point by all of its ways, and the way with the largest error counts.

    Parameters
    ----------
    rows : iterable of dict
        Golden points, as ``benchmarks.points.read_rows`` returns them.
    rtols : sequence of float
        Relative errors to ask for [1].
    plain : module
        The plain equations, as ``benchmarks.baselines.load_plain_model`` returns them.

    Returns
    -------
    list of dict
        Rows of the table ``errors``.
    """
    groups = [kind for group in grouped(rows) for kind in _of_one_kind(group)]
    table = []
    for rtol in rtols:
        table += _rows_of("library", rtol, groups, partial(_library, rtol=rtol))
        table += _rows_of("elementwise_roots", rtol, groups, partial(_elementwise, rtol=rtol))
    return table + _rows_of("nested_roots", None, groups, partial(_nested, plain=plain))


def _of_one_kind(group):
    """Pairs of a class and the points of ``group`` that belong to it."""
    kinds = [PointClass(*(row[name] for name in CLASS)) for row in group.rows]
    for kind in dict.fromkeys(kinds):
        yield kind, group.take([index for index, other in enumerate(kinds) if other == kind])


def _library(group, rtol):
    """Solutions by all ways; nan where the library itself says that a point misses ``rtol``."""
    solved = []
    for each in solutions(group, rtol):
        claimed = each.error_bound <= rtol
        kept = {name: np.where(claimed, getattr(each, name), np.nan) for name in VARIABLES}
        solved.append(SimpleNamespace(**kept))
    return solved


def _elementwise(group, rtol):
    roughness = group.conditions["roughness"][0]
    return [ElementwiseRoots(group.parameters, roughness, rtol).solve(**group.conditions)]


def _nested(group, plain):
    with warnings.catch_warnings():
        # quad warns where rounding keeps it from the error of 1e-11 that it is asked for.
        warnings.simplefilter("ignore")
        return [NestedRoots(plain, group.parameters).solve(**group.conditions)]


def _rows_of(method, rtol, groups, solutions_of):
    """Rows of one method and ``rtol``; ``solutions_of(group)`` are one or several solutions."""
    found = {kind: [] for kind in CLASSES}
    for kind, group in groups:
        errors = [relative_errors(each, group.expected) for each in solutions_of(group)]
        found[kind].append(np.stack([np.max([e[name] for e in errors], 0) for name in VARIABLES]))
    return [
        {
            "method": method,
            "rtol": rtol,
            **kind._asdict(),
            "variable": name,
            **_summary(errors, rtol),
        }
        for kind, parts in found.items()
        if parts
        for name, errors in zip(VARIABLES, np.concatenate(parts, axis=1), strict=True)
    ]


def _summary(errors, rtol):
    """Counts of points and measures of their errors.

    ``unsolved`` are points for which the method says that it has no solution to ``rtol``;
    ``beyond_rtol`` are points that it takes for solved and whose error is larger.
    """
    solved = errors[np.isfinite(errors)]
    return {
        "points": errors.size,
        "unsolved": errors.size - solved.size,
        "beyond_rtol": None if rtol is None else int(np.count_nonzero(solved > rtol)),
        "largest_error": float(solved.max(initial=0.0)),
        "percentile_99_error": float(np.percentile(solved, 99.0)) if solved.size else 0.0,
    }
