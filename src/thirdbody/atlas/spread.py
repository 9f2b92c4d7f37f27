"""What the members of an ensemble give, in three numbers."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.data.spread import ENDS

QUANTILES = np.array([ENDS[0], 0.5, ENDS[1]])  # nine in ten lie between the first and the last


def quantiles(values: NDArray, fractions: ArrayLike = QUANTILES) -> NDArray[np.float64]:
    """Quantiles over the members, with linear interpolation.

    Parameters
    ----------
    values : array, shape (members, ...)
        Infinite where a member is beyond all bounds; nan where it has no value, and does not count.
    fractions : array_like, shape (n,)
        Shares of the members below each quantile [1].

    Returns
    -------
    array, shape (n, ...)
        nan where no member has a value.

    Examples
    --------
    >>> quantiles(np.array([[4.0, 1.0], [2.0, np.inf], [3.0, np.nan]]), [0.0, 0.5])
    array([[ 2.,  1.],
           [ 3., inf]])
    """
    ordered = np.sort(values, axis=0)  # nan last
    known = np.count_nonzero(~np.isnan(values), axis=0)
    place = np.multiply.outer(np.asarray(fractions), np.maximum(known - 1, 0))
    below = np.floor(place).astype(int)
    above = np.minimum(below + 1, np.maximum(known - 1, 0))
    low, high = (np.take_along_axis(ordered, each, axis=0) for each in (below, above))
    with np.errstate(invalid="ignore"):  # infinity less infinity
        step = np.where((place > below) & (low != high), (place - below) * (high - low), 0.0)
    return np.where(known > 0, low + step, np.nan)
