"""Piecewise polynomials against the functions that they stand for."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from thirdbody.solver.tabulation import PiecewisePolynomial

pytestmark = pytest.mark.filterwarnings("error")

START, END, PIECES, DEGREE = -2.0, 3.0, 20, 7
# interpolation at 8 Chebyshev points of pieces 0.25 wide: (0.25/2)^8/(8! 2^7) = 1.2e-14 for a
# function whose derivatives stay below 1; and as much again for rounding
TABLE_ERROR = 2.4e-14


def wave(x):
    return np.sin(x), np.cos(x)


@pytest.fixture(scope="module")
def table():
    return PiecewisePolynomial(wave, START, END, PIECES, DEGREE)


@pytest.fixture(scope="module")
def boundaries():
    return np.linspace(START, END, PIECES + 1)


def test_values_between_the_nodes(table):
    x = np.linspace(START, END, 10007)
    assert_allclose(table(x)[0], np.sin(x), rtol=0.0, atol=TABLE_ERROR)


def test_slopes_between_the_nodes(table):
    x = np.linspace(START, END, 10007)
    # a derivative loses a factor of the order degree^2/h
    assert_allclose(table(x)[1], np.cos(x), rtol=0.0, atol=1e3 * TABLE_ERROR)


def test_a_higher_degree_is_closer():
    x = np.linspace(START, END, 1001)
    errors = [
        np.abs(PiecewisePolynomial(wave, START, END, PIECES, degree)(x)[0] - np.sin(x)).max()
        for degree in (1, 3, 5)
    ]
    assert errors[0] > 100.0 * errors[1] > 1e4 * errors[2]


def test_pieces_meet_without_a_jump(table, boundaries):
    inner = boundaries[1:-1]
    below = table(np.nextafter(inner, -np.inf))
    above = table(np.nextafter(inner, np.inf))
    assert_allclose(above[0], below[0], rtol=0.0, atol=TABLE_ERROR)
    assert_allclose(above[1], below[1], rtol=0.0, atol=1e3 * TABLE_ERROR)


def test_the_ends_meet_the_function_itself(table):
    for end in (START, END):
        x = np.array([np.nextafter(end, -np.inf), end, np.nextafter(end, np.inf)])
        assert_allclose(table(x)[0], np.sin(x), rtol=0.0, atol=TABLE_ERROR)


def test_outside_the_interval_the_function_itself_answers(table):
    x = np.array([START - 1.0, END + 1.0, 1e6])
    value, slope = table(x)
    assert np.array_equal(value, np.sin(x))
    assert np.array_equal(slope, np.cos(x))


def test_inside_the_interval_the_function_is_not_called(table):
    def refuse(x):
        raise AssertionError("called inside its table")

    other = PiecewisePolynomial(wave, START, END, PIECES, DEGREE)
    other.function = refuse
    x = np.linspace(START, END - 1e-9, 50)
    assert np.array_equal(other(x)[0], table(x)[0])


def test_nan_stays_nan_and_harms_no_neighbour(table):
    x = np.array([0.5, np.nan, 1.5])
    value, slope = table(x)
    assert np.isnan(value[1])
    assert np.isnan(slope[1])
    assert_allclose(value[[0, 2]], np.sin(x[[0, 2]]), rtol=0.0, atol=TABLE_ERROR)


@pytest.mark.parametrize("shape", [(0,), (1,), (6,), (2, 3), (3, 1, 2)])
def test_any_shape_gives_its_own_shape(table, shape):
    x = np.linspace(START - 0.5, END + 0.5, int(np.prod(shape))).reshape(shape)
    value, slope = table(x)
    assert value.shape == slope.shape == shape
    assert_allclose(value, np.sin(x), rtol=0.0, atol=TABLE_ERROR)


def test_a_polynomial_of_the_degree_is_reproduced():
    def cubic(x):
        return 1.0 - x + 2.0 * x**3, -1.0 + 6.0 * x**2

    table = PiecewisePolynomial(cubic, 0.0, 1.0, pieces=3, degree=3)
    x = np.linspace(0.0, 1.0, 101)
    assert_allclose(table(x)[0], cubic(x)[0], rtol=0.0, atol=1e-14)
    assert_allclose(table(x)[1], cubic(x)[1], rtol=0.0, atol=1e-12)
