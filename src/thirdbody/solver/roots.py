"""Roots of many decreasing functions at once: Newton's method held by a bracket."""

from __future__ import annotations

import numpy as np

MAX_ITERATIONS = 200
CAUTION = 30.0  # the next step may be this much larger than the last two make it
NEAR = 0.1  # a larger residual is not yet where steps shrink quadratically
EPSILON = np.finfo(float).eps
ROUNDING = 4.0 * EPSILON  # a bracket this narrow holds a jump, or nothing
NOISE = 1e-14  # of a residual that is a difference of logarithms


def decreasing_roots(residual, guess, lower, upper, tolerance, points):
    """Elementwise root of a decreasing ``residual`` between ``lower`` and ``upper``.

    ``residual(x, points)`` returns (value, slope, gain, rounding) for a 1-D array x and the points
    it belongs to: ``gain`` is by how much, relative to itself, what is wanted of x changes with x
    at the most, ``rounding`` what its evaluation adds to its relative error.  ``points`` has
    ``take(chosen)``; a nan value counts as one beyond the root.  ``guess`` and the finite bounds
    have one shape.  An element is finished once its next Newton step, and what the residual and
    the wanted change over it, would be below ``tolerance``, or its steps are rounding: steps
    shrink quadratically, and how fast shows in the last two.  Finished elements drop out.

    Returns the roots, nan where the residual does not vanish between the bounds; how far off they
    may be for the steps left out and for rounding; a bound on the relative error of what is
    wanted; and how much a relative error of the residual is magnified in it.
    """
    roots, widths, errors, conditions = np.full((4, guess.size), np.nan)
    active = np.arange(guess.size)
    x, low, high = np.clip(guess, lower, upper), lower, upper
    last, quadratic = high - low, np.zeros(guess.shape, dtype=bool)
    least = np.full_like(guess, np.inf)
    for _ in range(MAX_ITERATIONS):
        value, slope, gain, rounding = residual(x, points)
        slope = np.where(np.isfinite(slope), slope, 0.0)
        low, high = np.where(value > 0.0, x, low), np.where(value > 0.0, high, x)
        size, steepness = np.abs(value), np.abs(slope)
        new = x - value / slope
        step = np.abs(new - x)
        newton = (new >= low) & (new <= high) & ((step <= 0.5 * last) | (size <= 0.5 * least))
        new = np.where(newton, new, 0.5 * (low + high))
        step = np.where(newton, step, 0.5 * (high - low))
        shrinking = np.where(quadratic, CAUTION * (step / last) ** 2, 1.0)
        coming = np.minimum(shrinking, 1.0) * step
        noise = NOISE / steepness + EPSILON * np.abs(x)
        exact = coming * np.maximum(np.maximum(steepness, gain), 1.0) <= tolerance
        settled = newton & (exact | (step <= noise)) & (size <= NEAR)
        spacing = ROUNDING * (1.0 + np.abs(x))
        finished = settled | ~(high - low > spacing)
        steepest = np.maximum(tolerance, 2.0 * spacing * steepness)
        found = settled | finished & (size <= steepest)
        place = active[found]
        roots[place] = new[found]
        width = np.where(settled, coming, spacing) + noise
        widths[place] = width[found]
        errors[place] = (width * gain + rounding)[found]
        conditions[place] = (gain / steepness)[found]
        left = np.flatnonzero(~finished)
        if not left.size:
            break
        if left.size < active.size:
            points = points.take(left)
        columns = active, new, low, high, step, newton, size
        active, x, low, high, last, quadratic, least = (column[left] for column in columns)
    return roots, widths, errors, conditions
