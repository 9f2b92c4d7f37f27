"""Inputs that follow from ball, speed, oil and materials."""

import warnings
from dataclasses import replace

import pytest

import thirdbody as tb
from thirdbody.bearings import MATERIALS, derived_inputs
from thirdbody.core.parameters import BOUNDS

OWN = tb.Material(205.0, 0.29, 3.0)


def test_table_1_and_2_follow_from_what_an_engineer_knows(defaults):
    other = replace(defaults.best, elastic_modulus_surfaces=1e9, material_parameter=1.0)
    bodies = dict.fromkeys(("ball", "flat", "particle"), MATERIALS["steel"])
    # mu_0 = 129.8 mPa s at 150 cSt
    oil = dict(pressure_viscosity_per_GPa=18.2, oil_density_kg_per_m3=865.3, speed_m_per_s=4.0)
    inputs = tb.bearing(other, **bodies, **oil)
    moduli = inputs.elastic_modulus_surfaces, inputs.elastic_modulus_particle
    assert moduli == pytest.approx((112e9, 112e9), rel=2e-3)
    assert inputs.material_parameter == pytest.approx(2038, rel=2e-3)
    assert inputs.speed_per_viscosity * 150e-6 == pytest.approx(7.3e-10, rel=2e-3)
    assert inputs.speed == pytest.approx(4.0)
    table = derived_inputs(inputs)
    assert table["value"].to_dict() == {name: getattr(inputs, name) for name in table.index}


def test_what_is_not_given_stays(defaults):
    assert tb.bearing(defaults) == defaults
    larger = tb.bearing(defaults, ball_radius_mm=12.7)
    assert larger.speed_per_viscosity == pytest.approx(0.5 * defaults.speed_per_viscosity)
    assert larger.hardness_parameter == defaults.hardness_parameter
    assert tb.bearing(defaults, ellipticity=8.0) == defaults.changed(ellipticity=8.0)


@pytest.mark.parametrize(
    ("first", "later"), [("ball", "flat"), ("flat", "ball"), ("particle", "ball")]
)
def test_bodies_given_one_after_the_other_are_those_given_together(first, later):
    harder = tb.Material(600.0, 0.2, 25.0)
    bodies = {"particle": harder, first: "alumina", later: "alumina"} | {"particle": harder}
    step = tb.bearing(**{name: body for name, body in bodies.items() if name != later})
    in_steps, together = tb.bearing(step, **{later: bodies[later]}), tb.bearing(**bodies)
    for name in BOUNDS:
        assert getattr(in_steps, name) == pytest.approx(getattr(together, name), rel=1e-12)


def test_later_steps_and_changes_keep_the_materials():
    pair = tb.bearing(ball="alumina", flat="alumina", particle="alumina")
    moved = tb.bearing(pair.changed(truncation=3.0), ball_radius_mm=10.0)
    again = tb.bearing(moved, particle=tb.Material(600.0, 0.2, 25.0))
    assert again.hardness_surface_1 == again.hardness_surface_2 == 16e9
    assert again.elastic_modulus_surfaces == pair.elastic_modulus_surfaces


def test_a_hardness_of_ones_own_stays(defaults):
    softer = defaults.changed(hardness_surface_1=3e9, hardness_parameter=0.027)
    inputs = tb.bearing(softer, particle="alumina")
    assert (inputs.hardness_surface_1, inputs.hardness_parameter) == (3e9, 0.027)


def test_unknown_bodies_are_given_together_or_refused(defaults):
    unknown = replace(defaults.best, elastic_modulus_surfaces=70e9)
    with pytest.raises(ValueError, match="^ball, flat: missing, and the inputs do not say"):
        tb.bearing(unknown, particle="alumina")
    bodies = dict.fromkeys(("ball", "flat", "particle"), "alumina")
    moduli = "elastic_modulus_surfaces", "elastic_modulus_particle"
    one, other = (tb.bearing(inputs, **bodies) for inputs in (unknown, defaults))
    assert [getattr(one, name) for name in moduli] == [getattr(other, name) for name in moduli]


def test_ball_and_flat_are_not_alike():
    """Eq. 5 counts the contact area of particles on surface 1."""
    interface = dict(load_N=10, viscosity_cSt=90, roughness_nm=300)
    interface |= dict(particle_diameter_nm=500, particle_density_per_m2=1e11)
    one, other = (
        tb.solve(**interface, parameters=tb.bearing(**{body: OWN})).total_contact_area
        for body in ("ball", "flat")
    )
    assert abs(one / other - 1.0) > 0.05


@pytest.mark.parametrize(
    "arguments",
    [
        {"ball_radius_mm": -1.0},
        {"speed_m_per_s": 2.0},
        {"oil_density_kg_per_m3": 850.0},
        {"pressure_viscosity_per_GPa": float("nan")},
        {"particle": tb.Material(0.5, 0.46, 0.02)},  # softer than steel
        {"particle": MATERIALS["steel"], "ball": MATERIALS["alumina"]},
        {"ball": "wood"},
    ],
)
def test_a_bearing_that_cannot_be_is_refused(defaults, arguments):
    with pytest.raises(ValueError, match="allowed: "):
        tb.bearing(defaults, **arguments)


def test_a_ball_smaller_than_the_interface_is_refused_wherever_it_is_given(defaults):
    message = (
        f"apparent_area is {defaults.apparent_area:g}; allowed: at most 7.85e-07 m2, "
        "the cross-section of a ball"
    )
    with pytest.raises(ValueError, match=message):
        tb.bearing(defaults, ball_radius_mm=0.5)
    with pytest.raises(ValueError, match=message):
        tb.load_parameters(ball_radius=0.0005)
    with pytest.raises(ValueError, match=message):
        defaults.changed(ball_radius=0.0005)
    small = tb.bearing(defaults, ball_radius_mm=0.5, apparent_area_mm2=0.5)
    assert (small.ball_radius, small.apparent_area) == pytest.approx((5e-4, 5e-7))


def test_what_stays_of_the_film_where_a_modulus_changes_is_said(defaults):
    for change in (tb.load_parameters, defaults.changed):
        with pytest.warns(UserWarning, match="ball_radius is changed without speed") as warned:
            change(ball_radius=0.01)
        assert warned[0].filename == __file__
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        tb.load_parameters(ball_radius=0.01, speed_per_viscosity=3e-6)
        tb.load_parameters(ball_radius=defaults.ball_radius * (1.0 + 1e-15))  # not changed
        tb.load_parameters(truncation=2.5)
