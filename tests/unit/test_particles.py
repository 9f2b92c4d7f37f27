"""Third particles: closed forms against the integrals that they stand for (Eqs. 4-6)."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from thirdbody.data.model_attribute import model_attribute
from thirdbody.model.particles import Moment, ParticleLayer

pytestmark = pytest.mark.filterwarnings("error")

DIAMETER, ROUGHNESS, DENSITY = 500e-9, 300e-9, 1e11


def layer(parameters, diameter=DIAMETER, density=DENSITY):
    """Particles of one or several diameters [m] on the surface of 300 nm."""
    diameter, density = np.broadcast_arrays(np.atleast_1d(diameter), np.atleast_1d(density))
    return ParticleLayer.of(diameter, np.full(diameter.shape, ROUGHNESS), density, parameters)


@pytest.fixture(scope="module")
def plain(equations):
    """Makes the plain equations of ``count`` equal points of these particles."""

    def make(inputs, count=1):
        attribute = model_attribute(inputs, [ROUGHNESS])
        points = np.full(count, DIAMETER), np.full(count, DENSITY)
        return equations(attribute, 0, ROUGHNESS, *points)

    return make


def separations(again):
    """From contact with every size to the largest ones alone [m]."""
    spread, largest = again.spread[0], again.largest[0]
    return np.array([1e-3 * spread, 0.3 * largest, 0.6 * largest, 0.9 * largest])


def test_the_coverage_is_the_second_moment_of_the_larger_particles(sizes, plain):
    again = plain(sizes)
    d = separations(again)
    _, _, coverage, _ = layer(sizes, np.full(d.shape, DIAMETER)).contact(d)
    # differences of two moments: rounding of the larger over the smallest, 1e-16/1e-2
    assert_allclose(coverage, again.coverage(d), rtol=1e-13)


@pytest.mark.parametrize("limits", ["printed", "physical"])
def test_the_area_weighs_elastic_particles_by_the_elastic_factor(sizes, plain, limits):
    inputs = replace(sizes, elastic_limits=limits, elastic_depth_ratio=0.0885)
    again = plain(inputs)
    d = separations(again)
    area, *_ = layer(inputs, np.full(d.shape, DIAMETER)).contact(d)
    assert_allclose(area, again.particle_area(d), rtol=1e-13)


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


def test_particles_of_all_sizes_look_alike_in_units_of_their_diameter(parameters):
    diameter = np.array([1e-12, 1e-9, 1e-6, 1e-4])
    for distribution_name in ("uncentred", "centred"):
        inputs = replace(parameters, size_distribution=distribution_name, mean_ratio=0.5)
        area, _, coverage, _ = layer(inputs, diameter).contact(0.7 * diameter)
        for value in (area, coverage):
            assert_allclose(value / diameter**2, value[0] / diameter[0] ** 2, rtol=1e-13)


def test_particles_bear_more_the_larger_they_are_and_the_narrower_the_gap(parameters, plain):
    # provable for the uncentred reading with the printed limits: the moment is x_a^2 g(d/x_a)
    # with a falling g
    diameter = np.linspace(0.1, 1.0, 50) * 1e-6
    by_size, *_ = layer(parameters, diameter).contact(np.full(50, 100e-9))
    assert (np.diff(by_size) > 0.0).all()
    d = np.linspace(0.0, 0.99, 50) * plain(parameters).largest
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
