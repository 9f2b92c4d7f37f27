"""Configuration that is refused, each in one line that names the place, and what is accepted."""

import copy
import shutil
from pathlib import Path

import pytest
import yaml

from chenhorng.configuration.settings import read_settings, workflow_settings
from thirdbody.core.parameters import BOUNDS, WORDS, Parameters
from thirdbody.core.solve import DEFAULT_RTOL
from thirdbody.files import read_yaml
from thirdbody.inputs import load_parameters

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
    """The configuration of the workflow, complete."""
    return read_settings({}, CONFIG)["config"]


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


def test_a_template_that_runs_code_is_refused(write, from_root):
    path = write("__use_yte__: true\nrtol: 1.0e-9\n")
    message = refusal(read_settings, {"changes": str(path)}, CONFIG)
    assert message.startswith("configuration: __use_yte__ is True; ")


def test_the_inputs_have_an_entry_for_each_field_and_no_other():
    entries = read_yaml(CONFIG / "inputs.yaml")
    assert list(entries) == Parameters.names()
    for name, entry in entries.items():
        assert entry.get("unit") == (BOUNDS[name].unit if name in BOUNDS else None)
        assert entry.get("allowed", []) == list(WORDS.get(name, ()))
        assert ("value" in entry) == (entry["source"] != "calibrated")


def test_a_printed_value_that_the_inputs_were_not_found_with_is_refused(tmp_path, monkeypatch):
    shutil.copytree(CONFIG, tmp_path / "config")
    monkeypatch.chdir(tmp_path)
    content = changed(read_yaml("config/inputs.yaml"), "hardness_surface_1.value", 6.0e9)
    Path("config/inputs.yaml").write_text(yaml.safe_dump(content))
    message = refusal(read_settings, {}, "config")
    assert "hardness_surface_1 is 6e+09; allowed: 5e+09" in message


def test_the_default_is_among_the_shipped_files():
    assert CALIBRATED in SHIPPED


@pytest.mark.parametrize("inputs", [{}, {"hardness_surface_1": 3.0e9}])
def test_inputs_are_laid_over_the_calibrated_file(shipped, from_root, inputs):
    before = copy.deepcopy(shipped)
    settings = workflow_settings(shipped | {"inputs": inputs}, CONFIG)
    assert settings["parameters"] == load_parameters(**inputs).best.as_dict()
    assert settings["calibrated"] == shipped["calibrated"]
    assert settings["inputs"] == inputs
    assert shipped == before


@pytest.mark.parametrize("other", [path for path in SHIPPED if path != CALIBRATED][:2])
def test_another_calibrated_file_takes_the_place_of_the_first(shipped, from_root, other):
    for key in ("inputs", "calibrated"):
        settings = workflow_settings(changed(shipped, key, other), CONFIG)
        assert settings["parameters"] == load_parameters(other).best.as_dict()
        assert settings["calibrated"] == other
        assert settings["inputs"] == {}
        members = [Parameters(**settings["parameters"] | each) for each in settings["ensemble"]]
        assert load_parameters(other).members == tuple(members)


def test_each_scene_carries_all_that_it_depends_on(shipped, from_root):
    scenes = workflow_settings(shipped, CONFIG)["scenes"]
    for scene in scenes.values():
        assert scene["load_axis"] == shipped["load_axis"]
        assert scene["rtol"] == DEFAULT_RTOL  # which no file has
    own = changed(shipped, "scenes.fig03.rtol", 1e-3)
    own = changed(own, "scenes.fig03.load_axis", {"load_N": [1.0, 2.0], "count": 7})
    scene = workflow_settings(own, CONFIG)["scenes"]["fig03"]
    assert scene["rtol"] == 1e-3
    assert scene["load_axis"]["count"] == 7


FIRST = "scenes.fig04.curves.0"
PLAIN_WORD = "allowed: a plain word of small letters, digits and _ that no product has"
BELOW_CONFIG = "allowed: the path of a YAML file below config/"
BAD_SETTINGS = [  # the way to a key, its value, and what the line says
    # a key that is missing, and one that is none
    ("bands", KeyError, "configuration: bands: "),
    ("scenes.fig03.curves", KeyError, "scenes.fig03.curves: "),
    ("scenes.fig03", KeyError, "scenes: fig03 missing; allowed: all figures of the paper"),
    (f"{FIRST}.viscosity", [1], f"{FIRST}.viscosity is [1]; "),
    ("a\nb", 1, "configuration: 'a\\nb' is 1; "),
    # a value of another type
    ("rtol", "x" * 10000, f"rtol is '{'x' * 59}; "),  # shortened
    ("rtol", True, "rtol is True; "),
    ("rtol", None, "rtol is None; "),
    ("rtol", float("nan"), "rtol is nan; "),
    ("rtol", 10**400, "rtol is 1000"),
    ("bands", 1, "bands is 1; "),
    ("load_axis", 3, "load_axis is 3; "),
    ("scenes", [], "scenes is []; "),
    (f"{FIRST}.viscosity_cSt", 90, "viscosity_cSt is 90; "),
    (f"{FIRST}.particle_density_per_m2", ["1e11"], ".0 is '1e11'; "),
    # a number out of bounds
    ("rtol", 1e-12, "rtol is 1e-12; "),
    ("rtol", 3, "rtol is 3; "),
    ("load_axis.load_N", [4e-9, 8.0], "load_axis.load_N.0 is 4e-09; "),
    ("load_axis.load_N", [80.0, 0.04], "[80.0, 0.04]; allowed: numbers that increase"),
    ("load_axis.load_N", [1.0], "load_N is [1.0]; "),
    ("load_axis.count", 1, "load_axis.count is 1; "),
    ("windows.count", 1, "windows.count is 1; "),
    ("schematics.fig01.0.particle_diameter_nm", 0, "is 0; "),
    ("scenes.fig03.named_loads", [2.0], "named_loads.0 is 2.0; "),
    (f"{FIRST}.viscosity_cSt", [-1], "viscosity_cSt.0 is -1; "),
    (f"{FIRST}.viscosity_cSt", [0.08], "viscosity_cSt.0 is 0.08; allowed: 0, or 0.3 or more"),
    (f"{FIRST}.particle_diameter_nm", [5e-7], ".0 is 5e-07; allowed: 0, or 1 or more"),
    (f"{FIRST}.particle_density_per_m2", [11], ".0 is 11; allowed: 0, or 1e+06 or more"),
    # values that do not fit together
    (f"{FIRST}.viscosity_cSt", [10, 10], "viscosity_cSt is [10, 10]; allowed: different values"),
    (f"{FIRST}.viscosity_cSt", [], "viscosity_cSt is []; "),
    (f"{FIRST}.particle_diameter_nm", KeyError, f"{FIRST}: allowed: either particle_diameter_nm"),
    (f"{FIRST}.particle_density_per_m2", [1.0e13], "particles of 500 nm cover 1.96 of the "),
    ("scenes.fig13.curves.0.particle_diameter_per_roughness", [500.0], "particles of 50000 nm"),
    ("schematics.fig02", [], "fig02 is []; "),
    # names and files
    ("scenes.fig14", {}, f"scenes: 'fig14' is no name of a scene; {PLAIN_WORD}"),
    ("scenes.mine/x", {}, f"scenes: 'mine/x' is no name of a scene; {PLAIN_WORD}"),
    ("scenes.fig03.title", "a\nb", "'a\\nb'; allowed: a line of 1 to 200 characters"),
    ("run", "figures", f"run is 'figures'; {PLAIN_WORD}"),
    ("run", "../x", f"run is '../x'; {PLAIN_WORD}"),
    ("calibrated", "config/../x.yaml", f"calibrated is 'config/../x.yaml'; {BELOW_CONFIG}"),
    ("accuracy", "/etc/passwd", f"accuracy is '/etc/passwd'; {BELOW_CONFIG}"),
    ("inputs", "/etc/passwd", "inputs is '/etc/passwd'; allowed: inputs with their values, or"),
    ("inputs", 5, "inputs is 5; allowed: inputs with their values, or the path"),
    ("inputs", {"hardness": 5.0e9}, "inputs: hardness is no input; allowed: "),
    ("inputs", {"truncation": -1.0}, "inputs: truncation is -1.0; allowed: "),
]


@pytest.mark.parametrize(("key", "value", "expected"), BAD_SETTINGS)
def test_bad_settings_are_refused_in_one_line_that_names_the_key(
    shipped, from_root, key, value, expected
):
    message = refusal(workflow_settings, changed(shipped, key, value), CONFIG)
    assert expected in message and len(message) < 600


BAD_FILES = [  # of the folder of the configuration
    ("config/scenes.yaml", "load_axis.count", 1, "configuration: load_axis.count is 1; "),
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


def test_a_scene_whose_figure_has_more_panels_than_letters_is_refused():
    layer = {"viscosity_cSt": [46, 120], "particle_density_per_m2": [1e11]}
    group = layer | {"particle_diameter_nm": [300, 600, 900], "roughness_nm": [100, 200, 300]}
    scenes = {"mine": {"title": "x", "curves": [group]}}
    with pytest.raises(ValueError, match="scenes.mine: the figure has 36 panels, .*allowed: at m"):
        read_settings({"scenes": scenes}, CONFIG)
    group["roughness_nm"] = [100, 200]
    assert "mine" in read_settings({"scenes": scenes}, CONFIG)["scenes"]


def test_a_roughness_that_the_inputs_cannot_have_is_refused(shipped, from_root):
    settings = changed(shipped, "inputs", {"summit_parameter_exponent": 2.0})
    settings = changed(settings, "scenes.fig03.curves.0.roughness_nm", [1])
    message = refusal(workflow_settings, settings, CONFIG)
    assert message.startswith("inputs: roughness is 1e-09 m, at which summit_parameter_exponent 2 ")


@pytest.mark.parametrize("name", ["oil_wide", "oil_tpca_loads", "oil_transitions", "claims"])
def test_a_scene_is_not_called_like_another_product(shipped, from_root, name):
    settings = changed(shipped, f"scenes.{name}", shipped["scenes"]["fig03"])
    message = refusal(workflow_settings, settings, CONFIG)
    assert name in message and "allowed: " in message
