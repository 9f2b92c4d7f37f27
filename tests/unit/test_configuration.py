"""Configuration that is refused, each in one line that names the place, and what is accepted."""

import copy
import json
import math
from dataclasses import fields, replace
from pathlib import Path

import pytest

from thirdbody.configuration.inputs import load_parameters, read_calibrated, read_entries
from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.configuration.schema import config_directory, read_schema
from thirdbody.configuration.settings import read_settings, workflow_settings
from thirdbody.model.bounds import BOUNDS
from thirdbody.model.parameters import Parameters

ROOT = Path(__file__).parents[2]
CONFIG = ROOT / "config"


@pytest.fixture
def write(tmp_path):
    """Writes a configuration file and gives its path."""

    def write_file(content, name="given.yaml"):
        path = tmp_path / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    return write_file


@pytest.fixture(scope="module")
def shipped():
    """The configuration of the workflow as Snakemake merges it."""
    return read_yaml(CONFIG / "config.yaml") | read_yaml(CONFIG / "scenes.yaml")


@pytest.fixture
def from_root(monkeypatch):
    """The workflow runs in the root of the repository."""
    monkeypatch.chdir(ROOT)


def refusal(function, *given):
    """The one line with which ``function`` refuses."""
    with pytest.raises(ValueError) as refused:
        function(*given)
    message = str(refused.value)
    assert message
    assert "\n" not in message
    return message


def changed(config, key, value):
    """A copy with the entry at the dotted ``key`` set, or removed where ``value`` is KeyError."""
    result = copy.deepcopy(config)
    *parents, last = key.split(".")
    place = result
    for parent in parents:
        place = place[int(parent) if parent.isdigit() else parent]
    if value is KeyError:
        del place[last]
    else:
        place[int(last) if last.isdigit() else last] = value
    return result


# ---- YAML


STRICT = {
    "a key twice": ("a: 1\nb: 2\na: 3", "line 3: key 'a' stands twice"),
    "an alias": ("a: &x [1]\nb: *x", "allowed: plain values"),
    "an anchor": ("a: &x 1", "allowed: plain values"),
    "a merge": ("a: {<<: {b: 1}}", "line 1"),
    "a tag that builds an object": (
        "a: !!python/object/apply:os.system [ls]",
        "python/object/apply:os.system; allowed: plain values",
    ),
    "a tag of one's own": ("a: !secret b", "tag !secret; allowed: plain values"),
    "a number as key": ("1: a", "line 1: key 1; allowed: words"),
    "a truth value as key": ("on: a", "line 1: key True; allowed: words"),
    "two documents": ("a: 1\n---\nb: 2", "another document"),
    "an open bracket": ("a: [1\n", "line 2: did not find expected ',' or ']'"),
    "a tab for indentation": ("a:\n\t- 1", "line 2"),
    "a control character": ("a: 1\x07", "not allowed"),
    "a byte that is not UTF-8": (b"a: \xff", "byte 3 is not UTF-8"),
    "UTF-16": ("a: 1".encode("utf-16"), "not UTF-8"),
    "nothing": ("", "holds NoneType; allowed: keys with values"),
    "a list": ("- a", "holds list; allowed: keys with values"),
    "endless brackets": ("[" * 5000, "nested too deeply"),
    "a number of 5000 digits": ("a: " + "9" * 5000, "digits"),
}


@pytest.mark.parametrize("case", STRICT)
def test_yaml_that_is_more_or_less_than_plain_data_is_refused(write, case):
    content, told = STRICT[case]
    path = write(content)
    message = refusal(read_yaml, path)
    assert message.startswith(f"{path}: ")
    assert told in message


@pytest.mark.parametrize("path", ["missing.yaml", ".", "no/such/folder/given.yaml"])
def test_a_file_that_cannot_be_read_is_named(tmp_path, path):
    message = refusal(read_yaml, tmp_path / path)
    assert str(tmp_path / path) in message
    assert "allowed: a readable YAML file" in message


def test_plain_data_are_read(write):
    content = "a: 1\nb: [1.5, two]\nc: {d: true}\n"
    expected = {"a": 1, "b": [1.5, "two"], "c": {"d": True}}
    assert read_yaml(write(content)) == expected
    assert read_yaml(write(b"\xef\xbb\xbf" + content.encode())) == expected


def test_a_template_that_runs_code_is_refused(write, from_root):
    path = write("__use_yte__: true\nrtol: 1.0e-9\n")
    message = refusal(read_settings, {"changes": str(path)}, CONFIG)
    assert "unknown key '__use_yte__'" in message


# ---- inputs of the model


def test_the_inputs_have_an_entry_for_each_field_and_no_other():
    names = {field.name for field in fields(Parameters)}
    schema = read_schema("inputs")
    assert set(read_yaml(CONFIG / "inputs.yaml")) == names
    assert set(schema["properties"]) == set(schema["required"]) == names


def test_each_input_says_where_it_comes_from_and_what_is_allowed():
    for name, entry in read_yaml(CONFIG / "inputs.yaml").items():
        assert entry["source"] in ("published", "deduced", "calibrated", "assumed"), name
        assert ("value" in entry) == (entry["source"] != "calibrated"), name
        if "allowed" not in entry:
            assert entry["unit"], name
            assert BOUNDS[name].hold(entry.get("value", BOUNDS[name].least)), name
        elif "value" in entry:
            assert entry["value"] in entry["allowed"], name


def test_a_file_of_some_keys_is_laid_over_the_calibrated_inputs(write, defaults):
    given = {"hardness_surface_1": 3e9, "size_distribution": "centred"}
    path = write("hardness_surface_1: 3.0e+9\nsize_distribution: {value: centred}\n")
    assert load_parameters(path).as_dict() == defaults.as_dict() | given


def test_single_inputs_win_over_a_file(write, defaults):
    path = write("truncation: 3.0\nmean_ratio: 0.5\n")
    assert load_parameters(path, truncation=4) == replace(defaults, truncation=4.0, mean_ratio=0.5)


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"hardness_surface_1": -1e9}, "hardness_surface_1 is -1000000000.0; allowed: a number"),
        ({"truncation": math.nan}, "truncation is nan; allowed: a number from 0.5 to 10"),
        ({"hardness": 1e9}, "unknown key 'hardness'; allowed: hardness_"),
        ({"film_load": "solid"}, "film_load is 'solid'; allowed: fluid, total"),
    ],
    ids=str,
)
def test_a_bad_single_input_is_refused_by_name(given, told):
    assert refusal(lambda: load_parameters(**given)).startswith(f"load_parameters: {told}")


def test_a_copy_of_the_projects_file_leaves_the_calibrated_inputs(defaults):
    assert load_parameters(CONFIG / "inputs.yaml") == defaults


def calibrated(inputs, member="{truncation: 2.0}"):
    """Text of a calibrated file."""
    return (
        "interpretation: some\nobjective: 70.5\npenalty: 0.5\nidentification: {}\n"
        f"inputs: {inputs}\nensemble: [{member}]\n"
    )


BAD_INPUTS = {
    "unknown key": ("truncatoin: 2.0", "truncatoin"),
    "negative": ("truncation: -1.0", "truncation is -1.0; allowed: a number from 0.5 to 10"),
    "too large": ("participation: 1.5", "participation is 1.5; allowed: a number from 1e-06 to 1"),
    "a word": ("truncation: wide", "truncation is 'wide'; allowed: a number"),
    "500 digits": ("truncation: " + "9" * 500, "truncation is 999"),
    "an unknown interpretation": (
        "film_load: solid",
        "film_load is 'solid'; allowed: fluid, total",
    ),
    "a number for a truth value": (
        "summit_offset: 1",
        "summit_offset is 1; allowed: True, as_rough, False",
    ),
    "an entry without value": ("ball_radius: {unit: m}", "ball_radius"),
    "a ball smaller than the interface": (
        "{ball_radius: 5.0e-4, apparent_area: 4.0e-6}",
        "apparent_area is 4e-06; allowed: at most 7.85e-07 m2, the cross-section of a ball",
    ),
    "another unit": ("ball_radius: {value: 6.35, unit: mm}", "ball_radius"),
    "a number for all inputs": (calibrated("5"), "inputs is 5; allowed: keys with values"),
    "a calibrated input out of bounds": (
        calibrated("{truncation: 99}"),
        "inputs.truncation is 99; allowed: a number from 0.5 to 10",
    ),
    "an unknown calibrated input": (
        calibrated("{truncatoin: 2.0}"),
        "inputs: unknown key 'truncatoin'; allowed: truncation, ",
    ),
    "a member of the ensemble out of bounds": (
        calibrated("{truncation: 2.0}", "{participation: 1.5}"),
        "ensemble[0].participation is 1.5; allowed: a number from 1e-06 to 1",
    ),
    "inputs of no interpretation": ("inputs: {truncation: 2.0}", "key 'interpretation' is missing"),
}


@pytest.mark.parametrize("case", BAD_INPUTS)
def test_a_bad_input_is_refused_with_file_and_key(write, case):
    content, told = BAD_INPUTS[case]
    path = write(content)
    message = refusal(load_parameters, path)
    assert message.startswith(f"{path}: ")
    assert told in message


@pytest.mark.parametrize("path", sorted((CONFIG / "calibrated").iterdir()), ids=lambda p: p.stem)
def test_each_shipped_calibrated_file_is_valid(path):
    assert read_calibrated(path)["interpretation"] == path.stem


def test_a_calibrated_file_gives_all_that_is_calibrated(write, defaults):
    names = {name for name, entry in read_entries().items() if "value" not in entry}
    found = {name: value for name, value in defaults.as_dict().items() if name in names}
    path = write(calibrated(json.dumps(found | {"truncation": 2.5})))
    assert load_parameters(path) == replace(defaults, truncation=2.5)
    del found["apparent_area"]
    lacks = refusal(load_parameters, write(calibrated(json.dumps(found))))
    assert lacks.endswith(
        "inputs: apparent_area is missing; allowed: a value of each calibrated input"
    )


def test_the_default_inputs_do_not_depend_on_the_working_directory(defaults, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert load_parameters() == defaults
    assert config_directory().is_absolute()


# ---- settings of the workflow


def test_the_shipped_configuration_is_valid(shipped, from_root):
    settings = workflow_settings(shipped, CONFIG)
    assert settings["parameters"] == load_parameters().as_dict()
    assert settings["calibrated"] == shipped["calibrated"]
    assert settings["inputs"] == {}


def test_inputs_of_the_configuration_are_laid_over_the_calibrated_file(shipped, from_root):
    settings = workflow_settings(changed(shipped, "inputs", {"hardness_surface_1": 3.0e9}), CONFIG)
    assert settings["parameters"] == load_parameters(hardness_surface_1=3e9).as_dict()
    assert settings["calibrated"] == shipped["calibrated"]
    assert settings["inputs"] == {"hardness_surface_1": 3e9}


def test_another_calibrated_file_takes_the_place_of_the_first(shipped, from_root):
    other = "config/calibrated/uncentred_summit_wide_full.yaml"
    for key in ("inputs", "calibrated"):
        settings = workflow_settings(changed(shipped, key, other), CONFIG)
        assert settings["parameters"] == load_parameters(other).as_dict()
        assert settings["calibrated"] == other
        assert settings["inputs"] == {}


def test_each_scene_carries_all_that_it_depends_on(shipped, from_root):
    scenes = workflow_settings(shipped, CONFIG)["scenes"]
    for scene in scenes.values():
        assert scene["load_axis"] == shipped["load_axis"]
        assert scene["rtol"] == shipped["rtol"]
    own = changed(shipped, "scenes.fig03.rtol", 1e-3)
    own = changed(own, "scenes.fig03.load_axis", {"load_N": [1.0, 2.0], "count": 7})
    scene = workflow_settings(own, CONFIG)["scenes"]["fig03"]
    assert scene["rtol"] == 1e-3
    assert scene["load_axis"]["count"] == 7


BAD_SETTINGS = {
    "an unknown key": ("extra", 1, "unknown key 'extra'; allowed: "),
    "a missing key": ("rtol", KeyError, "key 'rtol' is missing"),
    "a misspelt curve key": (
        "scenes.fig04.curves.1.viscosity",
        [1],
        "scenes.fig04.curves[1]: unknown key 'viscosity'",
    ),
    "a scene without curves": ("scenes.fig03.curves", KeyError, "scenes.fig03: key 'curves'"),
    "a scene's name with a path": ("scenes.../x", {}, "scenes"),
    "rtol too small": ("rtol", 1e-12, "rtol is 1e-12; allowed: at least 1e-11"),
    "a negative load": (
        "load_axis.load_N",
        [-1.0, 80.0],
        "load_axis.load_N[0] is -1.0; allowed: above 0",
    ),
    "loads the wrong way": ("load_axis.load_N", [80.0, 0.04], "load_axis.load_N is [80.0, 0.04]"),
    "a negative viscosity": (
        "scenes.fig04.curves.0.viscosity_cSt",
        [-1],
        "scenes.fig04.curves[0].viscosity_cSt[0] is -1; allowed: at least 0",
    ),
    "a value twice": (
        "scenes.fig04.curves.0.viscosity_cSt",
        [10, 10],
        "scenes.fig04.curves[0].viscosity_cSt is [10, 10]; allowed: no value twice",
    ),
    "both kinds of diameter": (
        "scenes.fig04.curves.0.particle_diameter_per_roughness",
        [1.0],
        "scenes.fig04.curves[0] is",
    ),
    "no diameter": (
        "scenes.fig04.curves.0.particle_diameter_nm",
        KeyError,
        "allowed: either particle_diameter_nm or particle_diameter_per_roughness",
    ),
    "more particles than there is room for": (
        "scenes.fig04.curves.0.particle_density_per_m2",
        [1.0e13],
        "cover 1.96 of the interface; allowed: at most 1",
    ),
    "inputs outside the configuration": ("inputs", "/etc/passwd", "inputs is '/etc/passwd'"),
    "an input out of its bounds": (
        "inputs",
        {"truncation": 99},
        "inputs.truncation is 99; allowed: a number from 0.5 to 10",
    ),
    "a number for all inputs": (
        "inputs",
        5,
        "inputs is 5; allowed: inputs with their values, or the path",
    ),
    "a calibrated file that is none": (
        "calibrated",
        "config/inputs.yaml",
        "config/inputs.yaml: unknown key 'elastic_modulus_surfaces'; allowed: acceptable",
    ),
    "a scene with a figure's name": ("scenes.fig14", {}, "'fig14'"),
    "a number that YAML takes for text": (
        "scenes.fig03.curves.0.particle_density_per_m2",
        ["1e11"],
        "reads from 1.0e+11",
    ),
}


@pytest.mark.parametrize("case", BAD_SETTINGS)
def test_bad_settings_are_refused_in_one_line_that_names_the_key(shipped, from_root, case):
    key, value, told = BAD_SETTINGS[case]
    if key == "scenes.../x":
        bad = copy.deepcopy(shipped)
        bad["scenes"]["../x"] = bad["scenes"]["fig03"]
    else:
        bad = changed(shipped, key, value)
    assert told in refusal(workflow_settings, bad, CONFIG)


def test_a_long_value_is_shortened_in_the_message(shipped, from_root):
    bad = changed(shipped, "rtol", "x" * 10000)
    assert len(refusal(workflow_settings, bad, CONFIG)) < 200


def test_coverage_counts_diameters_relative_to_the_roughness(shipped, from_root):
    bad = changed(shipped, "scenes.fig13.curves.0.particle_diameter_per_roughness", [500.0])
    assert "scenes.fig13.curves[0]: particles of 50000 nm" in refusal(
        workflow_settings, bad, CONFIG
    )


def test_settings_leave_the_given_configuration_alone(shipped, from_root):
    before = copy.deepcopy(shipped)
    workflow_settings(shipped, CONFIG)
    assert shipped == before
