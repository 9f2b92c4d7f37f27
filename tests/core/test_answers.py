"""The answers of an interface against solves of one's own."""

import warnings
from dataclasses import replace

import numpy as np
import pytest
from methods import ENGINEERING, POINT
from numpy.testing import assert_allclose

import thirdbody as tb
from thirdbody.answers.answer import Row
from thirdbody.bearings import MATERIALS, Material, derived
from thirdbody.core.regimes import LUBRICATION_REGIMES
from thirdbody.variables import QUANTITIES


@pytest.fixture
def interface(defaults):
    """An interface with two members, which are enough here."""
    few = defaults.with_members(defaults.members[:2])
    return tb.Interface(**ENGINEERING, parameters=few)


def solved(inputs, load_N=10.0, **given):
    load = load_N / inputs.newtons_per_load
    return tb.solve(**POINT | {"load": load} | given, parameters=inputs)


def test_the_state_is_what_solve_gives_in_other_units(interface, defaults):
    state, solution = interface.state(), solved(defaults)
    assert state.found
    for name in QUANTITIES:
        scale = 1e9 if name == "separation" else 1.0
        assert state.value(name) == pytest.approx(scale * float(getattr(solution, name)))
    regime = LUBRICATION_REGIMES[int(solution.lubrication_regime)]
    assert state.value("lubrication_regime") == regime.replace("_", " ")


def test_the_range_is_that_of_the_members(defaults):
    members = tb.ensemble(defaults)
    shares = [float(solved(each).solid_load_fraction) for each in members]
    state = tb.Interface(**ENGINEERING).state()
    row = {row.name: row for row in state.rows}["solid_load_fraction"]
    assert (row.low, row.high) == pytest.approx(tuple(np.quantile(shares, [0.05, 0.95])))
    assert (row.agree, row.members) == (len(members), len(members))
    assert any(f"5 to 95 % over {len(members)} sets" in note for note in state.notes)


def test_members_keep_what_the_user_has_changed(defaults):
    mine = defaults.changed(ball_radius=0.01, apparent_area=0.5 * defaults.apparent_area)
    members = tb.Interface(**ENGINEERING, parameters=mine).members
    assert len(members) == len(defaults.members)
    assert {each.ball_radius for each in members} == {0.01}
    assert {each.apparent_area for each in members} == {mine.apparent_area}


def test_a_border_that_is_not_passed_is_named(interface):
    answer = interface.changed(viscosity_cSt=0).transitions("load", ["lubrication_regime"])
    assert not answer.found
    assert [row.value for row in answer.rows] == [None, None]
    assert "searched: load 0.01 to 1000 N" in answer.notes


def test_the_turning_point_is_a_maximum(interface, defaults):
    dry = interface.changed(viscosity_cSt=0, particle_diameter_nm=300)
    answer = dry.turning_point()
    load = answer.value("load_N")
    loads = load * np.array([0.98, 1.0, 1.02])
    found = solved(defaults, loads, viscosity=0.0, particle_diameter=300e-9)
    ratio = found.particle_contact_area_ratio
    assert ratio[1] > max(ratio[0], ratio[2])
    assert answer.value("peak_ratio") == pytest.approx(ratio[1], rel=1e-8)
    assert answer.value("load") == pytest.approx(load / defaults.newtons_per_load)
    sizes = np.multiply.outer([answer.value("low"), answer.value("high")], [0.99, 1.01]).ravel()
    there = [dry.changed(particle_diameter_nm=size).turning_point().found for size in sizes]
    assert there == [False, True, True, False]


@pytest.mark.parametrize("along", POINT)
def test_a_curve_is_what_solve_gives(interface, along):
    curve = interface.curve(along, 80.0, 120.0, count=5)
    assert_allclose(curve.points, np.geomspace(80.0, 120.0, 5))
    key = curve.along
    for index in (0, 4):
        state = interface.changed(**{key: float(curve.points[index])}).state()
        got = curve.values["solid_load_fraction"][index]
        assert state.value("solid_load_fraction") == pytest.approx(got, rel=1e-8)
    header, *rows = curve.as_csv().splitlines()
    assert header.startswith(f"{key},total_contact_area,total_contact_area_low,")
    assert len(rows) == 5 and "separation_high [m],film_thickness [1]" in header


def test_a_comparison_has_both_values_and_the_range_of_the_change(interface):
    other = interface.changed(viscosity_cSt=120.0)
    rows = {row.name: row for row in interface.compare(other).rows}
    share = rows["solid_load_fraction"]
    assert share.value == interface.state().value("solid_load_fraction")
    assert share.other == other.state().value("solid_load_fraction")
    assert share.low <= share.high < 0.0


def test_table_1_and_2_follow_from_what_an_engineer_knows(defaults):
    other = replace(defaults, elastic_modulus_surfaces=1e9, material_parameter=1.0)
    bodies = dict.fromkeys(("ball", "flat", "particle"), MATERIALS["steel"])
    oil = dict(pressure_viscosity_per_GPa=18.2, dynamic_viscosity_mPa_s=129.8, viscosity_cSt=150.0)
    inputs = tb.bearing(other, **bodies, **oil, speed_m_per_s=4.0)
    moduli = inputs.elastic_modulus_surfaces, inputs.elastic_modulus_particle
    assert moduli == pytest.approx((112e9, 112e9), rel=2e-3)
    assert inputs.material_parameter == pytest.approx(2038, rel=2e-3)
    assert inputs.speed_per_viscosity * 150e-6 == pytest.approx(7.3e-10, rel=2e-3)
    assert derived(inputs, 150.0).value("speed_parameter") == pytest.approx(7.3e-10, rel=2e-3)


def test_what_is_not_given_stays(defaults):
    assert tb.bearing(defaults) == defaults
    larger = tb.bearing(defaults, ball_radius_mm=12.7)
    assert larger.speed_per_viscosity == pytest.approx(0.5 * defaults.speed_per_viscosity)
    assert larger.hardness_parameter == defaults.hardness_parameter


@pytest.mark.parametrize(
    "given",
    [
        {"ball_radius_mm": -1.0},
        {"speed_m_per_s": 2.0},
        {"oil_density_kg_per_m3": 850.0},
        {"speed_m_per_s": 2.0, "dynamic_viscosity_mPa_s": 100.0},
        {"pressure_viscosity_per_GPa": float("nan")},
        {"particle": Material(0.5, 0.46, 0.02)},  # softer than steel
        {"particle": MATERIALS["steel"], "ball": MATERIALS["alumina"]},
    ],
)
def test_a_bearing_that_cannot_be_is_refused(defaults, given):
    with pytest.raises(ValueError, match="allowed: "):
        tb.bearing(defaults, **given)


def test_an_interface_is_checked_when_it_is_made():
    with pytest.raises(ValueError, match="viscosity_cSt is nan; allowed: "):
        tb.Interface(**ENGINEERING | {"viscosity_cSt": np.nan})


def test_rows_say_how_many_members_agree():
    row = Row.of("a", "A", "mixed", "", ["mixed", "boundary", None])
    assert (row.agree, row.members, row.range_text) == (1, 3, "1 of 3")
    none = Row.of("a", "A", None, "N", [None, 2.0])
    assert none.range_text == "2 to 2, 1 of 2 have none"


def test_a_ball_smaller_than_the_interface_is_refused_wherever_it_is_given(defaults):
    message = f"apparent_area is {defaults.apparent_area:g}; allowed: at most 7.85e-07 m2, the cross-section of a ball"
    with pytest.raises(ValueError, match=message):
        tb.bearing(defaults, ball_radius_mm=0.5)
    with pytest.raises(ValueError, match=message):
        tb.load_parameters(ball_radius=0.0005)
    small = tb.bearing(defaults, ball_radius_mm=0.5, apparent_area_mm2=0.5)
    assert (small.ball_radius, small.apparent_area) == pytest.approx((5e-4, 5e-7))


def test_what_stays_of_the_film_where_a_modulus_changes_is_said(defaults):
    with pytest.warns(UserWarning, match="ball_radius is changed without speed"):
        tb.load_parameters(ball_radius=0.01)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        tb.load_parameters(ball_radius=0.01, speed_per_viscosity=3e-6)
        tb.load_parameters(ball_radius=defaults.ball_radius * (1.0 + 1e-15))  # not changed
        tb.load_parameters(truncation=2.5)


def test_inputs_without_an_ensemble_have_no_range_and_say_so(interface, defaults):
    alone = interface.changed(parameters=replace(defaults, truncation=3.0))
    assert alone.members == ()
    other = alone.changed(viscosity_cSt=120)
    answers = [alone.state(), alone.compare(other), alone.transitions(), alone.turning_point()]
    for answer in answers:
        assert [note for note in answer.notes if note.startswith("no range: ")]
        assert not [note for note in answer.notes if note.startswith("ranges are ")]
        assert {row.low for row in answer.rows} == {None}
        assert {row.range_text for row in answer.rows} == {""}
    assert "separation_low" not in alone.curve("load", 1.0, 10.0, count=2).values


def test_in_a_full_film_there_is_no_contact_mode(interface):
    thick = interface.changed(viscosity_cSt=1000).state()
    assert thick.value("lubrication_regime") == "full film"
    assert thick.value("contact_mode") is None
    assert any(
        note.startswith("full film: the solids carry less than 0.03") for note in thick.notes
    )
    changes = interface.transitions("viscosity", between=(50, 2000))
    end = changes.value("mixed_to_full_film")
    for row in changes.rows:
        assert row.value is None or row.value <= end
    modes = interface.transitions("viscosity", "contact_mode", between=(50, 2000))
    left_out = [note for note in modes.notes if note.startswith("left out")]
    assert left_out and all("full film" in note for note in left_out)
    assert modes.value("mixed_to_full_film") == end  # beyond which no mode is given
    assert any(note.endswith("2000 cSt: full film") for note in modes.notes)
    compared = interface.compare(interface.changed(viscosity_cSt=1000))
    modes = {row.name: (row.value, row.other) for row in compared.rows}["contact_mode"]
    assert modes[0] is not None and modes[1] is None
    curve = interface.curve("viscosity", 50, 2000, count=5).values
    assert curve["contact_mode"].isna().equals(curve["lubrication_regime"] == "full_film")
