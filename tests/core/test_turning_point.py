"""Turning points and their windows against brute scans of dense load grids."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

import thirdbody as tb
from thirdbody.core.turning_points import PROMINENCE, turning_points
from thirdbody.core.windows import WindowSearch, turning_point_windows
from thirdbody.curves import Condition

pytestmark = pytest.mark.filterwarnings("error")

NANOMETRE = 1e-9
VISCOSITIES = np.array([0.0, 25e-6, 50e-6, 70e-6, 90e-6, 120e-6])
DENSITY = 1e11


def curves(viscosity, diameter, roughness=300e-9, density=DENSITY):
    """Conditions of curves, broadcast to 1-D arrays of one length."""
    given = (viscosity, diameter, roughness, density)
    return [np.array(a, dtype=float) for a in np.broadcast_arrays(*map(np.atleast_1d, given))]


def solved(loads, conditions, parameters, rtol=1e-9):
    given = Condition(*conditions)._asdict()
    return tb.solve(load=loads[:, None], **given, parameters=parameters, rtol=rtol)


def found_on(loads, conditions, parameters):
    separation = solved(loads, conditions, parameters).separation
    return turning_points(separation, *conditions, parameters)


def odds_at(loads, conditions, parameters):
    """A_sa,t*/A_ss,t*, which keeps its digits also where the ratio is 1."""
    solution = solved(loads, conditions, parameters, rtol=1e-11)
    return solution.particle_contact_area_ratio / solution.surface_contact_area_ratio


def inner_maxima(values):
    """Whether each inner value of each column is above its neighbours."""
    return (values[1:-1] > values[:-2]) & (values[1:-1] >= values[2:])


def test_a_brute_scan_of_loads_finds_the_same_maximum(interpretation, loads):
    equal_sizes = curves(VISCOSITIES, 300.0 * NANOMETRE)  # those of Figure 11
    found = found_on(loads, equal_sizes, interpretation)
    dense = np.geomspace(loads[0], loads[-1], 2001)
    odds = odds_at(dense, equal_sizes, interpretation)
    highest = np.where(inner_maxima(odds), odds[1:-1], 0.0)
    has_one = (highest > 0.0).any(axis=0)
    assert has_one.any()
    assert np.array_equal(np.isfinite(found.load), has_one)
    best = np.argmax(highest, axis=0)[has_one] + 1
    assert (dense[best - 1] < found.load[has_one]).all()
    assert (found.load[has_one] < dense[best + 1]).all()
    peak = found.peak_ratio[has_one]
    assert (highest.max(axis=0)[has_one] <= peak / (1.0 - peak) * (1.0 + 1e-9)).all()


def prominence(loads, conditions, parameters):
    """How far the ratio of each curve is above both some smaller and some larger load, at most."""
    ratio = solved(loads, conditions, parameters, rtol=1e-11).particle_contact_area_ratio
    before = ratio - np.minimum.accumulate(ratio)
    after = ratio - np.minimum.accumulate(ratio[::-1])[::-1]
    return np.minimum(before, after).max(axis=0)


@pytest.mark.parametrize("count", [40, 241])
def test_how_far_a_maximum_stands_out_is_what_a_brute_scan_says(sizes, count):
    diameter = np.array([180.0, 250.0, 300.0, 350.0, 450.0]) * NANOMETRE
    conditions = curves(0.0, diameter)
    few, many = (np.geomspace(1e-7, 1e-4, each) for each in (count, 4001))
    found = found_on(few, conditions, sizes)
    height = prominence(many, conditions, sizes)
    assert_allclose(np.nan_to_num(found.prominence), height, atol=1e-5)
    assert np.array_equal(found.exists, height >= PROMINENCE)


def test_of_several_maxima_the_one_that_stands_out_most_is_the_turning_point(parameters):
    # large particles touch first, and yield under heavier loads
    sizes = dict(mean_ratio=0.4536, spread_ratio=0.3677, truncation=3.608, participation=0.841)
    inputs = replace(parameters, elastic_depth_ratio=0.3354, **sizes)
    loads = np.geomspace(1e-7, 1e-4, 400)
    conditions = curves(0.0, 700.0 * NANOMETRE, 300.0 * NANOMETRE, 3.077e11)
    odds = odds_at(loads, conditions, inputs)
    maxima = np.where(inner_maxima(odds), odds[1:-1], 0.0)
    assert np.count_nonzero(maxima) == 2
    found = found_on(loads, conditions, inputs)
    best = np.argmax(maxima) + 1
    assert loads[best - 1] < found.load[0] < loads[best + 1]
    assert_allclose(found.peak_ratio, maxima.max() / (1.0 + maxima.max()), rtol=1e-4)


@pytest.mark.parametrize(("diameter", "density"), [(0.0, DENSITY), (3e-7, 0.0)])
def test_two_body_curves_have_no_turning_point(parameters, loads, diameter, density):
    found = found_on(loads, curves(VISCOSITIES, diameter, 3e-7, density), parameters)
    assert np.isnan(found.load).all()


def test_a_maximum_among_unsolved_points_is_not_invented(parameters, loads):
    conditions = curves(0.0, 300.0 * NANOMETRE)
    found = found_on(loads, conditions, parameters)
    separation = solved(loads, conditions, parameters).separation
    separation[np.abs(np.log(loads / found.load)) < 0.5] = np.nan
    assert np.isnan(turning_points(separation, *conditions, parameters).load).all()


@pytest.fixture
def window_over(parameters, loads):
    """Function that searches the window of a surface over ratios of sizes to the roughness."""

    def search(ratios, roughness=300e-9):
        given = WindowSearch(ratios), [roughness], DENSITY, (loads[0], loads[-1]), parameters
        return turning_point_windows(*given)[0]

    return search


@pytest.mark.parametrize("roughness", [100e-9, 300e-9, 500e-9])
def test_the_ends_of_a_window_are_those_of_a_brute_scan(parameters, loads, window_over, roughness):
    window = window_over(np.linspace(0.3, 2.5, 56), roughness)
    assert max(window.low_error, window.high_error) < 1e-6
    assert 0.3 < window.low < window.high < 2.5
    # the scan misses the peak by 4e-7 in its logarithm, which moves an end by some 1e-8
    beside = np.add.outer([window.low, window.high], [-1e-6, 1e-6]).ravel()
    dense = np.geomspace(loads[0], loads[-1], 4001)
    heights = prominence(dense, curves(0.0, beside * roughness, roughness), parameters)
    turning = heights > PROMINENCE
    assert turning.tolist() == [False, True, True, False]


def test_a_sweep_that_starts_inside_the_window_says_that_its_end_is_unknown(window_over):
    whole, part = (window_over(np.linspace(first, 2.5, 45)) for first in (0.3, 1.0))
    assert whole.low < 1.0 == part.low
    assert part.low_error == np.inf
    assert abs(part.high - whole.high) <= part.high_error + whole.high_error


def test_without_a_turning_point_there_is_no_window(window_over):
    window = window_over(np.linspace(0.01, 0.1, 10))
    assert all(np.isnan([window.low, window.low_error, window.high, window.high_error]))


@pytest.mark.parametrize(("first", "ends"), [(0.3, (0.417, 1.176)), (1.15, (1.325, 1.467))])
def test_of_two_runs_of_sizes_the_longer_is_the_window(parameters, first, ends):
    sizes = dict(spread_ratio=0.4, truncation=4.0, participation=0.5)
    inputs = replace(parameters, elastic_depth_ratio=2.875, **sizes)
    search = WindowSearch(np.arange(first, 2.5, 0.05), prominence=0.002)
    (window,) = turning_point_windows(search, [500e-9], 1e12, (1e-6, 1e-2), inputs)
    assert_allclose([window.low, window.high], ends, atol=1e-3)


def test_a_load_that_dry_surfaces_do_not_carry_leaves_the_window(defaults):
    surfaces = dict(roughness_nm=[100, 300], particle_density_per_m2=[1e11, 1e11])
    carried, more = (
        tb.turning_window(**surfaces, between_N=(0.01, last), parameters=defaults)
        for last in (800.0, 10_000.0)
    )
    assert carried.notna().all(axis=None)
    assert_allclose(more[["low", "high"]], carried[["low", "high"]], rtol=1e-3)
    none = tb.turning_window(**surfaces, between_N=(8_000.0, 10_000.0), parameters=defaults)
    assert none[["low", "high"]].isna().all(axis=None)
