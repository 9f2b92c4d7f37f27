"""Bracketed root finding without derivatives, vectorized over points.

``scipy.optimize.elementwise.find_root`` has the same method, but a single tolerance for all points.
It also leaves out solved points, so that functions would need the indices of the other points.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

MAX_ITERATIONS = 100
SPACING = 4.0 * np.finfo(float).eps  # relative spacing of floats: width of the narrowest bracket


def bracketed_roots(
    function: Callable[[NDArray], NDArray], low: NDArray, high: NDArray, tolerance: NDArray | float
) -> tuple[NDArray, NDArray]:
    """Find where a function changes sign between two bounds, element by element.

    ``function`` maps a 1-D array to one of its shape, and is positive at exactly one of ``low`` and
    ``high``.  Returns the end of the last bracket with the smaller absolute value, and the width of
    the bracket, at most ``tolerance`` if float64 allows it.

    Chandrupatla (1997), Adv. Eng. Software 28:145.
    """
    newest, other, last = low, high, high
    f_newest, f_other = function(low), function(high)
    f_last = f_other
    for _ in range(MAX_ITERATIONS):
        best = np.where(np.abs(f_newest) < np.abs(f_other), newest, other)
        exact = (f_newest == 0.0) | (f_other == 0.0)
        width = np.where(exact, 0.0, np.abs(other - newest))
        limit = np.maximum(tolerance, SPACING * np.abs(best))
        done = width <= limit
        if done.all():
            break
        with np.errstate(all="ignore"):  # a division by zero leads to bisection
            fraction = _interpolated(newest, other, last, f_newest, f_other, f_last)
            least = np.minimum(0.5 * limit / width, 0.5)
        fraction = np.where(np.isfinite(fraction), np.clip(fraction, least, 1.0 - least), 0.5)
        trial = np.where(done, best, newest + fraction * (other - newest))
        value = function(trial)
        same = (value > 0.0) == (f_newest > 0.0)
        last, f_last = np.where(same, newest, other), np.where(same, f_newest, f_other)
        other, f_other = np.where(same, other, newest), np.where(same, f_other, f_newest)
        newest, f_newest = trial, value
    return best, width


def _interpolated(newest, other, last, f_newest, f_other, f_last):
    """The root by inverse quadratic interpolation, as a fraction of the way from ``newest`` to
    ``other``; nan where the three points make it unreliable."""
    step, level = (newest - other) / (last - other), (f_newest - f_other) / (f_last - f_other)
    reliable = (level**2 < step) & ((1.0 - level) ** 2 < 1.0 - step)
    fraction = f_newest / (f_other - f_newest) * f_last / (f_other - f_last)
    fraction = fraction + (last - newest) / (other - newest) * f_newest / (f_last - f_newest) * (
        f_other / (f_last - f_other)
    )
    return np.where(reliable, fraction, np.nan)
