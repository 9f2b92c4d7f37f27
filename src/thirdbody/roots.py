"""Roots of many decreasing functions at once: Newton's method held by a bracket."""

from __future__ import annotations

import numpy as np

MAX_ITERATIONS = 200


def decreasing_roots(residual, guess, lower, upper, tolerance, points):
    """Elementwise root of a decreasing ``residual`` between ``lower`` and ``upper``.

    ``residual(x, points)`` returns (value, slope) for a 1-D array x and the points it belongs
    to; ``points`` has ``take(chosen)``.  ``guess``, ``lower`` and ``upper`` have one shape, the
    bounds may be infinite.  An element is finished once its step, and what the residual changes
    over it, are below ``tolerance``; finished elements drop out.  Returns the roots, nan where
    the residual has none in float64.
    """
    roots = np.full_like(guess, np.nan)
    active = np.arange(guess.size)
    x, low, high = guess, lower, upper
    last = np.full_like(guess, np.inf)
    for _ in range(MAX_ITERATIONS):
        value, slope = residual(x, points)
        low, high = np.where(value > 0.0, x, low), np.where(value > 0.0, high, x)
        new = _held(x - value / slope, low, high, last, x)
        step = np.abs(new - x)
        finished = ~(step * np.maximum(np.abs(slope), 1.0) > tolerance)
        roots[active[finished]] = new[finished]
        left = np.flatnonzero(~finished)
        if not left.size:
            break
        if left.size < active.size:
            points = points.take(left)
        active, x, low, high, last = (a[left] for a in (active, new, low, high, step))
    return roots


def _held(new, low, high, last, x):
    """Newton's point, or the middle of the bracket where that leaves it or closes in too slowly."""
    middle = 0.5 * (low + high)
    slow = (np.abs(new - x) > 0.5 * last) & np.isfinite(middle)
    return np.where(slow | (new < low) | (new > high), middle, new)
