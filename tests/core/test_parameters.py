"""The inputs and the interpretations of the paper: what follows from them, and how they are written
down.
"""

import json
import math
import re
import runpy
from dataclasses import FrozenInstanceError, replace
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose

import thirdbody as tb
from benchmarks.points import parameters_on_one_surface
from chenhorng.configuration.settings import read_settings
from chenhorng.home import config_directory
from thirdbody.command import BAD_INPUT, main
from thirdbody.core.parameters import BOUNDS, MATERIALS, WORDS, Parameters, mccool_summits
from thirdbody.core.particles import first_yield_depth
from thirdbody.files import format_value, read_yaml
from thirdbody.netcdf import model_attribute

LISTS = ["eta_s", "R", "sigma_s", "y_s"]
CONTRACT = Path(__file__).parents[2] / "verification" / "contract.py"


def attribute(parameters, roughness=(1e-7, 3e-7, 5e-7)):
    return json.loads(model_attribute(parameters, np.array(roughness)))


def test_the_elastic_factor_to_the_printed_digits(parameters):
    assert float(f"{parameters.elastic_factor:.3g}") == 0.0885


def test_the_depth_at_first_yield_is_the_interference_with_both_surfaces(parameters):
    assert first_yield_depth(parameters) == pytest.approx(0.001770, rel=1e-3)
    assert first_yield_depth(replace(parameters, yield_pressure_ratio=1.0)) == pytest.approx(
        0.01106, rel=1e-3
    )
    materials = dict(zip(MATERIALS, (200e9, 150e9, 3e9, 6e9), strict=True))
    changed = replace(parameters, yield_pressure_ratio=0.6, **materials)
    of_each_side = [(0.75 * math.pi * 0.6 * ratio) ** 2 / 2.0 for ratio in (3 / 150, 6 / 200)]
    assert first_yield_depth(changed) == pytest.approx(sum(of_each_side))


# particles that would carry more while elastic than plastic
SOFT = {"elastic_modulus_particle": 5e9}
TOO_SOFT = (
    "the elastic factor of particles (Eq. 4) is 22.3 for elastic_modulus_surfaces 1.12e+11, "
    "elastic_modulus_particle 5e+09, hardness_surface_1 5e+09, hardness_surface_2 5e+09; "
    "allowed: at most 1, as for hard particles"
)
POINT = {"viscosity": 0.0, "roughness": 3e-7, "particle_density": 1e11}


def test_soft_particles_are_refused_and_two_bodies_of_these_materials_are_not(parameters):
    soft, loads = replace(parameters, **SOFT), np.array([1e-6, 1e-5])
    bare, hard = (
        tb.solve(load=loads, **POINT, particle_diameter=0.0, parameters=inputs)
        for inputs in (soft, parameters)
    )
    assert np.array_equal(bare.separation, hard.separation)
    with pytest.raises(ValueError) as refused:
        tb.solve(load=loads, **POINT, particle_diameter=[[0.0], [3e-7]], parameters=soft)
    assert str(refused.value) == TOO_SOFT


def test_the_greatest_elastic_factor_is_one(parameters):
    modulus = 5e9 / math.sqrt(1.0 / (2.25 * math.pi**2) - (5.0 / 112.0) ** 2)
    limit = replace(parameters, elastic_modulus_particle=modulus * (1.0 + 1e-12))
    assert limit.elastic_factor == pytest.approx(1.0)
    limit.check_particles()
    with pytest.raises(ValueError, match=r"the elastic factor of particles \(Eq. 4\) is 1 for"):
        replace(limit, elastic_modulus_particle=modulus * (1.0 - 1e-12)).check_particles()


CONDITIONS = "--viscosity-cSt=90", "--particle-diameter-nm=300", "--roughness-nm=300"
CONDITIONS += ("--particle-density-per-m2=1e11",)


def test_each_door_refuses_soft_particles_in_one_line(tmp_path, capsys, monkeypatch):
    point = POINT | dict(particle_diameter=3e-7, parameters=tb.load_parameters(**SOFT))
    for door in (
        lambda: tb.grid(load=[1e-6, 1e-5], **point),
        lambda: tb.stream(tmp_path / "grid.nc", load=[1e-6, 1e-5], **point),
        lambda: tb.turning_point(**point),
    ):
        with pytest.raises(ValueError, match=f"^{re.escape(TOO_SOFT)}$"):
            door()
    assert not list(tmp_path.iterdir())
    folder, changed = config_directory(), "config/soft.yaml"
    monkeypatch.chdir(tmp_path)
    Path("config").mkdir()
    Path(changed).write_text("elastic_modulus_particle: 5.0e+9\n", encoding="utf-8")
    for inputs, place in ((SOFT, "inputs"), (changed, changed)):
        with pytest.raises(ValueError, match=f"^{re.escape(f'{place}: {TOO_SOFT}')}$"):
            read_settings({"inputs": inputs}, folder)
    assert main(["turning-point", *CONDITIONS, f"--inputs={changed}"]) == BAD_INPUT
    assert " ".join(capsys.readouterr().err.split()).endswith(TOO_SOFT)


@pytest.mark.parametrize("name", BOUNDS)
def test_a_number_out_of_its_bounds_is_refused_by_name(parameters, name):
    for bad in (math.nan, math.inf, -1e99, True, "1.0", None, [1.0]):
        with pytest.raises(ValueError) as refused:
            replace(parameters, **{name: bad})
        assert str(refused.value) == f"{name} is {format_value(bad)}; allowed: {BOUNDS[name]}"
    for end in BOUNDS[name][:2]:
        assert getattr(replace(parameters, **{name: end}), name) == end


def test_each_number_of_the_attribute_is_its_own_input(parameters):
    most = [bounds.most for bounds in BOUNDS.values()]
    distinct = dict(zip(BOUNDS, most * np.linspace(1.0, 0.97, len(most)), strict=True))
    distinct["summit_parameter_exponent"] = (
        0.5  # steeper ones lift the summits of the finest surface too high
    )
    model = attribute(replace(parameters, **distinct))
    names = runpy.run_path(str(CONTRACT))["INPUTS"]
    assert set(model) == {*names, *LISTS, "phi_a"}
    given = {key: distinct[name] for key, name in names.items() if name in distinct}
    assert {key: model[key] for key in given} == given


@pytest.mark.parametrize(("mean_ratio", "word"), [(0.0, "uncentred"), (1e-9, "centred")])
def test_the_attribute_says_whether_the_sizes_have_a_mean(parameters, mean_ratio, word):
    model = attribute(replace(parameters, mean_ratio=mean_ratio))
    assert (model["phi_a"], model["mean_ratio"]) == (word, mean_ratio)
    keys = list(model)
    assert keys.index("phi_a") + 1 == keys.index("mean_ratio")


@pytest.mark.parametrize("index", [0, 1, 2])
def test_the_attribute_is_read_back_as_it_was_written(interpretation, index):
    roughness = [1e-7, 3e-7, 5e-7]
    model = json.loads(model_attribute(interpretation, roughness))
    model |= {key: model[key][index] for key in LISTS}
    again = parameters_on_one_surface(model, roughness[index])
    found = json.loads(model_attribute(again, roughness[index : index + 1]))
    for key in LISTS:
        assert_allclose(found.pop(key), [model.pop(key)], rtol=1e-15)
    assert found == model


@pytest.mark.parametrize("scale", [0.4, 1.0, 5.0])
def test_summits_follow_their_laws_about_the_reference_roughness(parameters, scale):
    inputs, roughness = parameters, scale * parameters.reference_roughness
    surface = inputs.surface(roughness)
    radius = inputs.summit_radius * scale**inputs.summit_radius_exponent
    product = inputs.summit_parameter * scale**inputs.summit_parameter_exponent
    assert_allclose(surface.summit_radius, radius, rtol=1e-14)
    assert_allclose(surface.summit_density * radius * roughness, product, rtol=1e-14)
    offset = inputs.summit_offset_ratio * scale**-inputs.summit_parameter_exponent
    assert_allclose(surface.summit_offset, offset * roughness, rtol=1e-15)
    assert_allclose(surface.summit_deviation, inputs.summit_deviation_ratio * roughness, rtol=1e-15)


def test_summits_after_mccool_lie_above_the_mean_plane_and_scatter_less(parameters):
    summits = mccool_summits(0.05)
    surface = replace(parameters, **summits, summit_parameter=0.05).surface(300e-9)
    length = 1.0 / (surface.summit_density * surface.summit_radius)
    assert_allclose(surface.summit_offset, 0.045944 * length, rtol=1e-14)
    variance = 300e-9**2 - 3.717e-4 * length**2
    assert_allclose(surface.summit_deviation, math.sqrt(variance), rtol=1e-14)


@pytest.mark.parametrize("bad", [0.0192, 0.0, -1.0, math.nan])
def test_no_surface_has_fewer_or_sharper_summits(bad):
    with pytest.raises(ValueError, match=r"summit_parameter is .*; allowed: above 0\.01928$"):
        mccool_summits(bad)


def test_equal_inputs_are_equal_whatever_their_numbers_are_made_of(parameters):
    again = Parameters(**parameters.as_dict())
    assert again == parameters and hash(again) == hash(parameters)
    for number in (3, np.int32(3), np.float32(3.0), np.float64(3.0)):
        assert replace(parameters, truncation=number) == replace(parameters, truncation=3.0)
    with pytest.raises(FrozenInstanceError):
        parameters.truncation = 1.0


@pytest.mark.parametrize("name", WORDS)
def test_the_configuration_allows_the_words_that_are_known(name):
    entry = read_yaml(config_directory() / "inputs.yaml")[name]
    assert entry["allowed"] == list(WORDS[name])


@pytest.mark.parametrize("name", WORDS)
@pytest.mark.parametrize("word", ["solid", None, ["fluid"], 0.5])
def test_an_unknown_word_is_refused_by_name(parameters, name, word):
    allowed = ", ".join(WORDS[name])
    with pytest.raises(ValueError) as refusal:
        replace(parameters, **{name: word})
    assert str(refusal.value) == f"{name} is {word!r}; allowed: {allowed}"
