"""Sums and products of quantities that are kept as logarithms, and their slopes."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from thirdbody.core.logarithms import WithSlope, log_product, log_sum

D = np.array([0.5, 1.0, 4.0])
FIRST = WithSlope(value=-3.0 * D, slope=np.full(3, -3.0))
SECOND = WithSlope(value=-np.log(D) - 2.0, slope=-1.0 / D)


def test_the_sum_and_its_slope_are_those_of_the_numbers():
    numbers = np.exp(FIRST.value), np.exp(SECOND.value)
    total, fraction = log_sum(FIRST, SECOND)
    assert_allclose(total.value, np.log(sum(numbers)), rtol=1e-14)
    assert_allclose(fraction, numbers[0] / sum(numbers), rtol=1e-14)
    slope = (numbers[0] * FIRST.slope + numbers[1] * SECOND.slope) / sum(numbers)
    assert_allclose(total.slope, slope, rtol=1e-14)


@pytest.mark.parametrize("lower", [-1e4, -np.inf])
def test_a_number_that_float64_cannot_hold_leaves_the_other(lower):
    nothing = WithSlope(value=np.full(3, lower), slope=np.full(3, 7.0))
    for pair, part in (((FIRST, nothing), 1.0), ((nothing, FIRST), 0.0)):
        total, fraction = log_sum(*pair)
        assert np.array_equal(total.value, FIRST.value)
        assert np.array_equal(total.slope, FIRST.slope)
        assert (fraction == part).all()


def test_tails_that_float64_cannot_hold_keep_their_ratio():
    deep = [WithSlope(value=each.value - 5000.0, slope=each.slope) for each in (FIRST, SECOND)]
    total, fraction = log_sum(*deep)
    expected, ratio = log_sum(FIRST, SECOND)
    assert_allclose(total.value + 5000.0, expected.value, atol=1e-11)
    assert_allclose(fraction, ratio, rtol=1e-11)


def test_the_slope_of_a_product_is_the_sum_of_both():
    product = log_product(FIRST, SECOND)
    assert_allclose(np.exp(product.value), np.exp(FIRST.value) * np.exp(SECOND.value), rtol=1e-14)
    assert np.array_equal(product.slope, FIRST.slope + SECOND.slope)
