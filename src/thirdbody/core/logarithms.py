"""The limits of float64, and arithmetic with logarithms, which keeps digits beyond these limits."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

EPSILON = np.finfo(float).eps  # relative spacing of numbers
TINY = np.finfo(float).tiny  # smaller numbers lose digits


class WithSlope(NamedTuple):
    """A quantity at separations d and its derivative d/dd [m-1], arrays of the shape of d."""

    value: NDArray
    slope: NDArray


def log_product(first: WithSlope, second: WithSlope) -> WithSlope:
    """ln of the product of two quantities, from their logarithms."""
    return WithSlope(value=first.value + second.value, slope=first.slope + second.slope)


def log_sum(first: WithSlope, second: WithSlope) -> tuple[WithSlope, NDArray]:
    """ln of the sum of two quantities, from their logarithms, and the first over the sum."""
    difference = first.value - second.value
    odds = np.exp(-np.abs(difference))  # the smaller over the larger
    fraction = np.where(difference > 0.0, 1.0, odds) / (1.0 + odds)
    value = np.maximum(first.value, second.value) + np.log1p(odds)
    slope = fraction * first.slope + (1.0 - fraction) * second.slope
    return WithSlope(value=value, slope=slope), fraction
