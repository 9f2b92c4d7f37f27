"""Turning points against brute scans of dense load grids."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

import thirdbody as tb
from thirdbody.curves.turning_point import PROMINENCE, film_turning_points, turning_points
from thirdbody.data.conditions import Condition

pytestmark = pytest.mark.filterwarnings("error")

NANOMETRE = 1e-9
VISCOSITIES = np.array([0.0, 25e-6, 50e-6, 70e-6, 90e-6, 120e-6])
DENSITY = 1e11


def curves(viscosity, diameter, roughness=300e-9, density=DENSITY):
    """Conditions of curves, broadcast to 1-D arrays of one length."""
    given = (viscosity, diameter, roughness, density)
    return [np.array(a, dtype=float) for a in np.broadcast_arrays(*map(np.atleast_1d, given))]


def found_on(loads, conditions, parameters, rtol=1e-9):
    separation = tb.solve(
        load=loads[:, None], **Condition(*conditions)._asdict(), parameters=parameters, rtol=rtol
    ).separation
    return turning_points(separation, *conditions, parameters, rtol)


def odds_at(load, conditions, parameters):
    """A_sa,t*/A_ss,t*, which keeps its digits also where the ratio is 1."""
    solution = tb.solve(
        load=load, **Condition(*conditions)._asdict(), parameters=parameters, rtol=1e-11
    )
    return solution.particle_contact_area_ratio / solution.surface_contact_area_ratio


def inner_maxima(values):
    """Whether each inner value of each column is above its neighbours."""
    return (values[1:-1] > values[:-2]) & (values[1:-1] >= values[2:])


@pytest.fixture(scope="module")
def equal_sizes():
    """The curves of Figure 11: sigma = x_a = 300 nm, dry and with six lubricants."""
    return curves(VISCOSITIES, 300.0 * NANOMETRE)


def test_a_brute_scan_of_loads_finds_the_same_maximum(interpretation, loads, equal_sizes):
    found = found_on(loads, equal_sizes, interpretation)
    dense = np.geomspace(loads[0], loads[-1], 2001)
    odds = odds_at(dense[:, None], equal_sizes, interpretation)
    highest = np.where(inner_maxima(odds), odds[1:-1], 0.0)
    has_one = (highest > 0.0).any(axis=0)
    assert has_one.any()
    assert np.array_equal(np.isfinite(found.load), has_one)
    best = np.argmax(highest, axis=0)[has_one] + 1
    assert (dense[best - 1] < found.load[has_one]).all()
    assert (found.load[has_one] < dense[best + 1]).all()
    peak = found.peak_ratio[has_one]
    assert (highest.max(axis=0)[has_one] <= peak / (1.0 - peak) * (1.0 + 1e-9)).all()


@pytest.mark.parametrize("count", [40, 241])
def test_how_far_a_maximum_stands_out_is_what_a_brute_scan_says(sizes, count):
    diameter = np.array([180.0, 250.0, 300.0, 350.0, 450.0]) * NANOMETRE
    conditions = curves(0.0, diameter)
    few, many = (np.geomspace(1e-7, 1e-4, each) for each in (count, 4001))
    found = found_on(few, conditions, sizes)
    ratio = tb.solve(
        load=many[:, None], **Condition(*conditions)._asdict(), parameters=sizes
    ).particle_contact_area_ratio
    before = ratio - np.minimum.accumulate(ratio)
    after = ratio - np.minimum.accumulate(ratio[::-1])[::-1]
    height = np.minimum(before, after).max(axis=0)
    assert_allclose(np.nan_to_num(found.prominence), height, atol=1e-5)
    assert np.array_equal(found.exists, height >= PROMINENCE)


def test_of_several_maxima_the_one_that_stands_out_most_is_the_turning_point(parameters):
    # large particles touch first; the summits that they cover are missing under heavy loads
    inputs = replace(
        parameters,
        size_distribution="centred",
        mean_ratio=0.4726,
        spread_ratio=0.3146,
        truncation=3.147,
        coverage_limits="contacting",
        elastic_depth_ratio=0.2,
        participation=0.178,
    )
    loads = np.geomspace(1e-7, 1e-4, 400)
    conditions = curves(0.0, 830.0 * NANOMETRE, 300.0 * NANOMETRE, 1.89e11)
    odds = odds_at(loads[:, None], conditions, inputs)
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
    separation = tb.solve(
        load=loads[:, None], **Condition(*conditions)._asdict(), parameters=parameters
    ).separation
    separation[np.abs(np.log(loads / found.load)) < 0.5] = np.nan
    assert np.isnan(turning_points(separation, *conditions, parameters).load).all()


# ---- windows


def test_films_together_have_the_turning_points_that_their_curves_have(interpretation, loads):
    diameters = np.append(np.geomspace(60.0, 1200.0, 25), 0.0) * NANOMETRE
    solids = curves(0.0, diameters)[1:]
    separation = tb.solve(
        load=loads[:, None, None],
        viscosity=VISCOSITIES[:, None],
        particle_diameter=diameters,
        roughness=300e-9,
        particle_density=DENSITY,
        parameters=interpretation,
        rtol=1e-6,
        variables=["separation"],
    ).separation
    together = film_turning_points(separation, VISCOSITIES, *solids, interpretation, 1e-6)
    assert together.exists.any() and not together.exists[:, -1].any()
    for film, viscosity in enumerate(VISCOSITIES):
        conditions = curves(viscosity, diameters)
        alone = turning_points(separation[:, film], *conditions, interpretation, 1e-6)
        there = together.exists[film]
        assert np.array_equal(there, alone.exists)
        for name in ("load", "peak_ratio", "solid_load_fraction", "separation", "prominence"):
            one, other = (getattr(each, name) for each in (together, alone))
            assert_allclose(one[film][there], other[there], rtol=1e-4, err_msg=name)
        assert np.isnan(together.load[film][~there]).all()
