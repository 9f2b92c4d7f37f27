"""Axes that a configuration describes by their ends and the number of their values."""

from __future__ import annotations

import math
from collections.abc import Mapping


def axis_values(axis: Mapping) -> list[float]:
    """The values [unit of its key] of an axis of ``config/atlas.yaml``, increasing, with twelve digits.

    Examples
    --------
    >>> axis_values({"from": 1, "to": 100, "count": 3, "scale": "logarithmic", "also": [0, 50]})
    [0.0, 1.0, 10.0, 50.0, 100.0]
    """
    first, last = float(axis["from"]), float(axis["to"])
    places = [step / (axis["count"] - 1) for step in range(axis["count"])]
    if axis["scale"] == "logarithmic":
        spaced = [first * math.exp(place * math.log(last / first)) for place in places]
    else:
        spaced = [first + place * (last - first) for place in places]
    return sorted({float(f"{value:.12g}") for value in (*spaced, *axis["also"])})
