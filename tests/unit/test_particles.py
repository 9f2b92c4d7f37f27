"""Third particles: closed forms against the integrals that they stand for (Eqs. 4-6)."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.integrate import quad

from thirdbody.model.particles import ParticleLayer

pytestmark = pytest.mark.filterwarnings("error")

DIAMETER, ROUGHNESS, DENSITY = 500e-9, 300e-9, 1e11


def layer(parameters, diameter=DIAMETER, density=DENSITY):
    """Particles of one or several diameters [m] on the surface of 300 nm."""
    diameter, density = np.broadcast_arrays(np.atleast_1d(diameter), np.atleast_1d(density))
    return ParticleLayer.of(diameter, np.full(diameter.shape, ROUGHNESS), density, parameters)


def distribution(inputs, diameter=DIAMETER):
    """Mean, spread and largest size [m] of phi_a."""
    mean = 0.0 if inputs.size_distribution == "uncentred" else inputs.mean_ratio * diameter
    spread = inputs.spread_ratio * diameter
    if inputs.size_distribution == "gap_convolved":
        spread = np.hypot(spread, inputs.gap_ratio * ROUGHNESS)
    return mean, spread, mean + inputs.truncation * spread


def moment(inputs, low, high):
    """I(low, high) [m2] by numerical integration of Eq. 6."""
    mean, spread, largest = distribution(inputs)

    def integrand(z):
        square = (mean + z * spread) ** 2
        if inputs.size_distribution == "gap_convolved":
            square = (1.0 + inputs.spread_ratio**2) * DIAMETER**2
        return square / DIAMETER**2 * np.exp(-0.5 * z**2) / np.sqrt(2.0 * np.pi)

    low, high = (max((min(end, largest) - mean) / spread, -40.0) for end in (low, high))
    middle = sorted({low, high, *(z for z in (-5.0, 0.0, 1.0, 2.0, 3.0) if low < z < high)})
    pieces = zip(middle, middle[1:], strict=False)
    return DIAMETER**2 * sum(quad(integrand, *ends, epsabs=0.0, epsrel=1e-13)[0] for ends in pieces)


def share(inputs):
    """pi eta_a p/(H_s1 + H_s2) [m-2 Pa-1]."""
    hardness = inputs.hardness_surface_1 + inputs.hardness_surface_2
    return np.pi * DENSITY * inputs.participation / hardness


def separations(inputs):
    """From contact with every size to the largest ones alone [m]."""
    mean, spread, largest = distribution(inputs)
    return np.array([1e-3 * spread, 0.3 * largest, 0.6 * largest, 0.9 * largest])


def test_the_coverage_is_the_second_moment_of_the_larger_particles(sizes):
    d = separations(sizes)
    particles = layer(sizes, np.full(d.shape, DIAMETER))
    _, _, coverage, _ = particles.contact(d)
    expected = [sizes.hardness_surface_1 * share(sizes) * moment(sizes, low, np.inf) for low in d]
    # differences of two moments: rounding of the larger over the smallest, 1e-16/1e-2
    assert_allclose(coverage, expected, rtol=1e-13)


@pytest.mark.parametrize("limits", ["printed", "physical"])
def test_the_area_weighs_elastic_particles_by_the_elastic_factor(sizes, limits):
    inputs = replace(sizes, elastic_limits=limits, elastic_depth_ratio=0.0885)
    d = separations(inputs)
    area, *_ = layer(inputs, np.full(d.shape, DIAMETER)).contact(d)
    h_e = 0.0885 * DIAMETER
    shift = -h_e if limits == "printed" else 0.0
    expected = [
        inputs.hardness_surface_2
        * share(inputs)
        * (
            inputs.elastic_factor * moment(inputs, x + shift, x + shift + h_e)
            + moment(inputs, x, np.inf)
        )
        for x in d
    ]
    assert_allclose(area, expected, rtol=1e-13)


def test_the_printed_coverage_in_the_load_is_that_of_all_sizes(sizes):
    printed = replace(sizes, coverage_limits="printed")
    log_bare, slope = layer(printed).log_bare_load(np.full(1, 0.5), np.ones(1))
    if sizes.size_distribution == "gap_convolved":
        every = (1.0 + sizes.spread_ratio**2) * DIAMETER**2
    else:
        every = moment(sizes, 0.0, np.inf)
    coverage = sizes.hardness_surface_1 * share(sizes) * every
    assert_allclose(-np.expm1(log_bare), coverage, rtol=1e-12)
    assert slope == 0.0


def test_the_contacting_coverage_in_the_load_is_that_of_the_area(sizes):
    contacting = layer(replace(sizes, coverage_limits="contacting"))
    _, _, coverage, coverage_slope = contacting.contact(np.array([0.8 * DIAMETER]))
    log_bare, slope = contacting.log_bare_load(coverage, coverage_slope)
    assert_allclose(log_bare, np.log1p(-coverage), rtol=1e-12)
    assert_allclose(slope, -coverage_slope / (1.0 - coverage), rtol=1e-14)


def test_slopes_are_those_of_the_values(reading):
    _, _, largest = distribution(reading)
    d = np.linspace(0.05, 0.95, 19) * largest
    step = 1e-5 * largest
    particles = layer(reading, np.full(d.shape, DIAMETER))
    upper, lower = particles.contact(d + step), particles.contact(d - step)
    values = particles.contact(d)
    for value in (0, 2):
        slope = (upper[value] - lower[value]) / (2.0 * step)
        # the step squared times the third derivative, and rounding over the step
        assert_allclose(values[value + 1], slope, rtol=1e-7, atol=1e-9 * np.abs(slope).max())


def test_no_particle_touches_beyond_the_largest(reading):
    largest = layer(reading).reach
    d = largest * np.array([1.0 + 1e-12, 2.0, 1e6])
    particles = layer(reading, np.full(d.shape, DIAMETER))
    for value in particles.contact(d):
        assert (value == 0.0).all()


def test_contact_begins_without_a_jump_at_the_largest_particle(sizes):
    _, spread, largest = distribution(sizes)
    d = largest - spread * np.array([1e-2, 1e-4, 1e-6])
    _, _, coverage, _ = layer(sizes, np.full(3, DIAMETER)).contact(d)
    # linear in the distance from the largest size, to the first order of it
    assert_allclose(coverage[:2] / coverage[1:], 100.0, rtol=0.05)


def test_area_and_coverage_are_proportional_to_the_density(reading):
    d = np.full(3, DIAMETER)
    values = layer(reading, DIAMETER, np.array([1e9, 1e11, 1e13])).contact(d)
    for value in values:
        assert_allclose(value / value[1], [1e-2, 1.0, 1e2], rtol=1e-14)


def test_particles_of_all_sizes_look_alike_in_units_of_their_diameter(parameters):
    diameter = np.array([1e-12, 1e-9, 1e-6, 1e-4])
    for distribution_name in ("uncentred", "centred"):
        inputs = replace(parameters, size_distribution=distribution_name, mean_ratio=0.5)
        area, _, coverage, _ = layer(inputs, diameter).contact(0.7 * diameter)
        for value in (area, coverage):
            assert_allclose(value / diameter**2, value[0] / diameter[0] ** 2, rtol=1e-13)


def test_particles_bear_more_the_larger_they_are_and_the_narrower_the_gap(parameters):
    # provable for the uncentred reading with the printed limits: the moment is x_a^2 g(d/x_a)
    # with a falling g
    diameter = np.linspace(0.1, 1.0, 50) * 1e-6
    by_size, *_ = layer(parameters, diameter).contact(np.full(50, 100e-9))
    assert (np.diff(by_size) > 0.0).all()
    d = np.linspace(0.0, 0.99, 50) * distribution(parameters)[2]
    by_gap, slope, *_ = layer(parameters, np.full(50, DIAMETER)).contact(d)
    assert (np.diff(by_gap) < 0.0).all()
    assert (slope[1:] < 0.0).all()


def test_a_centred_distribution_about_zero_is_the_uncentred_one(parameters):
    d = np.linspace(0.0, 2.0, 9) * DIAMETER
    diameter = np.full(9, DIAMETER)
    centred = replace(parameters, size_distribution="centred", mean_ratio=0.0)
    for one, other in zip(
        layer(parameters, diameter).contact(d), layer(centred, diameter).contact(d), strict=True
    ):
        assert_allclose(one, other, rtol=1e-15)


def test_a_layer_of_chosen_points_is_the_layer_made_of_them(reading):
    diameter = np.linspace(1e-7, 1e-6, 7)
    chosen = np.array([5, 0, 3])
    d = diameter[chosen]
    taken, made = layer(reading, diameter).take(chosen), layer(reading, diameter[chosen])
    for one, other in zip(taken.contact(d), made.contact(d), strict=True):
        assert np.array_equal(one, other)
