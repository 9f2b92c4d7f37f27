"""YAML that is read, and inputs of a user laid over the calibrated ones."""

import copy
import math
import pickle
from dataclasses import replace

import pytest
import yaml

from chenhorng.home import config_directory
from thirdbody.bearings import FORMULAS, bearing
from thirdbody.core.parameters import Parameters
from thirdbody.files import read_yaml
from thirdbody.inputs import CALIBRATED_FILE, load_parameters
from thirdbody.points import solve

CALIBRATED = config_directory() / "calibrated"


@pytest.fixture
def write(tmp_path):
    """Writes a configuration file and gives its path."""

    def write_file(content, name="given.yaml"):
        path = tmp_path / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    return write_file


def refusal(function, *given):
    """The one line with which ``function`` refuses."""
    with pytest.raises(ValueError) as refused:
        function(*given)
    message = str(refused.value)
    assert message and "\n" not in message
    return message


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
]


@pytest.mark.parametrize(("content", "expected"), STRICT, ids=range(len(STRICT)))
def test_yaml_that_is_more_or_less_than_plain_data_is_refused(write, content, expected):
    path = write(content)
    message = refusal(read_yaml, path)
    assert message.startswith(f"{path}: ") and expected in message


@pytest.mark.parametrize("path", [".", "no/such/folder/given.yaml"])
def test_a_file_that_cannot_be_read_is_named(tmp_path, path):
    message = refusal(read_yaml, tmp_path / path)
    assert f"{tmp_path / path}" in message and "allowed: a readable YAML file" in message


def test_plain_data_are_read(write):
    content = "a: 1\nb: &b [1.5, two]\nc: {d: true, e: *b}\n"
    expected = {"a": 1, "b": [1.5, "two"], "c": {"d": True, "e": [1.5, "two"]}}
    assert read_yaml(write(content)) == expected
    assert read_yaml(write(b"\xef\xbb\xbf" + content.encode())) == expected


@pytest.mark.parametrize("typed", ["0300", "1:30", "0x1F", "-017", "1:30.5"])
def test_numbers_of_other_bases_are_refused_as_they_were_typed(tmp_path, typed):
    path = tmp_path / "mine.yaml"
    path.write_text(f"roughness_nm: [{typed}]\n")
    with pytest.raises(ValueError, match=f"line 1: number {typed}; allowed: decimal numbers"):
        read_yaml(path)
    path.write_text("a: [300, 0, 0.5, -3, 1.0e+11]\n")
    assert read_yaml(path) == {"a": [300, 0, 0.5, -3, 1e11]}


# ---- inputs


@pytest.mark.filterwarnings("ignore:.* is changed without")
def test_single_inputs_win_over_a_file_and_a_file_over_the_calibrated_inputs(write, defaults):
    path = write("truncation: 3.0\nellipticity: 2.0\nfilm_load: total\n")
    expected = replace(defaults.best, truncation=4.0, ellipticity=2.0, film_load="total")
    assert load_parameters(path, truncation=4).best == expected


def test_inputs_are_floats_however_they_are_given(write):
    inputs = load_parameters(write("truncation: 3\n"), participation=1)
    assert type(inputs.truncation) is type(inputs.participation) is float


@pytest.mark.parametrize(
    "inputs",
    [
        {"truncatoin": 2.0},
        {"truncation": -1.0},
        {"truncation": math.nan},
        {"film_load": "solid"},
        {"ball_radius": 5.0e-4, "apparent_area": 4.0e-6},
        {"ball_radius": 6.35},
    ],
)
def test_a_bad_input_is_refused_by_name_from_a_file_and_alone(write, inputs):
    name = next(iter(inputs))
    for arguments in (((), inputs), ((write(yaml.safe_dump(inputs)),), {})):
        positional, named = arguments
        with pytest.raises(ValueError, match=f"({name}|apparent_area).*; allowed: "):
            load_parameters(*positional, **named)


@pytest.mark.parametrize("value", ["wide", True, "1e9", None, [1.0, 2.0], {"value": 2.0}])
def test_what_is_no_number_is_refused(write, value):
    with pytest.raises((TypeError, ValueError)):
        load_parameters(write(yaml.safe_dump({"truncation": value})))


@pytest.mark.parametrize("path", sorted(CALIBRATED.glob("*.yaml")), ids=lambda path: path.stem)
def test_each_calibrated_file_has_all_inputs_and_its_own_ensemble(path):
    content = read_yaml(path)
    assert content["interpretation"] == path.stem
    inputs = load_parameters(path)
    assert inputs.best.as_dict() == {name: content["inputs"][name] for name in Parameters.names()}
    members = [Parameters(**content["inputs"] | member) for member in content["ensemble"]]
    assert inputs.members == tuple(members)


def test_the_default_is_that_of_the_workflow():
    path = config_directory().parent / read_yaml(config_directory() / "config.yaml")["calibrated"]
    assert read_yaml(CALIBRATED_FILE).items() <= read_yaml(path).items()


def test_a_calibrated_file_replaces_the_default_and_must_be_whole(write, defaults):
    content = {"inputs": defaults.best.as_dict() | {"truncation": 2.5}, "ensemble": [{}]}
    expected = replace(defaults.best, truncation=2.5)
    assert load_parameters(write(yaml.safe_dump(content))).members == (expected,)
    del content["inputs"]["apparent_area"]
    with pytest.raises(TypeError, match="apparent_area"):
        load_parameters(write(yaml.safe_dump(content)))


def test_the_default_inputs_do_not_depend_on_the_working_directory(defaults, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert load_parameters() == defaults
    assert config_directory().is_absolute()


# ---- the setup: what a user gave, and the inputs do not say

INTERFACE = {
    "load_N": 10.0,
    "viscosity_cSt": 90.0,
    "particle_diameter_nm": 500.0,
    "roughness_nm": 300.0,
    "particle_density_per_m2": 1e11,
}
OWN = {"speed_m_per_s": 2.0, "oil_density_kg_per_m3": 870.0, "ball": "silicon nitride"}


@pytest.mark.parametrize(
    "operation",
    [
        lambda inputs, write: inputs.changed(truncation=3.0),
        lambda inputs, write: replace(inputs, members=inputs.members[:2]),
        lambda inputs, write: load_parameters(**inputs.as_dict()),
        lambda inputs, write: load_parameters(write(yaml.safe_dump(inputs.known()))),
        lambda inputs, write: bearing(inputs, apparent_area_mm2=4.0),
        lambda inputs, write: bearing(inputs, ball_radius_mm=3.0),
        lambda inputs, write: load_parameters(
            write(yaml.safe_dump(calibrated(inputs) | {"setup": inputs.setup.as_dict()}))
        ),
        lambda inputs, write: load_parameters(setup=inputs.setup).changed(
            **{name: getattr(inputs, name) for name in FORMULAS}
        ),
        lambda inputs, write: pickle.loads(pickle.dumps(inputs)),
        lambda inputs, write: copy.copy(inputs),
        lambda inputs, write: copy.deepcopy(inputs),
        lambda inputs, write: next(iter(inputs)),
    ],
)
def test_each_operation_keeps_the_setup(write, operation):
    inputs = bearing(**OWN)
    kept = operation(inputs, write)
    assert kept.setup == inputs.setup == load_parameters(setup=inputs.setup).setup
    assert kept.setup.oil_density_kg_per_m3 == 870.0
    assert kept.setup.ball.hardness_GPa == 15.0
    assert kept.speed == pytest.approx(2.0)


def test_a_set_of_inputs_alone_has_no_oil_and_none_is_assumed():
    inputs = replace(bearing(**OWN).best, truncation=3.0)
    with pytest.raises(ValueError, match="the density of the oil is unknown"):
        solve(**INTERFACE, speed_m_per_s=4.0, parameters=inputs)


def test_an_answer_at_another_speed_does_not_depend_on_how_inputs_are_passed_on(write):
    inputs = bearing(**OWN)
    written = load_parameters(write(yaml.safe_dump(inputs.known())))
    passed = load_parameters(**inputs.as_dict())
    answers = [
        solve(**INTERFACE, speed_m_per_s=4.0, parameters=each).solid_load_fraction
        for each in (inputs, written, passed, inputs.changed())
    ]
    other = bearing(**OWN | {"speed_m_per_s": 4.0})
    assert answers == [pytest.approx(solve(**INTERFACE, parameters=other).solid_load_fraction)] * 4


def test_each_way_to_change_an_input_warns_alike(write):
    ways = [
        lambda: load_parameters(ball_radius=3e-3),
        lambda: load_parameters().changed(ball_radius=3e-3),
        lambda: load_parameters(write("ball_radius: 3.0e-3")),
    ]
    messages = []
    for way in ways:
        with pytest.warns(UserWarning) as warned:
            way()
        messages.append([str(each.message) for each in warned])
    assert messages == [messages[0]] * 3
    assert "ball_radius is changed without speed_per_viscosity" in messages[0][0]


def test_a_file_of_inputs_is_read_as_it_was_written(write):
    inputs = bearing(**OWN)
    assert load_parameters(write(yaml.safe_dump(inputs.known()))) == inputs


def test_other_oils_are_other_inputs():
    one, other = (bearing(**OWN | {"oil_density_kg_per_m3": rho}) for rho in (870.0, 435.0))
    twice = bearing(other, speed_m_per_s=4.0, oil_density_kg_per_m3=435.0)
    assert twice.members == one.members and twice != one


def calibrated(inputs):
    """The content of a calibrated file of one member."""
    return {"inputs": inputs.best.as_dict(), "ensemble": [{}]}


@pytest.mark.parametrize(
    ("content", "expected"),
    [
        ("setup: {oil: 870}", "setup has oil; allowed: ball, flat, particle, oil_den"),
        ("setup: 870", "setup is 870; allowed: ball, flat, particle, oil_den"),
        ("setup: {ball: steel}", "ball is 'steel'; allowed: modulus_GPa, poisson_ratio"),
        ("setup: {ball: {modulus: 205}}", "ball has modulus; allowed: modulus_GPa"),
        ("setup: {oil_density_kg_per_m3: [870]}", "oil_density_kg_per_m3 is [870]; allowed: one"),
        ("film_load: 5", "film_load is 5; allowed: fluid, total"),
        ("film_load: [fluid]", "film_load is ['fluid']; allowed: fluid, total"),
        ("truncation: [3.0]", "truncation is [3.0]; allowed: one number"),
        ("inputs: {truncation: 3.0}", "these are not calibrated inputs; allowed: inputs"),
        ("{inputs: 3, ensemble: [{}]}", "these are not calibrated inputs; allowed: inputs"),
        ("{inputs: {}, ensemble: [3]}", "these are not calibrated inputs; allowed: inputs"),
    ],
)
def test_a_value_of_another_type_is_refused_in_one_line(write, content, expected):
    assert refusal(load_parameters, write(content)).startswith(expected)
