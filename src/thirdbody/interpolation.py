"""Tables of smooth functions: piecewise quintic Hermite interpolation on a uniform grid."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from copy import copy

import numpy as np
from numpy.typing import ArrayLike, NDArray

ELSEWHERE = 1.25  # largest error of a piece over the error at its midpoint


class HermiteTable:
    """Functions of one variable and their slopes, as piecewise quintic polynomials.

    Each polynomial matches the value, slope and curvature of its function at both ends.

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
        Estimate of the largest error of the values: ``ELSEWHERE`` times the error at midpoints.

    Examples
    --------
    >>> import numpy as np
    >>> def sine(x):
    ...     return np.stack([np.sin(x), np.cos(x), -np.sin(x)])[None]
    >>> table = HermiteTable(sine, 0.0, 3.0, 90)
    >>> value, slope = table(np.array([0.5, 2.0]))
    >>> bool(abs(value - np.sin([0.5, 2.0])).max() < 1e-12), bool(abs(slope[0] - np.cos(0.5)) < 1e-9)
    (True, True)
    """

    def __init__(self, function: Callable, start: float, end: float, pieces: int):
        self.start, self.end, self.pieces = start, end, pieces
        places, step = np.linspace(start, end, 2 * pieces + 1, retstep=True)
        sampled = function(places)
        self._per_piece = pieces / (end - start)
        self._rows = _quintics(sampled[..., ::2], 2.0 * step)
        middle = self._rows @ 0.5 ** np.arange(6)
        self.error = ELSEWHERE * np.abs(middle - sampled[:, 0, 1::2]).max(axis=-1)

    def covers(self, x: NDArray) -> NDArray:
        """Whether each ``x`` lies in the interval."""
        return (x >= self.start) & (x < self.end)

    @classmethod
    def joined(cls, tables: Sequence[HermiteTable]) -> HermiteTable:
        """Combine tables on the same interval and pieces: all functions of the first, then of the
        second, and so on."""
        found = copy(tables[0])
        found._rows = np.concatenate([table._rows for table in tables])
        found.error = np.concatenate([table.error for table in tables])
        return found

    def __call__(self, x: ArrayLike, which: ArrayLike = 0) -> tuple[NDArray, NDArray]:
        """Value and slope of the functions with index ``which`` at ``x``, an array in the interval."""
        position = (x - self.start) * self._per_piece
        piece = position.astype(np.intp)
        x = position - piece
        piece = piece + self.pieces * which
        rows = self._rows.reshape(-1, 6).take(piece, axis=0, mode="clip")
        value, slope = rows[..., 5] * x + rows[..., 4], rows[..., 5]
        for power in (3, 2, 1, 0):
            slope = slope * x + value
            value = value * x + rows[..., power]
        return value, slope * self._per_piece


def _quintics(nodes, step):
    """Coefficients in powers of the position (0 to 1) in each piece: (functions, pieces, 6)."""
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
    return np.stack(powers, axis=-1)
