"""Bracketed Newton roots of decreasing functions, whose roots are known."""

from dataclasses import dataclass

import numpy as np
import pytest
from numpy.testing import assert_allclose

from thirdbody.solver.roots import Residual, decreasing_roots

pytestmark = pytest.mark.filterwarnings("error")

TOLERANCE = 1e-12


@dataclass
class Targets:
    """The values that a function is to take, and how many were asked for at each step."""

    value: np.ndarray
    sizes: list

    def take(self, chosen):
        return Targets(self.value[chosen], self.sizes)


def solved(function, roots, guess, lower, upper, tolerance=TOLERANCE):
    """Roots of function(x) = function(``roots``), and the number of points in each step."""
    targets = Targets(function(roots)[0], [])

    def residual(x, some):
        some.sizes.append(x.size)
        value, slope = function(x)
        return Residual(value - some.value, slope, np.ones_like(x))

    ends = (np.full_like(roots, end) for end in (guess, lower, upper))
    return decreasing_roots(residual, *ends, tolerance, targets)[0], targets.sizes


def line(x):
    return -3.0 * x, np.full_like(x, -3.0)


def cube(x):
    return -(x**3), -3.0 * x**2


def step(x):
    return -np.arctan(1e6 * x), -1e6 / (1.0 + (1e6 * x) ** 2)


def exponential(x):
    return np.exp(-x), -np.exp(-x)


@pytest.mark.parametrize("function", [line, cube, step, exponential])
@pytest.mark.parametrize("guess", [-10.0, 0.3, 10.0, 1e300])
def test_roots_are_found_from_any_guess(function, guess):
    roots = np.array([-9.99, -0.5, 1e-3, 0.1, 9.99])
    found, _ = solved(function, roots, guess, -10.0, 10.0)
    # the steepest place decides where rounding of the value allows no better
    allowed = TOLERANCE + 4e-16 * np.abs(function(roots)[0] / function(roots)[1])
    assert (np.abs(found - roots) <= allowed).all()


def test_a_root_at_either_end_of_the_bracket_is_found():
    roots = np.array([-10.0, 10.0])
    found, _ = solved(line, roots, 0.0, -10.0, 10.0)
    assert_allclose(found, roots, rtol=0.0, atol=TOLERANCE)


@pytest.mark.parametrize("root", [-11.0, 11.0])
def test_without_a_root_between_the_bounds_the_answer_is_nan(root):
    found, _ = solved(line, np.array([root, 2.0]), 0.0, -10.0, 10.0)
    assert np.isnan(found[0])
    assert found[1] == pytest.approx(2.0, abs=TOLERANCE)


@pytest.mark.parametrize("tolerance", [1e-12, 1e-6, 1e-3, 5e-3])
def test_a_residual_that_stays_negative_has_no_root_at_any_tolerance(tolerance):
    # at the lower bound it is still a tenth below zero: far more than any tolerance
    found, _ = solved(line, np.array([-0.1 / 3.0]), 0.5, 0.0, 1.0, tolerance)
    assert np.isnan(found[0])


def test_what_is_wanted_of_a_jump_over_zero_is_not_known():
    def jump(x, points):
        return Residual(np.where(x < 0.25, 1.0, -1.0), np.zeros_like(x), np.ones_like(x))

    zero = np.zeros(1)
    with np.errstate(divide="ignore", invalid="ignore"):
        ends = zero, zero - 1.0, zero + 1.0
        found, _, error = decreasing_roots(jump, *ends, TOLERANCE, Targets(zero, []))
    assert found[0] == pytest.approx(0.25, abs=1e-14)
    assert np.isinf(error[0])


def test_a_kink_within_the_error_does_not_hide_how_steep_it_is_before():
    """ln v falls steeper and steeper up to 0.5 - 1e-9, where it stops; the root is just before."""
    kink = 0.5 - 1e-9

    def gain(x):
        return np.where(x < kink, 1e5 * (1.0 + 1e6 * (x - kink + 1e-8)), 1.0)

    def bent(x, points):
        value = np.where(x < kink, kink - x, 0.0) - 1e-3 * (x - 0.5)
        return Residual(value, np.where(x < kink, -1.0, -1e-3), gain(x), 0.0, 0.0, 1e-12)

    zero = np.zeros(1)
    found, width, error = decreasing_roots(
        bent, zero + 0.5, zero, zero + 1.0, 1e-3, Targets(zero, [])
    )
    assert found[0] - width[0] < kink < found[0] + width[0]
    assert error[0] >= width[0] * gain(np.array([kink - 1e-15]))[0]


def test_a_root_at_the_end_of_a_plateau_within_rounding_of_zero_is_not_certain():
    def plateau(x, points):
        value = np.minimum(1e-11, 1e-3 * (0.25 - x))
        slope = np.where(value < 1e-11, -1e-3, 0.0)
        return Residual(np.where(x < -0.5, -1.0, value), slope, np.ones_like(x), 3e-11)

    zero = np.zeros(1)
    with np.errstate(divide="ignore", invalid="ignore"):
        ends = zero, zero - 1.0, zero + 0.25 + 1e-9
        found, _, error = decreasing_roots(plateau, *ends, TOLERANCE, Targets(zero, []))
    assert found[0] == pytest.approx(0.25, abs=1e-7)
    assert np.isinf(error[0])


def test_nan_counts_as_a_value_beyond_the_root():
    def logarithm(x):
        with np.errstate(invalid="ignore", divide="ignore"):
            return np.log(1.0 - x), -1.0 / (1.0 - x)

    roots = np.array([-0.5, 0.1, 0.9])
    found, _ = solved(logarithm, roots, 5.0, -10.0, 10.0)
    assert_allclose(found, roots, rtol=0.0, atol=TOLERANCE)


def test_finished_elements_drop_out():
    hard = np.concatenate([np.full(5, 0.5), [1e-3]])
    found, sizes = solved(cube, hard, 0.5, -10.0, 10.0)
    assert_allclose(found, hard, rtol=0.0, atol=TOLERANCE)
    assert sizes[0] == 6
    assert sizes[-1] == 12  # both ends of all enclosures
    assert sizes[-2] == 1
    assert sorted(sizes[:-1], reverse=True) == sizes[:-1]


def test_no_points_give_no_roots():
    found, sizes = solved(line, np.zeros(0), 0.0, -1.0, 1.0)
    assert found.shape == (0,)


@pytest.mark.parametrize("tolerance", [1e-3, 1e-6, 1e-9])
def test_a_looser_tolerance_is_met_in_fewer_steps(tolerance):
    roots = np.linspace(-3.0, 3.0, 50)
    found, sizes = solved(exponential, roots, 0.0, -10.0, 10.0, tolerance)
    _, tight = solved(exponential, roots, 0.0, -10.0, 10.0, 1e-14)
    assert np.abs(found - roots).max() <= tolerance
    assert sum(sizes) < sum(tight)


def test_a_slope_that_leads_nowhere_falls_back_to_halving():
    def cubic(x):
        return -(x**3), np.zeros_like(x)

    with np.errstate(divide="ignore", invalid="ignore"):
        found, _ = solved(cubic, np.array([0.3]), 0.0, -1.0, 2.0)
    assert found[0] == pytest.approx(0.3, abs=1e-9)


def test_the_given_arrays_are_left_alone():
    guess, lower, upper = np.full(3, 5.0), np.full(3, -10.0), np.full(3, 10.0)
    targets = Targets(np.array([1.0, 2.0, 3.0]), [])

    def residual(x, some):
        return Residual(-x - some.value, np.full_like(x, -1.0), np.ones_like(x))

    decreasing_roots(residual, guess, lower, upper, TOLERANCE, targets)
    assert (guess == 5.0).all()
    assert (lower == -10.0).all()
    assert (upper == 10.0).all()


@pytest.mark.parametrize("gain", [1.0, 1e3, 1e6])
def test_what_is_wanted_is_as_exact_as_its_bound_says(gain):
    roots = np.linspace(-3.0, 3.0, 50)
    targets = Targets(np.exp(-roots), [])

    def residual(x, some):
        value, slope = exponential(x)
        noise = 2e-16 * np.abs(value)
        return Residual(value - some.value, slope, np.full_like(x, gain), noise)

    start = np.zeros_like(roots)
    tolerance = 1e-6
    found, width, error = decreasing_roots(
        residual, start, start - 10.0, start + 10.0, tolerance, targets
    )
    assert (gain * np.abs(found - roots) <= error).all()
    assert_allclose(error, np.expm1(gain * width))
    assert (error <= 1.01 * tolerance).all()


def test_steps_as_small_as_rounding_end_the_search():
    roots = np.array([0.1, 1.0, 3.0])
    targets = Targets(np.exp(-roots), [])

    def residual(x, some):
        value, slope = exponential(x)
        noise = 2e-16 * np.abs(value)
        return Residual(value - some.value, slope, np.full_like(x, 1e9), noise)

    start = np.zeros_like(roots)
    found, _, error = decreasing_roots(residual, start, start - 9.0, start + 9.0, 1e-9, targets)
    assert_allclose(found, roots, rtol=1e-13)
    assert (error > 1e-9).all()
