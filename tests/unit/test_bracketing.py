"""Roots between bounds, against functions whose roots are known."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from thirdbody.curves.bracketing import bracketed_roots

pytestmark = pytest.mark.filterwarnings("error")

ROOTS = np.array([0.1, 0.7, 1.3, 2.9])
FUNCTIONS = {
    "falling": lambda x: ROOTS - x,
    "rising steeply": lambda x: np.expm1(30.0 * (x - ROOTS)),
    "flat at the root": lambda x: (x - ROOTS) ** 3,
    "jumping": lambda x: np.sign(x - ROOTS),
    "unknown beyond": lambda x: np.where(x < ROOTS, ROOTS - x + 1.0, np.nan),
}


@pytest.mark.parametrize("name", FUNCTIONS)
@pytest.mark.parametrize("tolerance", [1e-2, 1e-9, 0.0])
def test_roots_are_within_the_stated_width(name, tolerance):
    found, width = bracketed_roots(FUNCTIONS[name], np.zeros(4), np.full(4, 3.0), tolerance)
    assert (np.abs(found - ROOTS) <= width + 1e-15).all()
    assert (width <= np.maximum(tolerance, 1e-14)).all()


def test_a_root_at_a_bound_is_that_bound():
    found, _ = bracketed_roots(lambda x: x - 1.0, np.array([1.0, 0.0]), np.array([2.0, 1.0]), 1e-9)
    assert_allclose(found, 1.0, rtol=0.0)


def test_smooth_functions_take_few_evaluations():
    calls = []

    def function(x):
        calls.append(x)
        return np.cos(x) - x

    found, _ = bracketed_roots(function, np.zeros(1), np.ones(1), 1e-12)
    assert_allclose(found, 0.7390851332151607, rtol=1e-12)
    assert len(calls) <= 12


def test_nothing_to_find_is_nothing():
    found, width = bracketed_roots(np.cos, np.zeros(0), np.zeros(0), 1e-9)
    assert found.size == width.size == 0
