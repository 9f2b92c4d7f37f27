"""The one validator of all YAML files: each keeps to the schema beside it in ``config/``.

A file ``<kind>.schema.yaml`` is a JSON Schema (draft 2020-12) with three keywords of our own:

``rules``
    Names of rules of ``thirdbody.configuration.rules``, which say what JSON Schema cannot.  They are
    asked only where the rest of the document is right.
``allowed``
    What a message says is allowed here, where the bare numbers or pattern of the schema would say
    too little.
``allowed_keys``
    The same of keys that keep to a pattern.

A schema refers to the definitions of ``conditions.schema.yaml`` as ``conditions.schema.yaml#/$defs/rtol``.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from difflib import get_close_matches
from functools import cache
from pathlib import Path
from typing import Any

import yaml

from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.configuration.rules import RULES, Breach
from thirdbody.messages import LONGEST, shown, shown_file
from thirdbody.project import HOME

SHARED = "conditions"  # what the schemas of several files say of the same quantities
LONGEST_LIST = 1000  # what the schemas allow at most
MOST_NAMED = 16  # keys in a message


def config_directory() -> Path:
    """Where the configuration lies: inside an installed package, else beside ``src/``."""
    return HOME / "config"


def read_valid(path: str | Path, kind: str, **definitions: Mapping) -> Any:
    """Read a YAML file that keeps to the schema of its kind.

    Parameters
    ----------
    path : str or Path
        The file.
    kind : str
        Its kind: ``config/<kind>.schema.yaml`` is the schema.
    **definitions : Mapping
        Schemas that do not lie in a file; the schema refers to each by its name.

    Returns
    -------
    dict or list
        The content, plain data.

    Raises
    ------
    ValueError
        In one line: the file, the key at fault, its value and what is allowed.
    """
    schema = read_schema(kind)
    content = read_yaml(path, {"object": dict, "array": list}[schema["type"]])
    validate(content, schema, shown_file(path), **definitions)
    return content


@cache
def read_schema(kind: str) -> dict:
    """The JSON Schema of one kind of file, which nobody changes."""
    return read_yaml(config_directory() / f"{kind}.schema.yaml", strict=False)


def validate(content: Any, schema: Mapping, name: str, **definitions: Mapping) -> None:
    """Refuse what breaks a schema.

    Parameters
    ----------
    content : dict or list
        Plain data.
    schema : Mapping
        JSON Schema with the keywords ``rules`` and ``allowed``.
    name : str
        What the message calls the content: the file that it is from.
    **definitions : Mapping
        Schemas that do not lie in a file; ``schema`` refers to each by its name.

    Raises
    ------
    ValueError
        In one line, for the fault that is nearest to the top: ``name: key is VALUE; allowed: ...``.
    """
    _refuse_long_lists(content, name)
    found = _validator_class()(schema, registry=_registry(definitions)).iter_errors(content)
    faults = sorted(found, key=lambda each: (len(each.absolute_path), _joined(each.absolute_path)))
    broken = next((each for each in faults if each.validator != "rules"), None)
    if broken is not None:
        place = _place(content, broken.absolute_path)
        raise ValueError(f"{name}: {_explained(place, broken)}")
    for asked in faults:
        for path, breach in _breaches(asked):
            line = _told(_place(content, path), breach, _value_at(content, path))
            raise ValueError(f"{name}: {line}")


# ---- the dialect of JSON Schema


@cache
def _validator_class():
    """JSON Schema with our keywords, in which a number is finite and 5.0 is no integer."""
    from jsonschema import Draft202012Validator, ValidationError
    from jsonschema.validators import extend

    def ask_later(validator, rules, instance, schema):
        yield ValidationError("a rule is to be asked")

    def is_integer(checker, value):
        return isinstance(value, int) and not isinstance(value, bool)

    def is_number(checker, value):
        return is_integer(checker, value) or (isinstance(value, float) and math.isfinite(value))

    kinds = Draft202012Validator.TYPE_CHECKER.redefine_many(
        {"integer": is_integer, "number": is_number}
    )
    return extend(Draft202012Validator, {"rules": ask_later}, type_checker=kinds)


def _registry(definitions: Mapping[str, Mapping]):
    """Where a ``$ref`` finds the ``definitions`` and those that all schemas share."""
    from referencing import Registry
    from referencing.jsonschema import DRAFT202012

    known = {f"{SHARED}.schema.yaml": read_schema(SHARED), **definitions}
    return Registry().with_resources(
        (name, DRAFT202012.create_resource(each)) for name, each in known.items()
    )


def _refuse_long_lists(value: Any, name: str, path: tuple = ()) -> None:
    """JSON Schema would compare each with each in a list of any length."""
    if isinstance(value, list) and len(value) > LONGEST_LIST:
        key = _joined(path)
        told = f"{key} holds {len(value)} values; allowed: at most {LONGEST_LIST}"
        raise ValueError(f"{name}: {told.lstrip()}")
    if isinstance(value, (dict, list)):
        for key, item in value.items() if isinstance(value, dict) else enumerate(value):
            _refuse_long_lists(item, name, (*path, key))


def _breaches(asked) -> Iterator[tuple[tuple, Breach]]:
    """What the rules asked for at one place find, each with its place in the whole content."""
    for rule in asked.validator_value:
        for breach in RULES[rule](asked.instance):
            yield (*asked.absolute_path, *breach.path), breach


# ---- messages


def _place(content: Any, path: Sequence) -> str:
    """The dotted key at ``path``; an entry of a list of entries with ids goes by its id."""
    if path and isinstance(content, list):
        entry = content[path[0]]
        name = entry.get("id") if isinstance(entry, dict) else None
        if isinstance(name, str) and re.fullmatch(r"[a-z0-9-]{1,100}", name):
            return f"{name}: {_joined(list(path)[1:])}"
    return _joined(path)


def _joined(path: Sequence) -> str:
    key = "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in path)
    return key.lstrip(".")


def _value_at(content: Any, path: Sequence) -> Any:
    for part in path:
        content = content[part]
    return content


def _told(place: str, breach: Breach, value: Any) -> str:
    fault = _after(place, breach.fault) if breach.fault else f"{place} is {shown(value)}"
    return f"{fault}; allowed: {breach.allowed}"


def _after(place: str, fault: str) -> str:
    """A fault of a whole group of keys, after its place if there is one."""
    return f"{place.removesuffix(': ')}: {fault}" if place else fault


def _explained(place: str, error) -> str:
    """One line for a schema error."""
    unknown = _unknown_key(error)
    if unknown is not None:
        name, known = unknown
        return _after(place, f"unknown key {shown(name)}; allowed: {_nearest(name, known)}")
    if error.validator == "required":
        missing = next(name for name in error.validator_value if name not in error.instance)
        return _after(place, f"key {missing!r} is missing; allowed: it must be given")
    return f"{place} is {shown(error.instance)}; allowed: {_allowed(error)}{_hint(error)}"


def _hint(error) -> str:
    """Why a number has been taken for text: in YAML 1.1 it has a point and a sign, 1.0e+11, and no
    quotes; what stands in braces or brackets after ``--config`` is text."""
    if error.validator != "type" or not isinstance(error.instance, str):
        return ""
    try:
        digits, power = f"{float(error.instance):.15e}".split("e")
    except ValueError:
        return ""
    if isinstance(yaml.safe_load(error.instance), (int, float)):
        return ", where this is text: in quotes, or in braces after --config"
    return f", which YAML reads from {float(digits)!r}e{power}"


def _unknown_key(error) -> tuple[str, Sequence[str]] | None:
    """The key that ought not to be there and the keys that may, if that is the error."""
    if "propertyNames" in error.schema_path:
        return error.instance, error.validator_value
    if error.validator != "additionalProperties":
        return None
    known = sorted(error.schema.get("properties", {}))
    patterns = list(error.schema.get("patternProperties", {}))
    matches = re.compile("|".join(patterns) or r"(?!)").search
    unknown = next(key for key in error.instance if key not in known and not matches(key))
    return unknown, known or [error.schema["allowed_keys"]]


def _nearest(name: str, known: Sequence[str]) -> str:
    """All keys that are known or, of a great many, those that ``name`` can be a slip for."""
    if len(known) <= MOST_NAMED:
        return ", ".join(known)
    near = get_close_matches(name[:LONGEST], known, MOST_NAMED // 2, cutoff=0.0)
    return f"{', '.join(near)} and {len(known) - len(near)} more"


_ALLOWED = {
    "type": lambda kinds: _words(kinds),
    "const": lambda value: f"{value}",
    "minimum": lambda bound: f"at least {bound:g}",
    "maximum": lambda bound: f"at most {bound:g}",
    "exclusiveMinimum": lambda bound: f"above {bound:g}",
    "exclusiveMaximum": lambda bound: f"below {bound:g}",
    "minItems": lambda count: f"at least {count} values",
    "maxItems": lambda count: f"at most {count} values",
    "uniqueItems": lambda _: "no value twice",
    "minProperties": lambda count: f"at least {count} keys",
    "minLength": lambda _: "at least one letter",
    "maxLength": lambda count: f"at most {count} letters",
}


def _allowed(error) -> str:
    """What would have been right."""
    if "allowed" in error.schema:
        return error.schema["allowed"]
    if isinstance(error.instance, float) and not math.isfinite(error.instance):
        return "finite numbers"
    if error.validator == "enum":
        return _nearest(f"{error.instance}", [*map(str, error.validator_value)])
    tell = _ALLOWED.get(error.validator)
    return tell(error.validator_value) if tell else error.message


def _words(kinds: str | list[str]) -> str:
    """JSON Schema's type names as a person says them."""
    named = {"object": "keys with values", "array": "a list", "string": "a word", "null": "nothing"}
    kinds = [kinds] if isinstance(kinds, str) else kinds
    return " or ".join(named.get(kind, f"a{'n' * (kind[0] in 'aeiou')} {kind}") for kind in kinds)
