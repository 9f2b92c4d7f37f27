"""Whether what the paper finds comes out here: the findings of ``config/findings.yaml``, each with
the verdicts on the statements that test it."""

from collections.abc import Iterable, Mapping, Sequence
from math import nan
from typing import Any

from chenhorng.claims.limits import IMPOSSIBLE
from chenhorng.claims.words import FAILS, counted_once

REPRODUCED, IN_PART, NOT = "reproduced", "reproduced in part", "not reproduced"
MARKS = {REPRODUCED: "✓", IN_PART: "½", NOT: "✗"}
LEAST = 0.5  # of the statements hold, if the finding is reproduced in part
RULE = (
    "A finding is reproduced if all statements that test it hold, in part if at least half do, "
    "otherwise not."
)


def judged_findings(
    findings: Iterable[Mapping[str, Any]],
    statements: Sequence[Mapping[str, Any]],
    move: float = 0.0,
) -> list[dict[str, Any]]:
    """The ``findings`` with what the ``statements`` of ``claims.json`` say of them.

    Each has ``held`` and ``judged``, numbers of statements, where repeated ones count once;
    ``predicted``, how many hold with inputs that were found without their figures; the ``outcome``
    by ``RULE`` and its ``mark``; ``failed``, the statements that fail; and its
    ``numbers`` as a text, each changed by the fraction ``move``.  ``ValueError`` for a name that no
    statement has.
    """
    by_id = {row["id"]: _moved(row, move) for row in statements}
    by_name: dict[str, list[Mapping]] = {}
    for row in statements:
        by_name.setdefault(row["cluster"] or row["id"], []).append(row)
    found = []
    for finding in findings:
        if unknown := [name for name in finding["tested_by"] if name not in by_name]:
            raise ValueError(f"{', '.join(unknown)}: no statement has this name")
        rows = [(name, row) for name in finding["tested_by"] for row in by_name[name]]
        held, judged = counted_once((name, row["verdict"]) for name, row in rows)
        word = outcome(held, judged)
        found.append(
            {
                **finding,
                "held": held,
                "judged": judged,
                "predicted": counted_once((name, row["predicted"]) for name, row in rows)[0],
                "outcome": word,
                "mark": MARKS[word],
                "failed": [row for _, row in rows if row["verdict"] == FAILS],
                "numbers": finding["numbers"].format_map(by_id),
            }
        )
    return found


def worth_of_inputs(
    departures: Iterable[Mapping[str, Any]], limits: Iterable[Mapping[str, Any]]
) -> dict[str, Any]:
    """What rows of the tables ``departures`` and ``limits`` say of the inputs: the row ``worded``,
    in which they are as the text words them, None without one; and the ``impossible`` ones."""
    worded = (row for row in departures if row["departure"].startswith("baseline: "))
    return {
        "worded": next(worded, None),
        "impossible": [
            f"{row['quantity']} = {row['value']:.3g} ({row['condition']})"
            for row in limits
            if row["verdict"] == IMPOSSIBLE
        ],
    }


def in_no_finding(
    findings: Iterable[Mapping[str, Any]], statements: Iterable[Mapping[str, Any]]
) -> tuple[int, int]:
    """Numbers of statements that test none of the ``findings``: of those that hold, and of all."""
    names = {name for finding in findings for name in finding["tested_by"]}
    rows = ((row["cluster"] or row["id"], row["verdict"]) for row in statements)
    return counted_once(row for row in rows if row[0] not in names)


def outcome(held: int, judged: int) -> str:
    """The word for a finding with so many of its statements that hold, by ``RULE``."""
    if held == judged > 0:
        return REPRODUCED
    return IN_PART if held >= LEAST * max(judged, 1) else NOT


def _moved(row, move):
    numbers = [nan if number is None else number * (1.0 + move) for number in row["numbers"]]
    return {**row, "numbers": numbers or [nan, nan]}  # of one that is not tested
