"""The verdict on points at extremes: right, refused with a reason, or wrong."""

import warnings
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

import thirdbody as tb
from benchmarks.points import VARIABLES, Group, grouped, parameters_on_one_surface, relative_error
from thirdbody.core.regimes import WITHOUT_VALUES


def judge_extremes(rows: Sequence[dict[str, str]], rtol: float) -> list[dict[str, Any]]:
    """Rows of the table ``extremes`` for rows of ``tests/golden/extremes.csv``, in their order.

    Points of one surface are solved together; a warning or an exception makes all of them wrong.
    """
    verdicts, accepted = {}, []
    for row in rows:
        try:
            parameters_on_one_surface(row, float(row["roughness"]))
            accepted.append(row)
        except ValueError as error:
            verdicts[id(row)] = "none", 0.0, "", f"refused: {error}"
    for group in grouped(accepted):
        keys = map(id, group.rows)
        verdicts |= zip(keys, _judge_group(group, rtol), strict=True)
    names = "status", "largest_error", "variable", "verdict"
    return [
        {name: row[name] for name in ("item", "case", "origin")}
        | {"rtol": rtol, "expected_status": row["status"]}
        | dict(zip(names, verdicts[id(row)], strict=True))
        for row in rows
    ]


def _judge_group(group: Group, rtol: float) -> Iterator[tuple[str, float, str, str]]:
    """Status, largest error, its variable and the verdict of each point."""
    with warnings.catch_warnings(action="error"):
        warnings.simplefilter("ignore", tb.OutOfRangeWarning)
        try:
            found = tb.solve(**group.conditions, parameters=group.parameters, rtol=rtol)
        except (ArithmeticError, ValueError, Warning) as error:
            text = f"wrong: {type(error).__name__}: {error}"
            yield from [("none", np.inf, "", text)] * len(group.rows)
            return
    errors = {v: relative_error(getattr(found, v), group.expected[v]) for v in VARIABLES}
    for index, row in enumerate(group.rows):
        status = str(found.solution_status[index])
        worst = max(VARIABLES, key=lambda name: errors[name][index])
        error = float(errors[worst][index])
        if row["status"] in WITHOUT_VALUES:
            error, worst = 0.0, ""
        bound = float(found.error_bound[index])
        yield status, error, worst, verdict(row, status, error, bound, rtol)


def verdict(row: Mapping[str, str], status: str, error: float, bound: float, rtol: float) -> str:
    """``right``, ``refused: ...`` or ``wrong``.

    A point is refused if the library says, and rightly, that its error is above ``rtol``.
    """
    if status == row["status"] and error <= rtol:
        return "right"
    if status == "not_converged" and error <= bound and bound > rtol:
        return f"refused: the error is below {bound:.1e} only"
    return "wrong"
