"""The schemas of the configuration: closed, described, bounded, and their rules."""

from pathlib import Path

import pytest

from thirdbody.configuration.schema import read_schema, validate

CONFIG = Path(__file__).parents[2] / "config"
SCHEMAS = sorted(path.name.removesuffix(".schema.yaml") for path in CONFIG.glob("*.schema.yaml"))
ALTERNATIVES = ("if", "then", "else", "allOf", "anyOf", "oneOf", "not")
every_schema = pytest.mark.parametrize("kind", SCHEMAS)


def schema_nodes(node, place="", alternatives=True):
    """Every mapping in a JSON Schema that describes a value."""
    if isinstance(node, dict):
        if isinstance(node.get("type"), str | list) or isinstance(node.get("properties"), dict):
            yield place, node
        for key, item in node.items():
            if alternatives or key not in ALTERNATIVES:
                yield from schema_nodes(item, f"{place}.{key}", alternatives)
    elif isinstance(node, list):
        for index, item in enumerate(node):
            yield from schema_nodes(item, f"{place}[{index}]", alternatives)


@every_schema
def test_it_is_closed_everywhere(kind):
    for place, node in schema_nodes(read_schema(kind), alternatives=False):
        if node.get("type") == "object":
            closed = node.get("additionalProperties") is False or "propertyNames" in node
            assert closed, place


BOUNDED = {
    "number": [{"minimum", "exclusiveMinimum"}, {"maximum", "exclusiveMaximum"}],
    "integer": [{"minimum"}, {"maximum"}],
    "array": [{"maxItems"}],
    "string": [{"maxLength", "pattern"}],
}


@every_schema
def test_each_value_is_bounded(kind):
    for place, node in schema_nodes(read_schema(kind)):
        if (
            ".if" in place
            or place.endswith(".allowed.items")
            or ".interpretation.properties" in place
        ):
            continue  # words that inputs.yaml itself lists
        types = node.get("type", [])
        for name in [types] if isinstance(types, str) else types:
            for bounds in BOUNDED.get(name, []):
                assert bounds & set(node), f"{place}: {name}"


# ---- rules


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
    "contradictions_are_settled, by one that stands aside": (
        [{"id": "a", "contradicts": ["b"]}, {"id": "b", "contradicts": ["a"]}],
        "range[0].contradicts[0] is 'b'; allowed: a statement that stands aside, or this one does",
    ),
    "unknowns_are_listed": (
        {"unknowns": {"a": 1}, "always": ["a"], "interpretations": {"r": {"unknowns": ["b"]}}},
        "range.interpretations.r.unknowns[0] is 'b'; allowed: a",
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
        "range.charts.load_N[2] is 6; allowed: a value of axes.load_N, to which also can add it",
    ),
}


@pytest.mark.parametrize("case", BROKEN)
def test_a_broken_rule_is_told_with_key_value_and_what_is_allowed(case):
    content, told = BROKEN[case]
    schema = {"properties": {"range": {"rules": [case.partition(",")[0]]}}}
    assert refusal(schema, {"range": content}) == f"given.yaml: {told}"


def test_rules_are_asked_only_where_the_rest_is_right():
    ends = {"type": "array", "items": {"type": "number"}, "rules": ["first_below_last"]}
    schema = {"properties": {"a": ends, "b": ends}}
    assert refusal(schema, {"a": [2, 1], "b": ["x", 1]}).startswith("given.yaml: b[0] is 'x'")
    assert refusal(schema, {"a": [2, 1], "b": [0, 1]}).startswith("given.yaml: a is [2, 1]")


# ---- messages


def test_an_entry_goes_by_its_id_if_that_is_fit_to_be_shown():
    schema = {"items": {"required": ["b"]}}
    missing = "key 'b' is missing; allowed: it must be given"
    assert refusal(schema, [{"id": "some-id"}]) == f"given.yaml: some-id: {missing}"
    assert refusal(schema, [{"id": "a\nb"}]) == f"given.yaml: [0]: {missing}"


@pytest.mark.parametrize("value", [float("nan"), float("inf"), True, "1", None])
def test_a_number_is_finite_and_no_truth_value(value):
    told = refusal({"properties": {"a": {"type": "number"}}}, {"a": value})
    assert told.startswith(f"given.yaml: a is {value!r}; allowed: ")
