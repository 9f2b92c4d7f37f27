"""Validation of configuration files by the JSON Schema of each kind in ``config/``.

A file ``<kind>.schema.yaml`` is a JSON Schema (draft 2020-12) with two additional keywords:
``rules``, names of functions of ``thirdbody.configuration.rules``, which are called if the document
is otherwise valid; and ``allowed``, words for messages where a number or pattern is not clear
enough.  Definitions in ``conditions.schema.yaml`` serve all files.
"""

import math
import re
from collections.abc import Mapping, Sequence
from difflib import get_close_matches
from functools import cache, reduce
from numbers import Integral, Real
from operator import getitem
from pathlib import Path
from typing import Any

from jsonschema import Draft4Validator, Draft202012Validator, ValidationError
from jsonschema.validators import extend
from referencing import Registry
from referencing.jsonschema import DRAFT202012

from thirdbody.configuration import config_directory, rules
from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.messages import LONGEST, format_path, format_value

MOST_NAMED = 16  # keys in a message
NUMBER = re.compile(r"[-+]?[0-9.]+(e[-+]?[0-9]+)?", re.IGNORECASE)
NOT_A_NUMBER = "; in YAML write 1.0e+11, not 1e11, without quotes, and not in braces after --config"
TYPES = {
    **{"object": "keys with values", "array": "a list", "string": "a string", "number": "a number"},
    **{"integer": "an integer", "boolean": "true or false", "null": "null"},
}
ALLOWED = {
    "const": "{}",
    "minimum": "at least {:g}",
    "maximum": "at most {:g}",
    "exclusiveMinimum": "above {:g}",
    "exclusiveMaximum": "below {:g}",
    "minItems": "at least {} values",
    "maxItems": "at most {} values",
    "uniqueItems": "unique values",
    "minProperties": "at least {} keys",
    "minLength": "at least one character",
    "maxLength": "at most {} characters",
}


def read_valid(path: str | Path, kind: str, **definitions: Mapping) -> Any:
    """The content of a YAML file, validated by ``config/<kind>.schema.yaml``; raises as ``validate``."""
    schema = read_schema(kind)
    content = read_yaml(path, {"object": dict, "array": list}[schema["type"]])
    validate(content, schema, format_path(path), **definitions)
    return content


@cache
def read_schema(kind: str) -> dict:
    """The JSON Schema of one kind of file (cached: do not modify)."""
    return read_yaml(config_directory() / f"{kind}.schema.yaml")


def _is_finite_number(_checker, value) -> bool:
    is_number = isinstance(value, Real) and not isinstance(value, bool)
    return is_number and (isinstance(value, Integral) or math.isfinite(value))


def _call_rules(_validator, names, value, _schema):
    for name in names:
        yield from getattr(rules, name)(value)


# in draft 4 the number 5.0 is not an integer
NUMBERS = Draft4Validator.TYPE_CHECKER.redefine("number", _is_finite_number)
WITHOUT_RULES = extend(Draft202012Validator, type_checker=NUMBERS)
WITH_RULES = extend(WITHOUT_RULES, {"rules": _call_rules})


def validate(content: Any, schema: Mapping, name: str, **definitions: Mapping) -> None:
    """Raise ``ValueError`` if plain data do not satisfy a ``schema`` that refers by name to the
    ``definitions``: one line about the fault nearest to the top, ``name: key is VALUE; allowed: ...``."""
    known = {"conditions.schema.yaml": read_schema("conditions"), **definitions}
    registry = Registry().with_contents(known.items(), default_specification=DRAFT202012)
    for kind in (WITHOUT_RULES, WITH_RULES):
        errors = kind(schema, registry=registry).iter_errors(content)
        nearest = min(errors, key=lambda each: (len(each.path), each.json_path), default=None)
        if nearest is not None:
            raise ValueError(f"{name}: {_line(content, nearest)}")


# ---- messages


def _line(content: Any, error: ValidationError) -> str:
    """The place of an error, the problem or, without one, the value, and what is allowed."""
    keys = list(error.path)
    place = error.json_path.removeprefix("$").removeprefix(".")
    entry = content[keys[0]] if isinstance(content, list) and keys else None
    name = entry.get("id") if isinstance(entry, dict) else None
    if isinstance(name, str) and re.fullmatch(r"[a-z0-9-]{1,100}", name):
        place = re.sub(r"^\[\d+\]\.?", f"{name}: ", place).removesuffix(": ")
    problem, allowed = _fault(error)
    if problem:
        return f"{place}: {problem}; allowed: {allowed}".removeprefix(": ")
    return f"{place} is {format_value(reduce(getitem, keys, content))}; allowed: {allowed}"


def _fault(error: ValidationError) -> tuple[str, str]:
    """The problem, if the value alone does not show it, and what is allowed."""
    if error.validator == "rules":
        return error.message, error.schema["allowed"]
    if error.validator == "required":
        missing = next(name for name in error.validator_value if name not in error.instance)
        return f"key {missing!r} is missing", "it must be given"
    if error.validator == "additionalProperties":
        known = sorted(error.schema["properties"])
        unknown = next(name for name in error.instance if name not in known)
        return f"unknown key {format_value(unknown)}", _nearest(unknown, known)
    is_key = "propertyNames" in error.schema_path
    return f"unknown key {format_value(error.instance)}" if is_key else "", _allowed(error)


def _allowed(error: ValidationError) -> str:
    """What is allowed instead of the wrong value."""
    value, bound = error.instance, error.validator_value
    if "allowed" in error.schema:
        allowed = error.schema["allowed"]
    elif isinstance(value, float) and not math.isfinite(value):
        allowed = "finite numbers"
    elif error.validator == "enum":
        allowed = _nearest(str(value), [*map(str, bound)])
    elif error.validator == "type":
        kinds = [bound] if isinstance(bound, str) else bound
        allowed = " or ".join(TYPES[kind] for kind in kinds)
    elif error.validator in ALLOWED:
        allowed = ALLOWED[error.validator].format(bound)
    else:
        allowed = error.message
    if error.validator == "type" and isinstance(value, str) and NUMBER.fullmatch(value):
        allowed += NOT_A_NUMBER
    return allowed


def _nearest(name: str, known: Sequence[str]) -> str:
    """All ``known`` keys or, if there are many, those closest to ``name``."""
    if len(known) <= MOST_NAMED:
        return ", ".join(known)
    near = get_close_matches(name[:LONGEST], known, MOST_NAMED // 2, cutoff=0.0)
    return f"{', '.join(near)} and {len(known) - len(near)} more"
