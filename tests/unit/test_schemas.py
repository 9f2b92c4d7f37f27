"""The schemas of the configuration: closed, described, bounded, and their rules."""

from pathlib import Path

import pytest

from thirdbody.configuration.schema import read_schema, validate

CONFIG = Path(__file__).parents[2] / "config"
SCHEMAS = sorted(path.name.removesuffix(".schema.yaml") for path in CONFIG.glob("*.schema.yaml"))


def described(node, place=""):
    """Every mapping in a JSON Schema that describes keys, but those that only add conditions."""
    if isinstance(node, dict):
        if node.get("type") == "object":
            yield place, node
        for key in node.keys() - {"if", "then", "else", "allOf", "anyOf", "oneOf", "not"}:
            yield from described(node[key], f"{place}.{key}")


@pytest.mark.parametrize("kind", SCHEMAS)
def test_it_knows_all_keys_everywhere(kind):
    for place, node in described(read_schema(kind)):
        assert node.get("additionalProperties") is False or "propertyNames" in node, place


def refusal(schema, content):
    with pytest.raises(ValueError) as refused:
        validate(content, schema, "given.yaml")
    return str(refused.value)


AXIS = {"from": 1, "to": 9, "count": 3, "scale": "linear", "also": []}
BROKEN = {
    "first_below_last": ([2.0, 1.0], "range is [2.0, 1.0]; allowed: a first value below the last"),
    "particles_fit": (
        {"particle_diameter_nm": 1000, "roughness_nm": 100, "particle_density_per_m2": 1e13},
        "range: particles of 1000 nm at 1e+13 m-2 cover 7.85 of the interface; allowed: at most 1",
    ),
    "lists_of_equal_length": (
        {"roughness_nm": [1, 2], "viscosity_cSt": [0], "load": 1e-5},
        "range: roughness_nm has 2 values, viscosity_cSt has 1 values; allowed: lists of equal length",
    ),
    "ids_are_unique": ([{"id": "a"}, {"id": "a"}], "range[1].id is 'a'; allowed: an id given once"),
    "contradictions_are_settled": (
        [{"id": "a", "contradicts": ["b"]}, {"id": "b"}],
        "range[0].contradicts[0] is 'b'; allowed: the id of a statement that contradicts this one too",
    ),
    "contradictions_are_settled, by one that is set aside": (
        [{"id": "a", "contradicts": ["b"]}, {"id": "b", "contradicts": ["a"]}],
        "range[0].contradicts[0] is 'b'; allowed: a statement that is set aside, unless this one is",
    ),
    "axis_goes_up": (
        AXIS | {"also": [0, 5, 10]},
        "range.also[2] is 10; allowed: 0, or from 1 to 9",
    ),
    "chunks_have_surfaces": (
        {"axes": {"roughness_nm": AXIS}, "chunks": 4},
        "range.chunks is 4; allowed: at most 3, the number of roughnesses",
    ),
    "charts_lie_on_axes": (
        {"axes": {"load_N": AXIS}, "charts": {"load_N": [1, 5, 6]}},
        "range.charts.load_N[2] is 6; allowed: a value of axes.load_N; its key also can add it",
    ),
}


@pytest.mark.parametrize("case", BROKEN)
def test_a_broken_rule_is_named_with_key_value_and_what_is_allowed(case):
    content, message = BROKEN[case]
    schema = {"properties": {"range": {"rules": [case.partition(",")[0]]}}}
    assert refusal(schema, {"range": content}) == f"given.yaml: {message}"


def test_an_entry_goes_by_its_id_if_that_is_fit_to_be_shown():
    schema = {"items": {"required": ["b"]}}
    missing = "key 'b' is missing; allowed: it must be given"
    assert refusal(schema, [{"id": "some-id"}]) == f"given.yaml: some-id: {missing}"
    assert refusal(schema, [{"id": "a\nb"}]) == f"given.yaml: [0]: {missing}"


@pytest.mark.parametrize("value", [float("nan"), float("inf"), True, "1", None])
def test_a_number_is_finite_and_no_truth_value(value):
    message = refusal({"properties": {"a": {"type": "number"}}}, {"a": value})
    assert message.startswith(f"given.yaml: a is {value!r}; allowed: ")
