"""Sections through interfaces: what chance draws, and the file that keeps it."""

import re

import numpy as np
import pytest

import thirdbody as tb
from thirdbody.core.particles import ParticleLayer
from thirdbody.curves import Condition
from thirdbody.netcdf import read_plain, write_dataset
from thirdbody.notes import sizes_note
from chenhorng.figures.sections import (
    STRETCH,
    VARIABLES,
    section_through,
    sections,
    size_quantiles,
    state_of,
)

# the s-s, p-s and hybrid modes of figure 2
DRY = {"load_N": 2.0, "viscosity_cSt": 0, "roughness_nm": 300, "particle_density_per_m2": 1e11}
MODES = [DRY | {"particle_diameter_nm": diameter} for diameter in (100, 1000, 300)]


def solved_state(given, parameters):
    condition = Condition.of(given)
    load = given["load_N"] / parameters.newtons_per_load
    solution = tb.solve(load=load, **condition._asdict(), parameters=parameters)
    return state_of(condition, given["load_N"], solution.variables)


def test_section_has_the_statistics_of_the_model(parameters):
    state = solved_state(MODES[1], parameters)
    drawn = [section_through(state, parameters, 2e-4, seed) for seed in range(60)]
    gaps = np.array([section["upper"] - section["lower"] for section in drawn])
    # some 300 independent heights: the mean is known to sigma/17, sigma to 4 %; three times that
    roughness = state["roughness"]
    assert gaps.mean() == pytest.approx(state["separation"], abs=3.0 * roughness / 17.0)
    assert gaps.std() == pytest.approx(roughness, rel=0.12)
    diameters = np.concatenate([section["particle_size"] for section in drawn])
    largest = parameters.truncation * parameters.spread_ratio * state["particle_diameter"]
    assert diameters.min() > 0.0 and diameters.max() < largest * (1 + 1e-12)


def test_particles_rest_on_the_lower_surface_or_are_held(parameters):
    section = section_through(solved_state(MODES[2], parameters), parameters, 8.4e-5, 1)
    names = (f"particle_{name}" for name in ("position", "height", "size", "carries_load"))
    for x, y, size, carries_load in zip(*(section[name] for name in names), strict=True):
        across = (section["position"] - x) / STRETCH  # as it is drawn
        inside = np.abs(across) < 0.5 * size
        half_chord = np.sqrt((0.5 * size) ** 2 - across[inside] ** 2)
        rests = (section["lower"][inside] + half_chord).max(initial=-np.inf)
        hangs = (section["upper"][inside] - half_chord).min(initial=np.inf)
        assert carries_load or rests <= hangs
        assert rests > hangs or not inside.any() or y == pytest.approx(rests, abs=0.02 * size)
    assert section["particle_carries_load"].any()


@pytest.mark.parametrize(("given", "some"), [(MODES[0], False), (MODES[1], True), (MODES[2], True)])
def test_particles_that_reach_into_the_elastic_zone_carry_load(given, some):
    parameters = tb.load_parameters().best
    section = section_through(solved_state(given, parameters), parameters, 8.4e-5, 1)
    layer = ParticleLayer.of(
        np.array([section["particle_diameter"]]),
        section["roughness"],
        np.array([1e11]),
        parameters,
    )
    largest = size_quantiles(1.0, 0.0, section["particle_diameter"], parameters)
    reaches = section["particle_size"] + layer.reach[0] - largest > section["separation"]
    # so does one that is drawn between both surfaces
    assert (section["particle_carries_load"] >= reaches).all()
    assert reaches.any() == some and not reaches.all()
    # and no other is drawn in the zone
    top = section["particle_height"] + 0.5 * section["particle_size"]
    in_zone = top > section["separation"] - section["elastic_depth"]
    assert section["particle_carries_load"][in_zone].all()


def test_a_file_keeps_every_digit_in_the_same_bytes_every_time(parameters, tmp_path):
    states = [solved_state(one, parameters) for one in MODES]
    for name in ("a.nc", "b.nc"):
        written = sections("fig02", states, parameters)
        write_dataset(written, tmp_path / name)
    assert (tmp_path / "a.nc").read_bytes() == (tmp_path / "b.nc").read_bytes()
    counts = np.isfinite(written["particle_size"].values).sum(axis=1)
    assert counts[1] < counts.max()  # large particles leave less room
    again = read_plain(tmp_path / "a.nc", VARIABLES)
    for name, variable in written.variables.items():
        np.testing.assert_array_equal(again[name].values, variable.values, strict=True)


def test_conditions_without_a_solution_are_refused(parameters):
    crowded = MODES[1] | {"particle_density_per_m2": 1e15}  # particles cover the interface
    with pytest.raises(ValueError, match="schematic conditions .* have no solution"):
        solved_state(crowded, parameters)


@pytest.mark.parametrize("mean_ratio", [0.0, 1.0])
def test_what_x_a_stands_for_is_the_mean_and_the_largest_of_the_sizes_drawn(mean_ratio):
    inputs = tb.load_parameters(mean_ratio=mean_ratio).best
    drawn = size_quantiles((np.arange(20000) + 0.5) / 20000, 0.0, 500e-9, inputs)
    note = sizes_note(500e-9, 300e-9, inputs)
    mean, largest, reach = (1e-9 * float(each) for each in re.findall(r"([\d.]+) nm", note)[1:])
    layer = ParticleLayer.of(np.array([500e-9]), 300e-9, np.array([1e11]), inputs)
    assert mean == pytest.approx(drawn.mean(), rel=5e-4)
    assert largest == pytest.approx(size_quantiles(1.0, 0.0, 500e-9, inputs), rel=1e-3)
    assert reach == pytest.approx(layer.reach[0], rel=5e-4)
