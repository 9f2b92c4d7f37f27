"""The numbers that the paper prints, as rows of a table: what figures and tables set beside theirs."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

import numpy as np

from thirdbody.data.conditions import Condition
from thirdbody.data.places import part_of_paper
from thirdbody.study.claims import BETWEEN_CURVES, CURVE_QUANTITIES, REVERSAL_LOAD, Claim

NUMBER = re.compile(r"Figure (\d+)")
ENDS = ("low", "high")


def printed_rows(claims: Iterable[Claim]) -> list[dict]:
    """Rows of the table ``printed``: a number with its tolerance for each curve it is printed for.

    Parameters
    ----------
    claims : iterable of Claim
        Statements of the paper; those without a printed number have no row.
    """
    return [
        row
        for claim in claims
        if claim.kind in ("value", "span", "window") and not _is_a_change(claim)
        for row in _rows(claim)
    ]


def _is_a_change(claim) -> bool:
    """Whether the number is a change from a reference, which is no place on a figure."""
    return bool(claim.reference) and claim.quantity not in BETWEEN_CURVES


def _rows(claim):
    number = NUMBER.match(part_of_paper(claim.place))
    level = next(((q, v) for q, v in claim.conditions.items() if q in CURVE_QUANTITIES), ("", None))
    common = {
        "id": claim.id,
        "figure": f"fig{int(number[1]):02d}" if number else "",
        "at_quantity": level[0],
        "at_level": level[1],
    } | {name: claim.conditions.get(name) for name in ("load_max", "load_max_N")}
    for condition in _curves(claim):
        known = {n: None if np.isnan(v) else v for n, v in condition.columns.items()}
        for extreme, quantity, value in _numbers(claim):
            margin = abs(value) * claim.tolerance if claim.relative else claim.tolerance
            ends = {"value": value, "low": value - margin, "high": value + margin}
            yield common | known | {"quantity": quantity, "extreme": extreme} | ends


def _curves(claim) -> Sequence[Condition]:
    """The curves that a number is printed for; the middle one of those whose order reverses."""
    if claim.quantity == REVERSAL_LOAD:
        return claim.curves[len(claim.curves) // 2 :][:1]
    return claim.curves


def _numbers(claim):
    """Extreme, quantity and value of each number of ``claim``."""
    if claim.kind == "window":
        return [("", f"window_{end}", x) for end, x in zip(ENDS, claim.published, strict=True)]
    if claim.kind == "span":
        extremes = zip(("minimum", "maximum"), claim.published, strict=True)
        return [(extreme, claim.quantity, value) for extreme, value in extremes]
    return [(claim.extreme, claim.quantity, claim.published)]
