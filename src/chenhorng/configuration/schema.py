"""Validation of what users write by the JSON Schema of each kind of file in ``config/``.

A file ``<kind>.schema.yaml`` beside this module is a JSON Schema (draft 2020-12) with two additional keywords:
``rules``, names of functions of ``chenhorng.configuration.rules``, which are called if the document
is otherwise valid; and ``allowed``, words for messages where those of jsonschema are not clear
enough.  Definitions in ``conditions.schema.yaml`` serve all files.
"""

import math
from collections.abc import Mapping
from functools import cache
from numbers import Integral, Real
from pathlib import Path
from typing import Any

from jsonschema import Draft4Validator, Draft202012Validator, ValidationError
from jsonschema.exceptions import best_match
from jsonschema.validators import extend
from referencing import Registry
from referencing.jsonschema import DRAFT202012

from thirdbody.messages import format_value
from chenhorng.configuration import rules
from thirdbody.plain_yaml import read_yaml

LONGEST = 500  # letters of a message


@cache
def read_schema(kind: str) -> dict:
    """The JSON Schema of one kind of file (cached: do not modify)."""
    return read_yaml(Path(__file__).with_name(f"{kind}.schema.yaml"))


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
    ``definitions``: one line about the fault that says most, ``name: key is VALUE; allowed: ...``."""
    contents = {"conditions.schema.yaml": read_schema("conditions"), **definitions}
    registry = Registry().with_contents(contents.items(), default_specification=DRAFT202012)
    for kind in (WITHOUT_RULES, WITH_RULES):
        error = best_match(kind(schema, registry=registry).iter_errors(content))
        if error is not None:
            raise ValueError(f"{name}: {_line(error)}")


def _line(error: ValidationError) -> str:
    """The key, and its value and what is allowed or, without words for it, what jsonschema says."""
    key, value = error.json_path.removeprefix("$").removeprefix("."), format_value(error.instance)
    said, allowed = error.message.replace(repr(error.instance), value), error.schema.get("allowed")
    if allowed is None or error.validator in ("required", "additionalProperties"):
        line = f"{key}: {said}"
    else:
        line = f"{key} is {value}; allowed: {allowed}"
    return " ".join(line.removeprefix(": ").split())[:LONGEST]
