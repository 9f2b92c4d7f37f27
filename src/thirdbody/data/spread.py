"""The range of a number over nine in ten members of an ensemble."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

ENDS = (0.05, 0.95)  # quantiles at the ends of the range


def spread(values: Iterable[float]) -> tuple[float, float] | None:
    """The range of nine in ten of ``values``; None if there are none."""
    known = [value for value in values if np.isfinite(value)]
    if not known:
        return None
    low, high = np.quantile(known, ENDS)
    return float(low), float(high)
