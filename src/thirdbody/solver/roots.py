"""Roots of many decreasing functions at once: Newton's method held by a bracket.

``decreasing_roots`` solves the balance of forces of all points together.  Elements that are
finished drop out, so that a few difficult points do not hold up the others.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

MAX_ITERATIONS = 200
MAX_ENCLOSURES = 100
CAUTION = 30.0  # the next step may be this much larger than the last two make it
DOUBT = 4.0  # by which an enclosure grows that did not hold its root
FAR = 30.0  # a larger residual may fall by half at each of very many steps
NEAR = 0.1  # a larger residual is not yet where steps shrink quadratically
EPSILON = np.finfo(float).eps
KINKED = 2.0  # ratio of gains at the ends of an error that tells of a kink between them
ROUNDING = 4.0 * EPSILON  # a bracket this narrow holds a jump, or nothing


class Residual(NamedTuple):
    """A decreasing function at x, and what an error of x does to what is wanted of the root.

    All are arrays of the shape of x, or scalars.

    Attributes
    ----------
    value : array
        The function; nan counts as beyond the root.
    slope : array
        Its slope.
    gain : array
        What the caller computes from the root x are several variables v.  This is a bound on the
        size of d ln v/dx: by it an error of x becomes a relative error of what is wanted.
    noise : array
        What rounding may change in the value.
    rounding : array
        Relative error that rounding adds when these variables are evaluated.
    known_within : array
        What the value may be wrong by for other reasons: a smooth error, which no step feels.
    """

    value: NDArray
    slope: NDArray
    gain: NDArray
    noise: ArrayLike = 0.0
    rounding: ArrayLike = 0.0
    known_within: ArrayLike = 0.0


class Roots(NamedTuple):
    """Roots, all 1-D, nan where the function does not vanish between the bounds.

    Attributes
    ----------
    root : array
        Where the function vanishes.
    width : array
        How far off it may be: the function has been seen to be positive at ``root - width`` and not
        at ``root + width``; nan where rounding leaves that open however wide.
    error : array
        Bound on the relative error of what is wanted of the root; infinite where the width is nan,
        or where the function falls so far within it that slopes at its ends say nothing of what
        lies between.
    """

    root: NDArray
    width: NDArray
    error: NDArray


def decreasing_roots(
    residual: Callable,
    guess: NDArray,
    lower: NDArray,
    upper: NDArray,
    tolerance: float,
    points,
) -> Roots:
    """Find where a decreasing function is zero, element by element.

    Parameters
    ----------
    residual : callable
        ``residual(x, points)`` for a 1-D array x returns its ``Residual``.
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
    Roots

    Notes
    -----
    Each iteration takes Newton's step if it stays within the bracket and at least halves the step,
    or the function where that is not ``FAR`` from zero, and else the middle of the bracket.
    Newton's steps shrink quadratically near a root: the next one is estimated from the last two,
    with ``CAUTION``.  An element settles once that next step is too small to matter to the function
    or to what is wanted, or its steps are rounding, or its bracket is as narrow as float64 allows.
    When all have, an element is finished if the function changes its sign within the error that is
    then promised; if not, because a kink lies between, its search goes on from the end that
    disagrees.
    """
    found = Roots(*np.full((3, guess.size), np.nan))
    active = np.arange(guess.size)
    x, low, high, doubt = np.clip(guess, lower, upper), lower, upper, np.ones_like(guess)
    for _ in range(MAX_ENCLOSURES):
        near = _approach(residual, x, low, high, doubt, tolerance, points)
        bounds = lower[active], upper[active]
        ends = (
            np.fmax(near.root - near.width, bounds[0]),
            np.fmin(near.root + near.width, bounds[1]),
        )
        seen, beyond = _enclose(residual, near.root, ends, bounds, tolerance, points)
        for values, column in zip(seen, found, strict=True):
            column[active] = values
        # where a sign is wrong, the search goes on from there
        x = np.choose(beyond + 1, (ends[0], near.root, ends[1]))
        low, high = np.where(beyond > 0, x, near.low), np.where(beyond < 0, x, near.high)
        doubt = DOUBT * near.doubt
        # signs contradict those seen before: about here the function is but rounding away from zero
        below = (beyond < 0) & (near.low > bounds[0]) & (near.low >= ends[0])
        above = (beyond > 0) & (near.high < bounds[1]) & (near.high <= ends[1])
        unsure = np.flatnonzero(below | above)
        found.root[active[unsure]], found.error[active[unsure]] = near.root[unsure], np.inf
        lost = np.isnan(near.root) | (near.narrow == 1) & (beyond != 0) | below | above
        left = np.flatnonzero(~(lost | np.isfinite(seen.root)))
        if not left.size:
            break
        points = _some(points, left, active.size)
        active, x, low, high, doubt = (each[left] for each in (active, x, low, high, doubt))
    return found


class _Approach(NamedTuple):
    """Where steps towards some roots have ended: nan in all where they have not.

    The root is within ``width`` if steps told the truth, ``low`` and ``high`` are where the function
    was seen to be positive and not to be; ``narrow`` is 1 where nothing lies between them.
    """

    root: NDArray
    low: NDArray
    high: NDArray
    doubt: NDArray
    width: NDArray
    narrow: NDArray


def _approach(residual, x, low, high, doubt, tolerance, points):
    """Step from ``x`` towards roots between ``low`` and ``high`` until they are settled.

    Of steps ``doubt`` times as much is left as they make believe; it wanes with every step.
    """
    near = _Approach(*np.full((6, x.size), np.nan))
    active = np.arange(x.size)
    last, quadratic = high - low, np.zeros(x.shape, dtype=bool)
    least = np.full_like(x, np.inf)
    for _ in range(MAX_ITERATIONS):
        here = residual(x, points)
        slope = np.where(np.isfinite(here.slope), here.slope, 0.0)
        low, high = np.where(here.value > 0.0, x, low), np.where(here.value > 0.0, high, x)
        size, steepness = np.abs(here.value), np.abs(slope)
        new = x - here.value / slope
        step = np.abs(new - x)
        falls = (size <= 0.5 * least) & (size <= FAR)
        newton = (new >= low) & (new <= high) & ((step <= 0.5 * last) | falls)
        new = np.where(newton, new, 0.5 * (low + high))
        step = np.where(newton, step, 0.5 * (high - low))
        shrinking = np.where(quadratic, CAUTION * (step / last) ** 2, 1.0)
        coming = np.minimum(shrinking, 1.0) * step
        noise = here.noise / steepness + EPSILON * np.abs(x)
        exact = coming * np.maximum(np.maximum(steepness, here.gain), 1.0) <= tolerance
        spacing = ROUNDING * (1.0 + np.abs(x))
        narrow = ~(high - low > spacing)
        settled = narrow | newton & (exact & (size <= NEAR) | (step <= noise))
        if settled.any():
            width = doubt * np.where(narrow, spacing, np.maximum(coming, 2.0 * noise))
            width += 1.5 * here.known_within / steepness
            for column, values in zip(near, (new, low, high, doubt, width, narrow), strict=True):
                column[active[settled]] = values[settled]
        left = np.flatnonzero(~settled)
        if not left.size:
            break
        points = _some(points, left, active.size)
        doubt = np.maximum(0.5 * doubt, 1.0)
        columns = active, new, low, high, step, newton, size, doubt
        active, x, low, high, last, quadratic, least, doubt = (column[left] for column in columns)
    return near


def _some(points, chosen, count):
    """Those of ``count`` points that ascending indices ``chosen`` pick."""
    return points if chosen.size == count else points.take(chosen)


def _enclose(residual, root, ends, bounds, tolerance, points):
    """Whether the function changes its sign between two ``ends`` about ``root``.

    Returns ``Roots``, nan where it is not seen to, and the side on which the root lies beyond them: 1
    above, -1 below, 0 if they are too close to tell.  At a bound the sign alone decides, elsewhere
    a value has to be larger than what it may be wrong by.
    """
    both = residual(np.concatenate(ends), points.take(np.tile(np.arange(root.size), 2)))
    columns = [np.broadcast_to(each, 2 * root.size).reshape(2, root.size) for each in both]
    at_ends = [Residual(*(column[end] for column in columns)) for end in (0, 1)]
    below, above = (end.value for end in at_ends)
    doubts = [
        np.where(place == bound, 0.0, end.noise + end.known_within)
        for end, place, bound in zip(at_ends, ends, bounds, strict=True)
    ]
    holds = (below >= doubts[0]) & ~(above > -doubts[1])
    beyond = np.where(above > doubts[1], 1, np.where(below >= -doubts[0], 0, -1))
    width = np.maximum(root - ends[0], ends[1] - root)
    steepest = np.maximum(*(np.abs(end.slope) for end in at_ends))
    jumps = ~(below - above <= 4.0 * np.maximum(tolerance, steepest * width))
    gains = [end.gain for end in at_ends]
    most = np.maximum(*gains)
    # up to a kink between the ends the gain may have grown beyond either
    most = np.where(most > KINKED * np.minimum(*gains), KINKED * most, most)
    error = np.expm1(width * most)
    error += np.maximum(*(end.rounding for end in at_ends))
    found = root, width, np.where(jumps, np.inf, error)
    return Roots(*np.where(holds, found, np.nan)), np.where(holds, 0, beyond)
