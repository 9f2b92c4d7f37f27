"""What is known at a given separation, against Eqs. 2, 4 and 5 and against differences."""

from dataclasses import dataclass

import numpy as np
import pytest
from numpy.testing import assert_allclose

from thirdbody.curves.turning_point import odds_slope
from thirdbody.model.contact import Contact
from thirdbody.model.particles import ParticleLayer
from thirdbody.solver.summits import RoughSurfaces

pytestmark = pytest.mark.filterwarnings("ignore:.*encountered in:RuntimeWarning")  # ln of zero

ROUGHNESS = 300e-9
SEPARATION = np.linspace(0.2, 6.0, 40) * ROUGHNESS


@dataclass
class ExponentialSummits:
    """Summits whose load and area fall off as exponentials, with numbers made up for them."""

    offset: float = 1e-7
    deviation: float = 2e-7

    def log_load(self, t):
        return -3.0 - 2.0 * t, np.full_like(t, -2.0)

    def log_load_and_area(self, t):
        return self.log_load(t), (-1.0 - 1.5 * t, np.full_like(t, -1.5))

    def take(self, chosen):
        return self


def areas(contact, separation):
    """A_sa/A_n and ln(A_ss-sa/A_n)."""
    state = contact.log_solid_load(separation, with_areas=True)
    return state.area, state.log_beside


@pytest.fixture
def layer(reading):
    """Particles of one mean diameter, which touch at some of the separations or at all."""
    same = np.ones_like(SEPARATION)
    return ParticleLayer.of(500e-9 * same, ROUGHNESS * same, 1e11 * same, reading)


@pytest.fixture
def contact(layer, reading):
    return Contact(ExponentialSummits(), layer, reading)


def test_the_solids_bear_what_summits_and_particles_bear(contact, layer, reading):
    area, _, *coverage = layer.contact(SEPARATION)
    summits = np.exp(-3.0 - 2.0 * (SEPARATION - 1e-7) / 2e-7)
    beside = summits * np.exp(layer.log_bare_load(*coverage)[0])  # Eq. 4
    particles = area * reading.hardness_surface_1 / reading.elastic_modulus_surfaces  # Eqs. 4, 5
    load = contact.log_solid_load(SEPARATION)
    assert_allclose(np.exp(load.value), beside + particles, rtol=1e-12)  # Eq. 2
    assert (particles > 0.1 * beside).any() and (particles < beside).any()


def test_summits_touch_beside_the_particles(contact, layer):
    area, _, coverage, _ = layer.contact(SEPARATION)
    summits = np.exp(-1.0 - 1.5 * (SEPARATION - 1e-7) / 2e-7)
    particles, log_summits = areas(contact, SEPARATION)
    assert np.array_equal(particles, area)
    assert_allclose(np.exp(log_summits), summits * (1.0 - coverage), rtol=1e-12)  # Eq. 5


def test_slopes_are_those_of_differences(contact):
    step = 1e-6 * ROUGHNESS
    beside = SEPARATION + step, SEPARATION - step
    slope = contact.log_solid_load(SEPARATION).slope
    loads = [contact.log_solid_load(separation).value for separation in beside]
    smooth = np.abs(SEPARATION - contact.particles.reach) > 2.0 * step
    assert_allclose(slope[smooth], ((loads[0] - loads[1]) / (2.0 * step))[smooth], rtol=1e-5)
    logarithms = []
    for separation in beside:
        particles, log_summits = areas(contact, separation)
        logarithms.append(np.log(particles) - log_summits)
    area, _ = areas(contact, SEPARATION)
    touching = smooth & (area > 0.0)
    expected = area * (logarithms[0] - logarithms[1]) / (2.0 * step)
    assert_allclose(odds_slope(contact, SEPARATION)[touching], expected[touching], rtol=1e-4)


def test_no_part_of_load_or_area_is_steeper_than_the_steepest(contact):
    step = 1e-6 * ROUGHNESS
    near, far = areas(contact, SEPARATION - step), areas(contact, SEPARATION + step)
    load = contact.log_solid_load(SEPARATION)
    smooth = np.abs(SEPARATION - contact.particles.reach) > 2.0 * step
    logarithms = [(np.log(particles), summits) for particles, summits in (near, far)]
    for closer, farther in zip(*logarithms, strict=True):
        known = smooth & np.isfinite(closer) & np.isfinite(farther)
        slope = (np.abs(closer - farther) / (2.0 * step))[known]
        assert (slope <= load.steepest[known] * (1.0 + 1e-4)).all()
    assert (np.abs(load.slope) <= load.steepest * (1.0 + 1e-12)).all()


def test_without_particles_summits_are_all_there_is(reading):
    alone = Contact(ExponentialSummits(), None, reading)
    load = alone.log_solid_load(SEPARATION)
    assert np.array_equal(load.value, -3.0 - 2.0 * alone.summit_separation(SEPARATION))
    assert np.array_equal(load.slope, -load.steepest)
    particles, log_summits = areas(alone, SEPARATION)
    assert not particles.any()
    assert np.array_equal(log_summits, -1.0 - 1.5 * alone.summit_separation(SEPARATION))


def test_some_points_are_what_they_are_among_all(layer, reading):
    roughness = np.where(np.arange(SEPARATION.size) % 2, ROUGHNESS, 2.0 * ROUGHNESS)
    contact = Contact(RoughSurfaces.of(roughness, reading, 1e-9), layer, reading)
    every = contact.log_solid_load(SEPARATION)
    chosen = np.arange(SEPARATION.size) % 3 == 0
    some = contact.take(chosen).log_solid_load(SEPARATION[chosen])
    for one, other in zip(some[:5], every[:5], strict=True):
        assert np.array_equal(one, other[chosen])
