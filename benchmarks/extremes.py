"""The verdict on points at extremes: right, refused with a reason, or wrong."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

import thirdbody as tb
from benchmarks.points import VARIABLES, grouped, parameters_of, relative_error
from thirdbody.model.regimes import SOLUTION_STATUSES, WITHOUT_VALUES

LOAD_ROUNDING = (
    1e-14  # relative error that rounding leaves in a load, through logarithms of its parts
)
GAP_ROUNDING = 2.3e-16  # and in a separation


def judge_extremes(rows: Sequence[dict[str, str]], rtol: float) -> list[dict[str, Any]]:
    """Rows of the table ``extremes`` for lines of ``tests/golden/extremes.csv``, in their order.

    Points of one surface are solved together; a warning or an exception makes all of them wrong.
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
    with warnings.catch_warnings(action="error"):
        warnings.simplefilter("ignore", tb.OutOfRangeWarning)
        try:
            solution = tb.solve(**group.conditions, parameters=group.parameters, rtol=rtol)
        except (ArithmeticError, ValueError, Warning) as error:
            text = f"wrong: {type(error).__name__}: {error}"
            return [(row, _found(row, rtol, "none", np.inf, "", text)) for row in group.rows]
    errors = {
        name: relative_error(getattr(solution, name), group.expected[name]) for name in VARIABLES
    }
    return [
        (row, _judge_point(row, index, solution, errors, rtol))
        for index, row in enumerate(group.rows)
    ]


def _judge_point(row, index, solution, errors, rtol):
    """Row of the table for the point ``index`` of a solution."""
    status = SOLUTION_STATUSES[solution.solution_status[index]]
    worst = max(VARIABLES, key=lambda name: errors[name][index])
    error = float(errors[worst][index])
    if row["status"] in WITHOUT_VALUES:
        error, worst = 0.0, ""
    bound = float(solution.error_bound[index])
    return _found(row, rtol, status, error, worst, verdict(row, status, error, bound, rtol))


def _found(row, rtol, status, error, worst, text):
    found = {name: row[name] for name in ("item", "case", "origin")}
    found |= {"rtol": rtol, "expected_status": row["status"], "status": status}
    return found | {"largest_error": error, "variable": worst, "verdict": text}


def verdict(row: Mapping[str, str], status: str, error: float, bound: float, rtol: float) -> str:
    """``right``; ``refused: ...`` if the library truly says that its error is above ``rtol``; or ``wrong``.

    Of the ``row`` of ``extremes.csv`` the expected ``status`` is used.

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
    """Whether float64 cannot hold a point to ``rtol``: rounding changes its separation or its loads by more."""
    conditioning = float(row["gap_conditioning"] or 0.0)
    if conditioning == 0.0:
        return False
    return max(conditioning * LOAD_ROUNDING, GAP_ROUNDING / conditioning) > rtol
