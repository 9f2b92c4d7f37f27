"""The schemas of the configuration: closed, described, bounded, and their rules; and what each file satisfies.

Files that users change are validated at each start; those that only developers edit are validated here, by the
schemas in ``tests/schemas``.
"""

from pathlib import Path

import pytest

from chenhorng.configuration import schema
from chenhorng.configuration.schema import validate
from thirdbody.core.parameters import Parameters
from thirdbody.plain_yaml import read_yaml

ROOT = Path(__file__).parents[2]
CONFIG = ROOT / "config"
SCHEMAS = {
    path.name.removesuffix(".schema.yaml"): read_yaml(path)
    for folder in (Path(schema.__file__).parent, ROOT / "tests/schemas")
    for path in sorted(folder.glob("*.schema.yaml"))
}
DEVELOPED = {
    **{name: [CONFIG / f"{name}.yaml"] for name in ("calibration", "paper_tables", "sensitivity")},
    "accuracy": sorted(CONFIG.glob("accuracy*.yaml")),
    "calibrated": sorted(CONFIG.glob("calibrated/*.yaml")),
}
CLAIMS = read_yaml(CONFIG / "claims.yaml", list)


def described(node, place=""):
    """Every mapping in a JSON Schema that describes keys, but those that only add conditions."""
    if isinstance(node, dict):
        if node.get("type") == "object":
            yield place, node
        for key in node.keys() - {"if", "then", "else", "allOf", "anyOf", "oneOf", "not"}:
            yield from described(node[key], f"{place}.{key}")


@pytest.mark.parametrize("kind", SCHEMAS)
def test_it_knows_all_keys_everywhere(kind):
    for place, node in described(SCHEMAS[kind]):
        assert node.get("additionalProperties") is False or "propertyNames" in node, place


@pytest.mark.parametrize(
    ("kind", "path"),
    [pytest.param(kind, path, id=path.stem) for kind in DEVELOPED for path in DEVELOPED[kind]],
)
def test_a_file_of_the_developers_is_valid(kind, path):
    names = {"enum": Parameters.names()}
    inputs = {"type": "object", "propertyNames": names, "$defs": {"name": names}}
    validate(read_yaml(path), SCHEMAS[kind], path.name, input_values=inputs)


def test_statements_are_valid_and_contradictions_settled():
    validate(CLAIMS, SCHEMAS["claims"], "claims.yaml")
    by_id = {claim["id"]: claim for claim in CLAIMS}
    assert len(by_id) == len(CLAIMS)
    for claim in CLAIMS:
        lengths = {len(value) for value in claim["conditions"].values() if isinstance(value, list)}
        assert len(lengths) <= 1, claim["id"]
        for other in claim.get("contradicts", []):
            assert claim["id"] in by_id[other]["contradicts"]
            assert "aside" in claim or "aside" in by_id[other], (claim["id"], other)


def test_inputs_that_are_searched_have_bounds():
    calibration = read_yaml(CONFIG / "calibration.yaml")
    interpretations = calibration["interpretations"].values()
    searched = [calibration["always"], *(one.get("unknowns", []) for one in interpretations)]
    assert {name for names in searched for name in names} <= calibration["unknowns"].keys()


def test_what_the_calibration_names_is_there():
    calibration = read_yaml(CONFIG / "calibration.yaml")
    assert set(calibration["headline"]) <= {claim["id"] for claim in CLAIMS}
    assert calibration["kept"] <= len(calibration["interpretations"])
    for name in calibration["interpretations"]:
        way = [name]  # to the search from scattered sets, from which all others come in the end
        while nearby := calibration["interpretations"][way[-1]].get("nearby"):
            assert nearby not in way
            way.append(nearby)


def test_each_departure_is_from_the_default():
    calibration, config = (read_yaml(CONFIG / f"{name}.yaml") for name in ("calibration", "config"))
    inputs = read_yaml(ROOT / config["calibrated"])["inputs"]
    for departure in calibration["departures"]:
        for name, value in departure["inputs"].items():
            assert inputs[name] != value, departure["name"]


def refusal(schema, content):
    with pytest.raises(ValueError) as refused:
        validate(content, schema, "given.yaml")
    return str(refused.value)


BROKEN = {
    "first_below_last": ([2.0, 1.0], "range: [2.0, 1.0] does not increase"),
    "particles_fit": (
        {"particle_diameter_nm": 1000, "roughness_nm": 100, "particle_density_per_m2": 1e13},
        "range: particles of 1000 nm at 1e+13 m-2 cover 7.85 of the interface; allowed: at most 1",
    ),
}


@pytest.mark.parametrize("rule", BROKEN)
def test_a_broken_rule_is_named_with_key_value_and_what_is_allowed(rule):
    content, message = BROKEN[rule]
    schema = {"properties": {"range": {"rules": [rule]}}}
    assert refusal(schema, {"range": content}) == f"given.yaml: {message}"


@pytest.mark.parametrize("value", [float("nan"), float("inf"), True, "1", None])
def test_a_number_is_finite_and_no_truth_value(value):
    message = refusal({"properties": {"a": {"type": "number"}}}, {"a": value})
    assert message == f"given.yaml: a: {value!r} is not of type 'number'"


def test_a_long_value_is_cut():
    message = refusal({"properties": {"a": {"type": "number"}}}, {"a": ["word"] * 1000})
    assert message.startswith("given.yaml: a: ['word', ") and len(message) < 120
