"""The verdict on points at extremes: right, refused with a reason, or wrong."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from benchmarks.library import solutions
from benchmarks.points import VARIABLES, grouped, parameters_of, relative_errors
from thirdbody.model.regimes import SOLUTION_STATUSES, WITHOUT_VALUES

VERDICTS = ("right", "refused", "wrong")
# Relative errors that rounding leaves in a load, through the logarithms of its parts, and in a
# separation.
LOAD_ROUNDING = 1e-14
GAP_ROUNDING = 2.3e-16


def judge_extremes(rows: Sequence[dict[str, str]], rtol: float) -> list[dict[str, Any]]:
    """Judge what the library gives at extremes.

    Points of one surface are solved together, by each way, and every way must be right.  A warning
    or an exception makes all of them wrong.

    Parameters
    ----------
    rows : sequence of dict
        Lines of ``tests/golden/extremes.csv``, as ``benchmarks.points.read_rows`` returns them.
    rtol : float
        Relative error asked for [1].

    Returns
    -------
    list of dict
        Rows of the table ``extremes``, in the order of ``rows``; of several ways the worst counts.
    """
    verdicts = {}
    accepted = []
    for row in rows:
        try:
            parameters_of(row)
            accepted.append(row)
        except ValueError as error:
            verdicts[id(row)] = _found(row, rtol, "none", 0.0, "", f"refused: {error}")
    for group in grouped(accepted):
        verdicts |= {id(row): found for row, found in _judge_group(group, rtol)}
    return [verdicts[id(row)] for row in rows]


def _judge_group(group, rtol):
    """Pairs of a row and its verdict."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            solved = solutions(group, rtol)
        except (ArithmeticError, ValueError, Warning) as error:
            text = f"wrong: {type(error).__name__}: {error}"
            return [(row, _found(row, rtol, "none", np.inf, "", text)) for row in group.rows]
    judged = [
        [_judge_point(row, index, each, errors, rtol) for index, row in enumerate(group.rows)]
        for each in solved
        for errors in [relative_errors(each, group.expected)]
    ]
    worst = [max(ways, key=_badness) for ways in zip(*judged, strict=True)]
    return zip(group.rows, worst, strict=True)


def _badness(found):
    """Sorts rows of the table from right to wrong, those of one verdict by their error."""
    return VERDICTS.index(found["verdict"].partition(":")[0]), found["largest_error"]


def _judge_point(row, index, solution, errors, rtol):
    """Row of the table for the point ``index`` of a group in one solution."""
    status = SOLUTION_STATUSES[solution.solution_status[index]]
    worst = max(VARIABLES, key=lambda name: errors[name][index])
    error = float(errors[worst][index])
    if row["status"] in WITHOUT_VALUES:
        error, worst = 0.0, ""
    bound = float(solution.error_bound[index])
    return _found(row, rtol, status, error, worst, verdict(row, status, error, bound, rtol))


def _found(row, rtol, status, error, worst, text):
    return {
        "item": row["item"],
        "case": row["case"],
        "origin": row["origin"],
        "rtol": rtol,
        "expected_status": row["status"],
        "status": status,
        "largest_error": error,
        "variable": worst,
        "verdict": text,
    }


def verdict(row: Mapping[str, str], status: str, error: float, bound: float, rtol: float) -> str:
    """Judge one point.

    Parameters
    ----------
    row : mapping
        Its line of ``extremes.csv``, of which the expected ``status`` is used.
    status : str
        Status that the library gives.
    error : float
        Largest relative error of all variables [1].
    bound : float
        Bound that the library gives for this error [1].
    rtol : float
        Relative error asked for [1].

    Returns
    -------
    str
        ``right``; ``refused: ...`` if the library says truly that its error is above ``rtol``; or
        ``wrong``.

    Examples
    --------
    >>> verdict({"status": "converged"}, "converged", error=1e-10, bound=1e-9, rtol=1e-9)
    'right'
    >>> verdict({"status": "converged"}, "not_converged", error=1e-8, bound=1e-7, rtol=1e-9)
    'refused: the error is below 1.0e-07 only'
    """
    if status == row["status"] and error <= rtol:
        return "right"
    if status == "not_converged" and error <= bound and bound > rtol:
        return f"refused: the error is below {bound:.1e} only"
    return "wrong"


def beyond_float64(row: Mapping[str, str], rtol: float) -> bool:
    """Whether a point cannot be solved to ``rtol`` [1] in float64, and is to be refused.

    So it is if rounding of the loads changes the separation, or rounding of the separation changes
    the loads and areas, by more than ``rtol``.  ``row`` is its line of ``extremes.csv``.
    """
    conditioning = float(row["gap_conditioning"] or 0.0)
    if conditioning == 0.0:
        return False
    return max(conditioning * LOAD_ROUNDING, GAP_ROUNDING / conditioning) > rtol
