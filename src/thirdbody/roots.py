"""Roots of many decreasing functions at once: Newton's method held by a bracket."""

from __future__ import annotations

import numpy as np

MAX_ITERATIONS = 200
RESIDUAL_SLACK = 100.0  # a residual above this times the tolerance jumps over zero
ROUNDING = 1e-9  # what rounding may leave of a residual of large logarithms


def decreasing_roots(residual, guess, lower, upper, tolerance, points):
    """Elementwise root of a decreasing ``residual`` between ``lower`` and ``upper``.

    ``residual(x, points)`` returns (value, slope) for a 1-D array x and the points it belongs
    to; ``points`` has ``take(chosen)``; a nan value counts as one beyond the root.  ``guess`` and
    the finite bounds have one shape.  An element is finished once its step, and what the residual
    changes over it, are below ``tolerance``; finished elements drop out.  Returns the roots, nan
    where the residual does not vanish between the bounds.
    """
    roots = np.full_like(guess, np.nan)
    active = np.arange(guess.size)
    x, low, high = np.clip(guess, lower, upper), lower, upper
    last = high - low
    for _ in range(MAX_ITERATIONS):
        value, slope = residual(x, points)
        low, high = np.where(value > 0.0, x, low), np.where(value > 0.0, high, x)
        slope = np.where(np.isfinite(slope), slope, -0.0)
        new = _held(x - value / slope, low, high, last, x)
        step = np.abs(new - x)
        finished = ~(step * np.maximum(np.abs(slope), 1.0) > tolerance)
        vanished = finished & (np.abs(value) <= np.maximum(RESIDUAL_SLACK * tolerance, ROUNDING))
        roots[active[vanished]] = new[vanished]
        left = np.flatnonzero(~finished)
        if not left.size:
            break
        if left.size < active.size:
            points = points.take(left)
        active, x, low, high, last = (a[left] for a in (active, new, low, high, step))
    return roots


def _held(new, low, high, last, x):
    """Newton's point, or the middle of the bracket where that leaves it or closes in too slowly."""
    good = (new >= low) & (new <= high) & (np.abs(new - x) <= 0.5 * last)
    return np.where(good, new, 0.5 * (low + high))
