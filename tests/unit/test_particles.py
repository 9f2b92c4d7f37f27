"""The second moment of the sizes, in closed form, against its integral (Eqs. 4-6)."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from thirdbody.model.particles import Moment

pytestmark = pytest.mark.filterwarnings("error")


@pytest.mark.parametrize("truncation", [0.5, 3.0, 6.0, 10.0])
def test_the_moment_keeps_its_digits_next_to_the_largest_size(truncation):
    moment = Moment(constant=0.0, linear=1.0, smallest=0.0, largest=truncation)
    alpha = truncation - np.array([1e-6, 1e-3, 0.03, 0.09, 0.11, 0.2, 0.24, 0.26, 0.4])
    nodes, weights = np.polynomial.legendre.leggauss(40)
    half = 0.5 * (truncation - alpha)
    u = alpha[:, None] + half[:, None] * (1.0 + nodes)
    expected = half * (weights * u**2 * np.exp(-0.5 * u**2)).sum(axis=1) / np.sqrt(2.0 * np.pi)
    found, _ = moment(alpha)
    assert_allclose(found, expected, rtol=2e-13)
