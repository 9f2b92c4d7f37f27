"""Tables of functions on a uniform grid: quintic Hermite interpolation, and linear for guesses."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from copy import copy

import numpy as np
from numpy.typing import NDArray

ELSEWHERE = 1.25  # largest error of a piece over the error at its midpoint


class HermiteTable:
    """Functions of one variable and their slopes, as piecewise quintic polynomials.

    Each polynomial matches the value, slope and curvature of its function at both ends.  Pieces of
    equal width need no search: for many unsorted x the table takes a tenth of the time of
    ``scipy.interpolate.PPoly``.

    Parameters
    ----------
    function : callable
        Maps a 1-D array x to an array of the shape (functions, 3, len(x)): values, slopes and
        curvatures of each function.
    start, end : float
        The interval of x.
    pieces : int
        Number of polynomials, on pieces of equal width.

    Attributes
    ----------
    error : array, shape (functions,)
        Estimate of the largest error of the values: ``ELSEWHERE`` times the largest error at
        midpoints.

    Examples
    --------
    >>> import numpy as np
    >>> def sine(x):
    ...     return np.stack([np.sin(x), np.cos(x), -np.sin(x)])[None]
    >>> table = HermiteTable(sine, 0.0, 3.0, 90)
    >>> value, slope = table(np.array([0.5, 2.0]))
    >>> bool(abs(value - np.sin([0.5, 2.0])).max() < 1e-12)
    True
    >>> bool(abs(slope[0] - np.cos(0.5)) < 1e-9)
    True
    """

    def __init__(self, function: Callable, start: float, end: float, pieces: int):
        self.start, self.end, self.pieces = start, end, pieces
        x_samples, step = np.linspace(start, end, 2 * pieces + 1, retstep=True)
        sampled = function(x_samples)
        self._per_piece = pieces / (end - start)
        self._powers = _quintics(sampled[..., ::2], 2.0 * step).reshape(6, -1)
        middle = (0.5 ** np.arange(6) @ self._powers).reshape(-1, pieces)
        self.error = ELSEWHERE * np.abs(middle - sampled[:, 0, 1::2]).max(axis=-1)

    def covers(self, x: NDArray) -> NDArray:
        """Whether each ``x`` lies in the interval."""
        return (x >= self.start) & (x < self.end)

    @classmethod
    def joined(cls, tables: Sequence[HermiteTable]) -> HermiteTable:
        """Combine tables with the same interval and pieces.

        The functions of the first table come first, then those of the second, and so on.
        """
        joined = copy(tables[0])
        joined._powers = np.concatenate([table._powers for table in tables], axis=1)
        joined.error = np.concatenate([table.error for table in tables])
        return joined

    def __call__(self, x: NDArray, which: int | NDArray = 0) -> tuple[NDArray, NDArray]:
        """Value and slope of the functions with index ``which`` at ``x``, an array in the
        interval."""
        position = (x - self.start) * self._per_piece
        piece = position.astype(np.intp)
        x = position - piece
        piece = piece + self.pieces * which
        *lower, fourth, fifth = self._powers.take(piece, axis=1, mode="clip")
        value, slope = fifth * x + fourth, fifth
        for power in reversed(lower):
            slope = slope * x + value
            value = value * x + power
        return value, slope * self._per_piece


class Guesses:
    """Approximate values of a function that is known at increasing ``x``.

    They are interpolated linearly between ``count`` values at equal distances.  This is much faster
    than ``numpy.interp``, which searches.
    """

    def __init__(self, x: NDArray, values: NDArray, count: int):
        x_samples, self._step = np.linspace(x[0], x[-1], count, retstep=True)
        self._start, self._values = x[0], np.interp(x_samples, x, values)

    def __call__(self, x: NDArray) -> NDArray:
        """Values at an array ``x``; outside, the value at the nearest end."""
        last = self._values.size - 1
        position = np.minimum(np.maximum((x - self._start) / self._step, 0.0), last)
        step = np.minimum(position.astype(np.intp), last - 1)
        low, high = (self._values.take(step + end, mode="clip") for end in (0, 1))
        return low + (position - step) * (high - low)


def _quintics(nodes, step):
    """Coefficients of the powers of the position (0 to 1) in a piece: (6, functions, pieces)."""
    y, y_1, y_2 = nodes[:, 0, :-1], nodes[:, 1, :-1] * step, nodes[:, 2, :-1] * step**2
    z, z_1, z_2 = nodes[:, 0, 1:], nodes[:, 1, 1:] * step, nodes[:, 2, 1:] * step**2
    rise, rise_1, rise_2 = z - y - y_1 - 0.5 * y_2, z_1 - y_1 - y_2, z_2 - y_2
    powers = (
        y,
        y_1,
        0.5 * y_2,
        10.0 * rise - 4.0 * rise_1 + 0.5 * rise_2,
        -15.0 * rise + 7.0 * rise_1 - rise_2,
        6.0 * rise - 3.0 * rise_1 + 0.5 * rise_2,
    )
    return np.stack(powers)
