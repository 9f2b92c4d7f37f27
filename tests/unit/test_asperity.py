"""A Gaussian population of summits against integrals, closed forms and limits."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.integrate import quad

from tests.summit_reference import PRINTED, asperity_load_and_area
from thirdbody.model.asperity import SummitPopulation

MODULUS, HARDNESS, YIELD, PLASTIC = 112e9, 5e9, 0.4, 54.0
SUMMIT_PARAMETER = 0.05
SEPARATIONS = np.array([-3.0, -0.5, 0.0, 2.0, 8.0, 30.0])
# what the quadrature promises; the reference integrals are as good
QUADRATURE_ERROR = 2e-12


def population(plasticity_index, plastic_ratio=PLASTIC):
    """Summits with psi = (E/H) sqrt(sigma_s/R) and eta_s R sigma_s = 0.05."""
    ratio = HARDNESS / MODULUS
    sharpness = (plasticity_index * ratio) ** 2
    return SummitPopulation(SUMMIT_PARAMETER, sharpness, ratio, YIELD, plastic_ratio)


def gaussian_tail_moment(power, t):
    """ln of F_n(t), the integral of (s - t)^n phi(s) over s above t."""
    lowest = -0.5 * max(t, 0.0) ** 2

    def integrand(w):
        return w**power * np.exp(-0.5 * (t + w) ** 2 - lowest)

    end = 40.0 / max(t, 1.0) + max(-t, 0.0)
    pieces = np.linspace(0.0, end, 9)
    parts = (quad(integrand, *ends, epsrel=1e-13, epsabs=0.0) for ends in zip(pieces, pieces[1:]))
    return np.log(sum(part[0] for part in parts) / np.sqrt(2.0 * np.pi)) + lowest


def integrated(summits, t, which):
    """ln of the load (0) or area (1) of a population from one asperity and ``quad``."""
    sharpness = summits.sharpness
    w_1 = summits.yield_interference
    lowest = -0.5 * max(t, 0.0) ** 2

    def integrand(root):
        w = root**2
        values = asperity_load_and_area(w * sharpness, 1.0, 1.0, HARDNESS / MODULUS, YIELD, PLASTIC)
        return 2.0 * root * values[which] * np.exp(-0.5 * (t + w) ** 2 - lowest)

    end = 80.0 / (abs(t) + np.hypot(t, np.sqrt(80.0))) + 2.0 * max(-t, 0.0)
    edges = np.sqrt(np.unique([0.0, *(w for w in (w_1, PLASTIC * w_1) if w < end), end]))
    edges = np.unique(np.concatenate([np.linspace(*ends, 5) for ends in zip(edges, edges[1:])]))
    parts = (quad(integrand, *ends, epsrel=1e-13, epsabs=0.0) for ends in zip(edges, edges[1:]))
    total = sum(part[0] for part in parts) / np.sqrt(2.0 * np.pi)
    return np.log(SUMMIT_PARAMETER * total / sharpness) + lowest


@pytest.mark.parametrize("plasticity_index", PRINTED)
def test_reference_loads_and_areas_to_the_printed_digits(plasticity_index):
    t = np.arange(4.0)
    summits = population(plasticity_index)
    computed = np.exp(summits.log_load(t)[0]), np.exp(summits.log_load_and_area(t)[1, 0])
    for values, printed in zip(computed, PRINTED[plasticity_index], strict=True):
        assert [float(f"{value:.4e}") for value in values] == list(printed)


@pytest.mark.parametrize("plasticity_index", [0.2, 0.5, 1.0, 2.5, 8.0])
@pytest.mark.parametrize("t", SEPARATIONS)
def test_a_population_is_the_integral_over_its_asperities(plasticity_index, t):
    summits = population(plasticity_index)
    at = np.array([t])
    for which, found in enumerate(summits.log_load_and_area(at)):
        expected = integrated(summits, t, which)
        assert_allclose(found[0], expected, rtol=0.0, atol=QUADRATURE_ERROR)


@pytest.mark.parametrize("t", SEPARATIONS)
def test_hard_smooth_summits_are_those_of_greenwood_and_williamson(t):
    summits = population(1e-3)
    at = np.array([t])
    hertz = 4.0 / 3.0 * SUMMIT_PARAMETER * np.sqrt(summits.sharpness)
    load = np.log(hertz) + gaussian_tail_moment(1.5, t)
    area = np.log(np.pi * SUMMIT_PARAMETER) + gaussian_tail_moment(1.0, t)
    assert_allclose(summits.log_load(at)[0], load, rtol=0.0, atol=QUADRATURE_ERROR)
    assert_allclose(summits.log_load_and_area(at)[1, 0], area, rtol=0.0, atol=QUADRATURE_ERROR)


@pytest.mark.parametrize("plasticity_index", [1e-3, 1.0, 1e3])
def test_the_logarithms_stay_accurate_where_gaussian_tails_underflow(plasticity_index):
    t = np.array([40.0, 60.0, 100.0])
    summits = population(plasticity_index)
    for which, found in enumerate(summits.log_load_and_area(t)):
        expected = [integrated(summits, value, which) for value in t]
        # the rounding of t^2/2 itself
        assert_allclose(found[0], expected, rtol=1e-13)
