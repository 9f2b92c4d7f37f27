"""Axes that a configuration describes by their ends and the number of their values."""

from __future__ import annotations

import math
from collections.abc import Mapping


def axis_values(axis: Mapping) -> list[float]:
    """The values of an axis, increasing and each once, with twelve digits.

    Parameters
    ----------
    axis : Mapping
        ``from``, ``to``, ``count``, ``scale`` (``linear`` or ``logarithmic``) and ``also``, as
        ``config/atlas.schema.yaml`` describes them.

    Examples
    --------
    >>> axis_values({"from": 1, "to": 100, "count": 3, "scale": "logarithmic", "also": [0, 50]})
    [0.0, 1.0, 10.0, 50.0, 100.0]
    """
    first, last = float(axis["from"]), float(axis["to"])
    shares = [step / (axis["count"] - 1) for step in range(axis["count"])]
    if axis["scale"] == "logarithmic":
        spaced = [first * math.exp(share * math.log(last / first)) for share in shares]
    else:
        spaced = [first + share * (last - first) for share in shares]
    return sorted({float(f"{value:.12g}") for value in (*spaced, *axis["also"])})
