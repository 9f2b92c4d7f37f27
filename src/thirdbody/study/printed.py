"""The numbers that the paper prints, as rows of a table: what figures and tables set beside theirs."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import product

import numpy as np

from thirdbody.data.places import FIGURE
from thirdbody.study.claims import BETWEEN_CURVES, CURVE_QUANTITIES, REVERSAL_LOAD, Claim


def printed_rows(claims: Iterable[Claim]) -> list[dict]:
    """Rows of the table ``printed``: a number with its tolerance for each curve it is printed for.

    A change from a reference has none, as it has no place on a figure.
    """
    rows = []
    for claim in claims:
        is_change = claim.reference and claim.quantity not in BETWEEN_CURVES
        if claim.kind not in ("value", "span", "window") or is_change:
            continue
        number = FIGURE.match(claim.place)
        levels = [(name, value) for name, value in claim.limits.items() if name in CURVE_QUANTITIES]
        at_quantity, at_level = levels[0] if levels else ("", None)
        curves = claim.curves
        if claim.quantity == REVERSAL_LOAD:  # one number: that of the middle curve
            curves = curves[len(curves) // 2 :][:1]
        for condition, (extreme, quantity, value) in product(curves, _numbers(claim)):
            margin = abs(value) * claim.tolerance if claim.relative else claim.tolerance
            known = {n: None if np.isnan(v) else v for n, v in condition.columns.items()}
            rows.append(
                {
                    "id": claim.id,
                    "figure": f"fig{int(number[1]):02d}" if number else "",
                    "at_quantity": at_quantity,
                    "at_level": at_level,
                    "load_max": claim.limits.get("load_max"),
                    "load_max_N": claim.limits.get("load_max_N"),
                    **known,
                    "quantity": quantity,
                    "extreme": extreme,
                    "value": value,
                    "low": value - margin,
                    "high": value + margin,
                }
            )
    return rows


def _numbers(claim):
    """Extreme, quantity and value of each number of a claim."""
    if claim.kind == "window":
        return zip(("", ""), ("window_low", "window_high"), claim.published, strict=True)
    if claim.kind == "span":
        return zip(("minimum", "maximum"), [claim.quantity] * 2, claim.published, strict=True)
    return [(claim.extreme, claim.quantity, claim.published)]
