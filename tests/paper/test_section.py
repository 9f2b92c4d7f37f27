"""Sections through interfaces: surfaces and particles touch as the model says."""

import re

import numpy as np
import pytest

import thirdbody as tb
from chenhorng.figures.sections import (
    LENGTHS,
    PARTICLES,
    STRETCH,
    section_through,
    size_quantiles,
    state_of,
)
from thirdbody.core.particles import ParticleLayer
from thirdbody.curves import Condition
from thirdbody.notes import sizes_note

# the s-s, p-s and hybrid modes of figure 2
DRY = {"load_N": 2.0, "viscosity_cSt": 0, "roughness_nm": 300, "particle_density_per_m2": 1e11}
MODES = [DRY | {"particle_diameter_nm": diameter} for diameter in (100, 1000, 300)]


def solved_state(given, parameters):
    condition = Condition.of(given)
    load = given["load_N"] / parameters.newtons_per_load
    solution = tb.solve(load=load, **condition._asdict(), parameters=parameters)
    return state_of(condition, given["load_N"], solution.variables)


def heights(section, x, size):
    """Heights of a particle that rests on the lower surface, and that hangs from the upper, as
    drawn.
    """
    across = (section["position"] - x) / STRETCH
    inside = np.abs(across) <= max(0.5 * size, np.abs(across).min())
    half_chord = np.sqrt(np.maximum((0.5 * size) ** 2 - across[inside] ** 2, 0.0))
    return (section["lower"][inside] + half_chord).max(), (
        section["upper"][inside] - half_chord
    ).min()


@pytest.mark.parametrize(
    ("given", "contacts", "held"), [(MODES[0], 2, 0), (MODES[1], 0, 1), (MODES[2], 1, 1)]
)
@pytest.mark.parametrize("length", LENGTHS.values())
def test_summits_touch_and_particles_touch_both_surfaces_as_the_mode_says(
    parameters, given, contacts, held, length
):
    state = solved_state(given, parameters)
    section = section_through(state, parameters, length)
    assert np.count_nonzero(np.diff(section["surfaces_touch"]) == 1) == contacts
    assert (section["lower"] <= section["upper"]).all()
    rows = [*zip(*(section[name] for name in PARTICLES), strict=True)]
    between = 0
    for x, height, size, carries_load in rows:
        rests, hangs = heights(section, x, size)
        assert height == pytest.approx(rests, abs=1e-12)
        assert rests <= hangs + 1e-12
        if hangs - rests < 1e-12:
            between += 1
            assert carries_load
        for other, _, another, _ in rows:
            assert other == x or abs(other - x) > 0.5 * STRETCH * (size + another)
    assert between == held and len(rows) > held
    largest = size_quantiles(1.0, state["particle_diameter"], parameters)
    assert 0.0 < section["particle_size"].min() <= section["particle_size"].max() <= largest


def test_a_surface_has_the_roughness_of_the_condition_and_the_gap_the_separation(parameters):
    state = solved_state(MODES[1], parameters)
    section = section_through(state, parameters, LENGTHS["fig01"])
    gap = section["upper"] - section["lower"]
    assert gap.mean() == pytest.approx(state["separation"], rel=0.2)
    for line in ("lower", "upper"):
        assert section[line].std() == pytest.approx(state["roughness"] / np.sqrt(2.0), rel=0.2)


@pytest.mark.parametrize(("given", "some"), [(MODES[0], False), (MODES[1], True), (MODES[2], True)])
def test_particles_that_reach_into_the_elastic_zone_carry_load(given, some):
    parameters = tb.load_parameters().best
    section = section_through(solved_state(given, parameters), parameters, LENGTHS["fig02"])
    layer = ParticleLayer.of(
        np.array([section["particle_diameter"]]),
        section["roughness"],
        np.array([1e11]),
        parameters,
    )
    largest = size_quantiles(1.0, section["particle_diameter"], parameters)
    reaches = section["particle_size"] + layer.reach[0] - largest > section["separation"]
    # so does one that is drawn between both surfaces
    assert (section["particle_carries_load"] >= reaches).all()
    assert reaches.any() == some and not reaches.all()


def test_conditions_without_a_solution_are_refused(parameters):
    crowded = MODES[1] | {"particle_density_per_m2": 1e15}  # particles cover the interface
    with pytest.raises(ValueError, match="schematic conditions .* have no solution"):
        solved_state(crowded, parameters)


@pytest.mark.parametrize("mean_ratio", [0.0, 1.0])
def test_what_x_a_stands_for_is_the_mean_and_the_largest_of_the_sizes_drawn(mean_ratio):
    inputs = tb.load_parameters(mean_ratio=mean_ratio).best
    drawn = size_quantiles((np.arange(20000) + 0.5) / 20000, 500e-9, inputs)
    note = sizes_note(500e-9, 300e-9, inputs)
    mean, largest, reach = (1e-9 * float(each) for each in re.findall(r"([\d.]+) nm", note)[1:])
    layer = ParticleLayer.of(np.array([500e-9]), 300e-9, np.array([1e11]), inputs)
    assert mean == pytest.approx(drawn.mean(), rel=5e-3)
    assert largest == pytest.approx(size_quantiles(1.0, 500e-9, inputs), rel=5e-3)
    assert reach == pytest.approx(layer.reach[0], rel=5e-3)
