"""Bracketed root finding without derivatives, vectorized over points."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.optimize.elementwise import find_root

SPACING = 4.0 * np.finfo(float).eps  # relative spacing of floats: width of the narrowest bracket


def bracketed_roots(
    function: Callable[[NDArray], NDArray],
    low: NDArray,
    high: NDArray,
    atol: float = 0.0,
    rtol: float = SPACING,
) -> tuple[NDArray, NDArray]:
    """Find where a function of all points changes sign between two bounds, point by point: the roots, to
    ``atol`` or ``rtol`` of them, and the widths of their brackets; ``low`` and 0 where the bounds are equal."""
    values = np.array(low, float)

    def at(some_values, some):
        values[some] = some_values
        return function(values)[some]

    tolerances = {"xatol": atol, "xrtol": rtol, "fatol": 0.0, "frtol": 0.0}
    found = find_root(at, (low, high), args=(np.arange(low.size),), tolerances=tolerances)
    left, right = found.bracket
    is_exact = (found.f_x == 0.0) | (low == high)
    return np.where(low == high, low, found.x), np.where(is_exact, 0.0, np.abs(right - left))
