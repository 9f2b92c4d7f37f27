"""The errors that the library and the baselines make at points known in multiple precision."""

from __future__ import annotations

import warnings
from functools import partial
from types import SimpleNamespace

import numpy as np

from benchmarks.baselines import ElementwiseRoots, NestedRoots
from benchmarks.classes import CLASSES, PointClass
from benchmarks.library import solutions
from benchmarks.points import CLASS, VARIABLES, grouped, relative_errors


def error_rows(rows, rtols, plain) -> list[dict]:
    """Rows of the table ``errors``: largest and 99th-percentile error of each variable, method,
    ``rtol`` and class at the golden ``rows``; ``plain`` is the module of plain equations.

    Of the library's errors, which differ from way to way, the largest counts.
    """
    groups = [kind for group in grouped(rows) for kind in _of_one_kind(group)]
    table = []
    for rtol in rtols:
        table += _rows_of("library", rtol, groups, partial(_library, rtol=rtol))
        table += _rows_of("elementwise_roots", rtol, groups, partial(_elementwise, rtol=rtol))
    return table + _rows_of("nested_roots", None, groups, partial(_nested, plain=plain))


def _of_one_kind(group):
    """Pairs of a class and the part of ``group`` that belongs to it."""
    kinds = [PointClass(*(row[name] for name in CLASS)) for row in group.rows]
    for kind in dict.fromkeys(kinds):
        yield kind, group.take([index for index, other in enumerate(kinds) if other == kind])


def _library(group, rtol):
    """Solutions without the points of which the library says that they miss ``rtol``."""
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
        warnings.simplefilter("ignore")  # quad's, where 1e-11 is more than rounding allows
        return [NestedRoots(plain, group.parameters).solve(**group.conditions)]


def _rows_of(method, rtol, groups, solutions_of):
    """Rows of one method and tolerance; ``solutions_of`` a group are one or several."""
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
    """Number of points, of those without a solution to ``rtol`` by the method's own word, of those
    beyond it nevertheless, and errors of the solved."""
    solved = errors[np.isfinite(errors)]
    return {
        "points": errors.size,
        "unsolved": errors.size - solved.size,
        "beyond_rtol": None if rtol is None else int(np.count_nonzero(solved > rtol)),
        "largest_error": float(solved.max(initial=0.0)),
        "percentile_99_error": float(np.percentile(solved, 99.0)) if solved.size else 0.0,
    }
