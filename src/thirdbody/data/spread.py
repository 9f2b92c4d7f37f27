"""The range that stands beside a number: what nine in ten members of an ensemble give."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

ENDS = (0.05, 0.95)  # quantiles between which the range lies


def spread(values: Iterable[float]) -> tuple[float, float] | None:
    """Between which two numbers nine in ten of ``values`` lie, None where there are none."""
    known = [value for value in values if np.isfinite(value)]
    if not known:
        return None
    low, high = np.quantile(known, ENDS)
    return float(low), float(high)
