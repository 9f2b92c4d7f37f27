"""Configuration that is refused, each in one line that names the place, and what is accepted."""

import copy
import math
import shutil
from dataclasses import fields, replace
from pathlib import Path

import pytest
import yaml

from thirdbody.core.parameters import Parameters
from thirdbody.inputs import load_parameters, read_calibrated, read_entries
from thirdbody.paper.configuration.schema import read_schema
from thirdbody.paper.configuration.settings import read_settings, workflow_settings
from thirdbody.plain_yaml import config_directory, read_yaml

ROOT = Path(__file__).parents[2]
CONFIG = ROOT / "config"
CALIBRATED = read_yaml(CONFIG / "config.yaml")["calibrated"]
SHIPPED = sorted(f"config/calibrated/{path.name}" for path in (CONFIG / "calibrated").iterdir())


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
    assert message and "\n" not in message
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


STRICT = [
    ("a: 1\nb: 2\na: 3", "line 3: duplicate key 'a'"),
    ("a: {<<: {b: 1}}", "line 1"),
    ("a: !!python/object/apply:os.system [ls]", "python/object/apply:os.system'"),
    ("a: !secret b", "tag '!secret'"),
    ("1: a", "line 1: key 1; allowed: strings"),
    ("on: a", "line 1: key True; allowed: strings"),
    ("a: 1\n---\nb: 2", "another document"),
    ("a: [1\n", "line 2: did not find expected ',' or ']'"),
    ("a:\n\t- 1", "line 2"),
    ("a: 1\x07", "not allowed"),
    (b"a: \xff", "byte 3 is not UTF-8"),
    ("a: 1".encode("utf-16"), "not UTF-8"),
    ("", "contains NoneType; allowed: keys with values"),
    ("- a", "contains list; allowed: keys with values"),
    ("a: " + "9" * 5000, "digits"),
    ("a: " + "[" * 5000, "line 1: nested more than 20 levels deep"),
    ("a: &b [*b]", "line 1: alias *b in what it names"),
    (f"a: {'x' * 1_000_000}", "has more than 1000000 bytes"),
]


@pytest.mark.parametrize(("content", "expected"), STRICT, ids=range(len(STRICT)))
def test_yaml_that_is_more_or_less_than_plain_data_is_refused(write, content, expected):
    path = write(content)
    message = refusal(read_yaml, path)
    assert message.startswith(f"{path}: ") and expected in message


def test_aliases_that_repeat_aliases_are_refused_before_they_are_replaced(write):
    lines = ["a: &b0 [1]", *(f"a{n}: &b{n} [{f'*b{n - 1}, ' * 10}]" for n in range(1, 10))]
    message = refusal(read_yaml, write("\n".join(lines)))
    assert "line 6: more than 100000 values, with what aliases repeat" in message


@pytest.mark.parametrize("path", [".", "no/such/folder/given.yaml"])
def test_a_file_that_cannot_be_read_is_named(tmp_path, path):
    message = refusal(read_yaml, tmp_path / path)
    assert f"{tmp_path / path}" in message and "allowed: a readable YAML file" in message


def test_plain_data_are_read(write):
    content = "a: 1\nb: &b [1.5, two]\nc: {d: true, e: *b}\n"
    expected = {"a": 1, "b": [1.5, "two"], "c": {"d": True, "e": [1.5, "two"]}}
    assert read_yaml(write(content)) == expected
    assert read_yaml(write(b"\xef\xbb\xbf" + content.encode())) == expected


def test_a_template_that_runs_code_is_refused(write, from_root):
    path = write("__use_yte__: true\nrtol: 1.0e-9\n")
    message = refusal(read_settings, {"changes": str(path)}, CONFIG)
    assert "('__use_yte__' was unexpected)" in message


def test_the_inputs_have_an_entry_for_each_field_and_no_other():
    names = {field.name for field in fields(Parameters) if field.init}
    schema = read_schema("inputs")
    assert set(read_entries()) == set(schema["properties"]) == set(schema["required"]) == names


@pytest.mark.filterwarnings("ignore:.* is changed without")
def test_single_inputs_win_over_a_file_and_a_file_over_the_calibrated_inputs(write, defaults):
    path = write("truncation: 3.0\nmean_ratio: 0.5\nfilm_load: {value: total}\n")
    expected = replace(defaults, truncation=4.0, mean_ratio=0.5, film_load="total")
    assert load_parameters(path, truncation=4) == expected


def test_a_bad_single_input_is_refused_by_name():
    message = refusal(lambda: load_parameters(truncation=math.nan))
    assert message == "load_parameters: truncation is nan; allowed: a number from 0.5 to 10"


def test_a_copy_of_the_projects_file_leaves_the_calibrated_inputs(defaults):
    assert load_parameters(CONFIG / "inputs.yaml") == defaults


def calibrated(inputs, member="{truncation: 2.0}"):
    """Text of a calibrated file."""
    return (
        "interpretation: some\nobjective: 70.5\npenalty: 0.5\nidentification: {}\n"
        f"inputs: {inputs}\nensemble: [{member}]\n"
    )


ALLOWED = "allowed: a number from 1e-06 to 1"
BAD_INPUTS = [
    ("truncatoin: 2.0", "truncatoin"),
    ("truncation: -1.0", "truncation is -1.0; allowed: a number from 0.5 to 10"),
    ("truncation: wide", "truncation is 'wide'; allowed: a number from 0.5 to 10"),
    ("truncation: " + "9" * 500, "truncation is 999"),
    ("film_load: solid", "film_load: 'solid' is not one of ['fluid', 'total']"),
    ("summit_offset_ratio: true", "summit_offset_ratio is True; allowed: a number from 0 to 5"),
    ("{ball_radius: 5.0e-4, apparent_area: 4.0e-6}", "at most 7.85e-07 m2, the cross-section of a"),
    ("ball_radius: 6.35", "ball_radius is 6.35; allowed: a number from 1e-06 to 1 m"),
    ("ball_radius: {value: 6.35, unit: mm}", "ball_radius"),
    (calibrated("5"), "inputs: 5 is not of type 'object'"),
    (
        calibrated("{truncatoin: 2.0}"),
        "inputs: Additional properties are not allowed ('truncatoin' was",
    ),
    (calibrated("{}", "{participation: 1.5}"), f"ensemble[0].participation is 1.5; {ALLOWED}"),
    ("inputs: {truncation: 2.0}", "'interpretation' is a required property"),
]


@pytest.mark.parametrize(("content", "expected"), BAD_INPUTS)
def test_a_bad_input_is_refused_with_file_and_key(write, content, expected):
    path = write(content)
    message = refusal(load_parameters, path)
    assert message.startswith(f"{path}: ") and expected in message


@pytest.mark.parametrize("path", SHIPPED)
def test_each_shipped_calibrated_file_is_valid(path):
    assert read_calibrated(ROOT / path)["interpretation"] == Path(path).stem


def test_the_default_is_among_the_shipped_files():
    assert CALIBRATED in SHIPPED


def in_line(inputs):
    """Inputs as YAML on one line; of JSON, YAML reads 3e-06 as text."""
    return yaml.safe_dump(inputs, default_flow_style=True, width=10_000).strip()


def test_a_calibrated_file_gives_all_that_is_calibrated(write, defaults):
    names = {name for name, entry in read_entries().items() if "value" not in entry}
    found = {name: value for name, value in defaults.as_dict().items() if name in names}
    path = write(calibrated(in_line(found | {"truncation": 2.5})))
    assert load_parameters(path) == replace(defaults, truncation=2.5)
    del found["apparent_area"]
    lacks = refusal(load_parameters, write(calibrated(in_line(found))))
    assert lacks.endswith("inputs: 'apparent_area' is a required property")


def test_the_default_inputs_do_not_depend_on_the_working_directory(defaults, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert load_parameters() == defaults
    assert config_directory().is_absolute()


@pytest.mark.parametrize("inputs", [{}, {"hardness_surface_1": 3.0e9}])
def test_inputs_are_laid_over_the_calibrated_file(shipped, from_root, inputs):
    before = copy.deepcopy(shipped)
    settings = workflow_settings(shipped | {"inputs": inputs}, CONFIG)
    assert settings["parameters"] == load_parameters(**inputs).as_dict()
    assert settings["calibrated"] == shipped["calibrated"]
    assert settings["inputs"] == inputs
    assert shipped == before


@pytest.mark.parametrize("other", [path for path in SHIPPED if path != CALIBRATED][:2])
def test_another_calibrated_file_takes_the_place_of_the_first(shipped, from_root, other):
    for key in ("inputs", "calibrated"):
        settings = workflow_settings(changed(shipped, key, other), CONFIG)
        assert settings["parameters"] == load_parameters(other).as_dict()
        assert settings["calibrated"] == other
        assert settings["inputs"] == {}
        members = [Parameters(**settings["parameters"] | each) for each in settings["ensemble"]]
        assert load_parameters(other).members == tuple(members)


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


FIRST = "scenes.fig04.curves.0"
BAD_SETTINGS = [  # the way to a key, its value, and what the line says
    ("rtol", KeyError, "'rtol' is a required property"),
    ("rtol", 1e-12, "rtol: 1e-12 is less than the minimum of 1e-11"),
    ("rtol", "x" * 10000, "rtol: 'xxx"),  # shortened
    (
        "load_axis.load_N",
        [4e-9, 8.0],
        "load_axis.load_N[0]: 4e-09 is less than the minimum of 1e-07",
    ),
    ("load_axis.load_N", [80.0, 0.04], "load_axis.load_N is [80.0, 0.04]"),
    ("scenes.fig03.curves", KeyError, "scenes.fig03: 'curves' is a required property"),
    ("scenes.fig14", {}, "'fig14'"),  # a figure's name
    ("scenes.mine/x", {}, "mine/x"),
    (
        f"{FIRST}.viscosity",
        [1],
        "scenes.fig04.curves[0]: Additional properties are not allowed ('viscosity'",
    ),
    (
        f"{FIRST}.viscosity_cSt",
        [-1],
        "curves[0].viscosity_cSt[0]: -1 is less than the minimum of 0",
    ),
    (f"{FIRST}.viscosity_cSt", [0.08], "viscosity_cSt[0]: 0.08 is less than the minimum of 0.3"),
    (f"{FIRST}.particle_diameter_nm", [5e-7], "5e-07 is less than the minimum of 1"),
    (f"{FIRST}.particle_density_per_m2", [11], "11 is less than the minimum of 1000000"),
    (f"{FIRST}.viscosity_cSt", [10, 10], "viscosity_cSt: [10, 10] has non-unique elements"),
    (f"{FIRST}.particle_diameter_nm", KeyError, "allowed: either particle_diameter_nm or "),
    (f"{FIRST}.particle_density_per_m2", [1.0e13], "cover 1.96 of the interface; allowed: at"),
    (f"{FIRST}.particle_density_per_m2", ["1e11"], "[0]: '1e11' is not of type 'number'"),
    ("scenes.fig13.curves.0.particle_diameter_per_roughness", [500.0], "particles of 50000 nm"),
    ("inputs", "/etc/passwd", "inputs is '/etc/passwd'"),
    ("inputs", 5, "inputs is 5; allowed: inputs with their values, or the path"),
    ("calibrated", "config/inputs.yaml", "'interpretation' is a required property"),
]


@pytest.mark.parametrize(("key", "value", "expected"), BAD_SETTINGS)
def test_bad_settings_are_refused_in_one_line_that_names_the_key(
    shipped, from_root, key, value, expected
):
    message = refusal(workflow_settings, changed(shipped, key, value), CONFIG)
    assert expected in message and len(message) < 500


BAD_FILES = [  # of the folder of the configuration
    (
        "config/inputs.yaml",
        "hardness_surface_1",
        KeyError,
        "'hardness_surface_1' is a required property",
    ),
    ("config/scenes.yaml", "load_axis.count", 1, "configuration: load_axis.count: 1 is less than"),
]


@pytest.mark.parametrize(("file", "key", "value", "expected"), BAD_FILES)
def test_a_bad_file_beside_the_configuration_is_named(
    tmp_path, monkeypatch, file, key, value, expected
):
    shutil.copytree(CONFIG, tmp_path / "config")
    monkeypatch.chdir(tmp_path)
    content = changed(read_yaml(tmp_path / file), key, value)
    (tmp_path / file).write_text(yaml.safe_dump(content))
    message = refusal(read_settings, {}, "config")
    assert expected in message


def test_a_scene_too_large_to_be_solved_is_refused(shipped, from_root):
    many = list(range(1, 1001))
    scene = copy.deepcopy(shipped["scenes"]["fig03"])
    scene["curves"][0] |= {"viscosity_cSt": many, "particle_diameter_nm": many}
    message = refusal(workflow_settings, changed(shipped, "scenes.mine", scene), CONFIG)
    assert (
        "scenes.mine: the curves and loads have 2.4e+08 combinations; allowed: at most" in message
    )
    del scene["curves"][0]["particle_diameter_nm"]
    scene["curves"][0]["particle_diameter_per_roughness"] = [each / 50 for each in many]
    assert "2.4e+08" in refusal(workflow_settings, changed(shipped, "scenes.mine", scene), CONFIG)


def test_a_roughness_that_the_inputs_cannot_have_is_refused(shipped, from_root):
    settings = changed(shipped, "inputs", {"summit_parameter_exponent": 1.5})
    settings = changed(settings, "scenes.fig03.curves.0.roughness_nm", [1])
    message = refusal(workflow_settings, settings, CONFIG)
    assert message.startswith(
        "inputs: roughness is 1e-09 m, at which summit_parameter_exponent 1.5"
    )


@pytest.mark.parametrize("name", ["oil_wide", "oil_tpca_loads", "oil_transitions", "claims"])
def test_a_scene_is_not_called_like_another_product(shipped, from_root, name):
    settings = changed(shipped, f"scenes.{name}", shipped["scenes"]["fig03"])
    message = refusal(workflow_settings, settings, CONFIG)
    assert name in message and "allowed: " in message


@pytest.mark.parametrize("typed", ["0300", "1:30", "0x1F", "-017", "1:30.5"])
def test_numbers_of_other_bases_are_refused_as_they_were_typed(tmp_path, typed):
    path = tmp_path / "mine.yaml"
    path.write_text(f"roughness_nm: [{typed}]\n")
    with pytest.raises(ValueError, match=f"line 1: number {typed}; allowed: decimal numbers"):
        read_yaml(path)
    path.write_text("a: [300, 0, 0.5, -3, 1.0e+11]\n")
    assert read_yaml(path) == {"a": [300, 0, 0.5, -3, 1e11]}
