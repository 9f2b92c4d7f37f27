"""Random points over the physical domain and all interpretations: the equations hold at every
one."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose

import thirdbody as tb
from thirdbody.core.contact import Contact
from thirdbody.core.regimes import FILM_COUNTS, SOLUTION_STATUSES, contact_mode, lubrication_regime
from thirdbody.netcdf import model_attribute
from thirdbody.variables import QUANTITIES

pytestmark = [
    pytest.mark.filterwarnings("error"),
    pytest.mark.filterwarnings("ignore::thirdbody.OutOfRangeWarning"),
]

RTOL = 1e-9
_, OUTSIDE, COVERED, FAILED, WIDE, EXCEEDED = range(len(SOLUTION_STATUSES))
POINTS = 40  # of each example, on one surface
# solved fractions below it have underflowed
UNDERFLOW = 1e-280


def bounded(examples):
    """Always the same examples, on a machine of any speed."""
    return settings(max_examples=examples, deadline=None, derandomize=True, database=None)


def between(low, high):
    """Floats spread evenly in their logarithm."""
    return st.floats(np.log(low), np.log(high)).map(lambda x: float(np.clip(np.exp(x), low, high)))


def elastic_factor(inputs):
    """Of Eqs. 4 and 5, for hardnesses and moduli by name."""
    particle = inputs["hardness_surface_1"] / inputs["elastic_modulus_particle"]
    surface = inputs["hardness_surface_2"] / inputs["elastic_modulus_surfaces"]
    return 2.25 * np.pi**2 * (particle**2 + surface**2)


INTERPRETATIONS = st.fixed_dictionaries(
    {
        "particle_plane": st.sampled_from(["surface", "summit"]),
        "film_load": st.sampled_from(["fluid", "total"]),
        "summit_deviation_ratio": st.floats(0.3, 3.0),
        "summit_offset_ratio": st.one_of(st.just(0.0), st.floats(0.0, 3.0)),
        "hardness_surface_1": between(1e9, 2e10),
        "hardness_surface_2": between(1e9, 2e10),
        "elastic_modulus_surfaces": between(5e10, 5e11),
        "elastic_modulus_particle": between(5e10, 5e11),
        "yield_pressure_ratio": st.floats(0.1, 1.0),
        "plastic_interference_ratio": between(1.001, 1e3),
        "summit_parameter": between(0.025, 5.0),
        "summit_parameter_exponent": st.just(0.0),
        "summit_radius": between(1e-6, 1e-3),
        "mean_ratio": st.one_of(st.just(0.0), st.floats(0.0, 2.0)),
        "spread_ratio": st.floats(0.05, 3.0),
        "truncation": st.floats(0.5, 10.0),
        "participation": between(1e-3, 1.0),
        "elastic_depth_ratio": st.floats(0.0, 0.1),
        "ellipticity": between(0.1, 10.0),
        "apparent_area": between(1.1e-7, 7.1e-6),
    }
).filter(lambda inputs: elastic_factor(inputs) <= 1.0)
# load, viscosity, diameter, density in the unit interval
RANDOM_POINTS = st.integers(0, 2**32 - 1).map(
    lambda seed: np.random.default_rng(seed).random((4, POINTS))
)


def conditions(unit):
    """Conditions from numbers between 0 and 1; low ones mean none."""
    load, viscosity, diameter, density = unit
    return {
        "load": 10.0 ** (-9.0 + 8.0 * load),
        "viscosity": np.where(viscosity < 0.25, 0.0, 10.0 ** (-8.0 + 5.0 * viscosity)),
        "particle_diameter": np.where(diameter < 0.1, 0.0, 10.0 ** (-9.0 + 3.5 * diameter)),
        "particle_density": np.where(density < 0.1, 0.0, 10.0 ** (9.0 + 3.7 * density)),
    }


def greatest_roughness_term(inputs):
    """What the roughness term of Eq. 7 is where H_c is least over the speed."""
    speed = 0.663 * inputs.ellipticity**0.025
    return speed / (0.884 - speed)


class Solved:
    """Points on one surface, their solution, and the equations written a second time."""

    def __init__(self, parameters, equations, changes, roughness, unit):
        self.inputs, given = replace(parameters, **changes), conditions(unit)
        self.load, self.viscosity, self.diameter, self.density = given.values()
        self.three_body = (self.diameter > 0.0) & (self.density > 0.0)
        given |= {"roughness": roughness, "parameters": self.inputs, "rtol": RTOL}
        self.solution = tb.solve(**given)
        model = model_attribute(self.inputs, np.array([roughness]))
        self.status = self.solution.solution_status.astype(int)
        self.known = np.isfinite(self.solution.error_bound)
        self.equations_of = lambda points: equations(
            model, 0, roughness, self.diameter[points], self.density[points]
        )
        self.again = self.equations_of(self.known)

    def __getattr__(self, name):
        """Values of the solved points."""
        return getattr(self.solution, name)[self.known]

    def assert_balanced(self, function, value):
        """``function(d)`` is ``value`` but for errors of RTOL in d and in the value itself."""
        d = self.separation
        with np.errstate(under="ignore"):
            sides = function(d), function(d * (1.0 + RTOL)), function(d * (1.0 - RTOL))
        allowed = RTOL * np.abs(sides[0]) + np.abs(sides[1] - sides[2])
        wrong = ~(np.abs(sides[0] - value) <= allowed) & (value > UNDERFLOW)
        assert not wrong.any(), (self.load[self.known][wrong], value[wrong], sides[0][wrong])


@pytest.fixture(scope="session")
def solved(parameters, equations):
    return lambda *given: Solved(parameters, equations, *given)


DOMAIN = {"changes": INTERPRETATIONS, "roughness": between(1e-9, 1e-5), "unit": RANDOM_POINTS}


@given(**DOMAIN)
@bounded(80)
def test_the_equations_hold_at_every_solved_point(solved, changes, roughness, unit):
    points = solved(changes, roughness, unit)
    assert_solids_bear_their_share(points)
    assert_film_is_as_thick_as_the_gap(points)
    assert_areas_are_those_of_the_separation(points)
    assert_shares_sum_to_one_and_flags_agree(points)
    assert_what_is_absent_bears_nothing(points)


def assert_solids_bear_their_share(points):
    share = points.solid_load_fraction * points.load[points.known]
    points.assert_balanced(points.again.solid_load, share)


def assert_film_is_as_thick_as_the_gap(points):
    load, viscosity = points.load[points.known], points.viscosity[points.known]
    in_film = load if points.inputs.film_load == "total" else points.fluid_load_fraction * load
    wet = (viscosity > 0.0) & (in_film > UNDERFLOW) & (points.fluid_load_fraction > 0.0)
    thickness, rough = points.again.film(in_film[wet], viscosity[wet])
    # the load's error enters H_c with a power of at most 0.3 for any ellipticity
    assert_allclose(points.film_thickness[wet], thickness, rtol=1.3 * RTOL)
    limit = greatest_roughness_term(points.inputs)
    status, share = points.status[points.known][wet], points.fluid_load_fraction[wet]
    # too wide an area and too large an error outrank where the film is
    clear = (np.abs(rough / limit - 1.0) > 1e-6) & ~np.isin(status, [FAILED, WIDE])
    clear &= (np.abs(thickness / 0.01 - 1.0) > 1e-6) & (np.abs(share / FILM_COUNTS - 1.0) > 1e-6)
    softer = min(points.inputs.hardness_surface_1, points.inputs.hardness_surface_2)
    pressure = in_film[wet] * points.inputs.elastic_modulus_surfaces / softer
    clear &= np.abs(pressure - 1.0) > 1e-6
    meaningless = (rough > limit) | (thickness > 0.01) | (pressure > 1.0)
    outside = meaningless & (share > FILM_COUNTS)
    assert np.array_equal((status == OUTSIDE)[clear], outside[clear])


def assert_areas_are_those_of_the_separation(points):
    names = "total_contact_area", "particle_contact_area_ratio", "surface_contact_area_ratio"
    for index, name in enumerate(names):
        points.assert_balanced(lambda d, i=index: points.again.areas(d)[i], getattr(points, name))


def assert_shares_sum_to_one_and_flags_agree(points):
    # two roundings of numbers up to 1
    ratios = points.particle_contact_area_ratio + points.surface_contact_area_ratio
    assert_allclose(ratios, 1.0, rtol=4e-16)
    assert_allclose(points.solid_load_fraction + points.fluid_load_fraction, 1.0, rtol=4e-16)
    film = points.separation / points.inputs.ball_radius
    assert_allclose(points.film_thickness, film, rtol=4e-16)
    regime = lubrication_regime(points.solid_load_fraction)
    assert np.array_equal(points.lubrication_regime.astype(int), regime)
    mode = contact_mode(points.particle_contact_area_ratio, points.three_body[points.known])
    assert np.array_equal(points.contact_mode.astype(int), mode)


def assert_what_is_absent_bears_nothing(points):
    dry, two_body = points.viscosity[points.known] == 0.0, ~points.three_body[points.known]
    assert (points.solid_load_fraction[dry] == 1.0).all()
    assert (points.fluid_load_fraction[dry] == 0.0).all()
    assert OUTSIDE not in points.status[points.known][dry]
    assert (points.particle_contact_area_ratio[two_body] == 0.0).all()
    assert (points.surface_contact_area_ratio[two_body] == 1.0).all()
    assert (points.contact_mode[two_body] == "two_body").all()


@given(**DOMAIN)
@bounded(60)
def test_every_nan_has_a_status_and_every_status_a_reason(solved, changes, roughness, unit):
    points = solved(changes, roughness, unit)
    there = np.isfinite(points.solution.separation)  # also where no bound is known
    for name in QUANTITIES:
        values = getattr(points.solution, name)
        assert np.array_equal(np.isfinite(values), there), name
        assert (values[there] >= 0.0).all(), name
    unsolved = ~there
    again = points.equations_of(unsolved)
    closed = np.zeros(unsolved.sum())
    covered = again.coverage() >= 1.0 - 1e-9
    overloaded = again.solid_load(closed) <= points.load[unsolved] * (1.0 + RTOL)
    dry = points.viscosity[unsolved] == 0.0
    if points.inputs.film_load == "total":
        dry = np.ones_like(dry)  # a film thinner than the dry gap bears nothing
    imprecise = (points.status == FAILED) & there
    assert np.array_equal(points.solution.error_bound > RTOL, imprecise)
    status = points.status[unsolved]
    assert covered[status == COVERED].all()
    assert (overloaded & dry | covered)[status == EXCEEDED].all()
    assert set(status) <= {COVERED, EXCEEDED}


@given(**DOMAIN)
@bounded(40)
def test_a_heavier_load_brings_the_surfaces_closer(solved, changes, roughness, unit):
    unit = np.repeat(unit[:, :1], POINTS, axis=1)
    unit[0] = np.linspace(0.0, 1.0, POINTS)
    points = solved(changes, roughness, unit)
    assert (np.diff(points.separation) < 0.0).all()
    # and a load that closes the gap is exceeded by every heavier one
    assert (np.diff(points.known.astype(int)) <= 0).all() or points.known.all()


@given(**DOMAIN)
@bounded(40)
def test_a_thicker_film_parts_the_surfaces_and_relieves_the_solids(
    solved, changes, roughness, unit
):
    unit = np.repeat(unit[:, :1], POINTS, axis=1)
    unit[1] = np.linspace(0.5, 1.0, POINTS)
    points = solved(changes, roughness, unit)
    total = points.inputs.film_load == "total"
    in_film = (1.0 if total else points.fluid_load_fraction) * points.load[points.known]
    _, rough = points.again.film(np.maximum(in_film, UNDERFLOW), points.viscosity[points.known])
    rising = points.solution.error_bound <= RTOL
    rising[points.known] &= rough < greatest_roughness_term(points.inputs)  # H_c with viscosity
    separation = points.solution.separation[rising]
    # neighbours may both be at the dry separation, where the film bears nothing
    assert (np.diff(separation) >= -2.0 * RTOL * separation[1:]).all()
    shares = points.solution.solid_load_fraction[rising]
    assert (np.diff(shares) <= 2.0 * RTOL * shares[1:] + UNDERFLOW).all()


@given(**DOMAIN)
@bounded(80)
def test_solids_bear_less_the_farther_the_surfaces_are_apart(solved, changes, roughness, unit):
    """Up to the greatest elastic factor that is allowed: one separation balances a load."""
    points = solved(changes, roughness, unit[:, :1])
    softer = np.sqrt(points.inputs.elastic_factor) * (1.0 + 1e-15)
    moduli = ("elastic_modulus_particle", "elastic_modulus_surfaces")
    softest = replace(points.inputs, **{each: changes[each] * softer for each in moduli})
    assert softest.elastic_factor == pytest.approx(1.0)
    for inputs in (points.inputs, softest):
        contact = Contact.of(points.diameter, np.array([roughness]), points.density, inputs)
        reach = contact.particles.reach[0] if contact.particles else 0.0
        separation = np.linspace(0.0, max(reach, 8.0 * roughness), 3000)
        with np.errstate(all="ignore"):
            state = contact.at(separation)
        noise = state.errors.noise[1:] + state.errors.noise[:-1]
        falls = np.diff(state.log_load.value) <= noise
        assert (falls | (state.log_load.value[1:] < np.log(UNDERFLOW))).all()
