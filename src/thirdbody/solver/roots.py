"""Roots of many decreasing functions at once: Newton's method held by a bracket.

``decreasing_roots`` solves the balance of forces of all points together.  Elements that are
finished drop out, so that a few difficult points do not hold up the others.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

MAX_ITERATIONS = 200
CAUTION = 30.0  # the next step may be this much larger than the last two make it
NEAR = 0.1  # a larger residual is not yet where steps shrink quadratically
EPSILON = np.finfo(float).eps
ROUNDING = 4.0 * EPSILON  # a bracket this narrow holds a jump, or nothing
NOISE = 1e-14  # of a residual that is a difference of logarithms


def decreasing_roots(
    residual: Callable,
    guess: NDArray,
    lower: NDArray,
    upper: NDArray,
    tolerance: float,
    points,
) -> tuple[NDArray, NDArray, NDArray, NDArray]:
    """Find where a decreasing function is zero, element by element.

    Parameters
    ----------
    residual : callable
        ``residual(x, points)`` for a 1-D array x returns four arrays of its shape, or scalars:

        value
            The function.  It decreases with x; nan counts as beyond the root.
        slope
            Its slope.
        gain
            What the caller computes from the root x are several variables v.  This is a bound on
            the size of d ln v/dx: by it an error of x becomes a relative error of what is wanted.
        rounding
            Relative error that rounding adds when these variables are evaluated.
    guess : array, shape (n,)
        Where to begin.
    lower, upper : array, shape (n,)
        Finite bounds between which the roots are sought.
    tolerance : float
        Relative error that the last step may leave in the function's arguments and in what is
        wanted of the root.
    points : object
        What ``residual`` needs to know of each element; ``points.take(index)`` picks some.

    Returns
    -------
    roots : array, shape (n,)
        nan where the function does not vanish between the bounds.
    widths : array
        How far off a root may be because of the steps that were left out and of rounding.
    errors : array
        Bound on the relative error of what is wanted of the root.
    conditions : array
        By how much a relative error of the function's terms is magnified in what is wanted.

    Notes
    -----
    Each iteration takes Newton's step if it stays within the bracket and at least halves either
    the step or the function, and else the middle of the bracket.  Newton's steps shrink
    quadratically near a root: the next one is estimated from the last two, with ``CAUTION``.  An
    element is finished once that next step is too small to matter to the function or to what is
    wanted, or its steps are rounding, or its bracket is as narrow as float64 allows.
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
