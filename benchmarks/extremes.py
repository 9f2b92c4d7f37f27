"""The verdict on each extreme: the right number, a status that says why not, or wrong."""

from __future__ import annotations

import warnings

import numpy as np

from benchmarks.library import solutions
from benchmarks.points import VARIABLES, grouped, parameters_of, relative_errors
from thirdbody.model.regimes import SOLUTION_STATUSES

VERDICTS = ("right", "refused", "wrong")
UNSOLVED = ("coverage_exceeded", "not_converged")
# relative errors that rounding leaves in a load of summits and particles, a few of each logarithm,
# and in a separation
LOAD_ROUNDING = 1e-14
GAP_ROUNDING = 2.3e-16


def judge_extremes(rows, rtol) -> list[dict]:
    """Verdict on each of ``rows``, the lines of ``extremes.csv``, solved with ``rtol``, in order.

    Points of one surface are solved together and none may harm another; what each way gives must be
    right.  A warning or an exception makes all of them wrong.
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
    """The less right a verdict, the larger; of equals, the larger error."""
    return VERDICTS.index(found["verdict"].partition(":")[0]), found["largest_error"]


def _judge_point(row, index, solution, errors, rtol):
    """Verdict on the point ``index`` of a group."""
    status = SOLUTION_STATUSES[solution.solution_status[index]]
    worst = max(VARIABLES, key=lambda name: errors[name][index])
    error = float(errors[worst][index])
    if row["status"] in UNSOLVED:
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


def verdict(row, status, error, bound, rtol) -> str:
    """``right``, ``refused: why`` or ``wrong`` for a ``status``, the largest relative ``error`` and
    the ``bound`` that the library gives for it."""
    if status == row["status"] and error <= rtol:
        return "right"
    if status == "not_converged" and error <= bound and bound > rtol:
        return f"refused: the error is below {bound:.1e} only"
    return "wrong"


def beyond_float64(row, rtol) -> bool:
    """Whether rounding of the loads moves the gap, or rounding of the gap the loads and areas, by
    more than ``rtol``: such a point is to be refused."""
    conditioning = float(row["gap_conditioning"] or 0.0)
    if conditioning == 0.0:
        return False
    return max(conditioning * LOAD_ROUNDING, GAP_ROUNDING / conditioning) > rtol
