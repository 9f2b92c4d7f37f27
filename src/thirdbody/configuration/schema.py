"""Judging configuration: one line that names the key, its value and what is allowed."""

from __future__ import annotations

import math
from pathlib import Path

from thirdbody.configuration.plain_yaml import read_yaml


def config_directory() -> Path:
    """Where the configuration lies: inside an installed package, else beside ``src/``."""
    package = Path(__file__).resolve().parents[1]
    installed = package / "config"
    return installed if installed.is_dir() else package.parents[1] / "config"


def validate(config: dict, schema: dict) -> None:
    """Raise ``ValueError`` with one line for the first key of ``config`` that breaks ``schema``."""
    from jsonschema import Draft202012Validator

    _require_reasonable(config, "")
    errors = Draft202012Validator(schema).iter_errors(config)
    first = min(errors, key=lambda error: (len(error.absolute_path), _key(error)), default=None)
    if first is not None:
        raise ValueError(_explained(first))


def read_valid(path, schema) -> dict:
    """The mapping in a YAML file that keeps to the ``schema`` in another; ``ValueError`` as both."""
    content = read_yaml(path)
    try:
        validate(content, read_yaml(schema))
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from None
    return content


LONGEST_LIST = 1000  # what the schemas allow at most


def _require_reasonable(value, key) -> None:
    """JSON Schema lets nan and infinities pass any bound, and takes for ever on a huge list."""
    if isinstance(value, dict):
        for name, item in value.items():
            _require_reasonable(item, f"{key}.{name}".lstrip("."))
    elif isinstance(value, list):
        if len(value) > LONGEST_LIST:
            raise ValueError(f"{key} holds {len(value)} values; allowed: at most {LONGEST_LIST}")
        for index, item in enumerate(value):
            _require_reasonable(item, f"{key}[{index}]")
    elif isinstance(value, float) and not math.isfinite(value):
        raise ValueError(f"{key} is {value}; allowed: finite numbers")


def _key(error) -> str:
    key = ""
    for part in error.absolute_path:
        key += f"[{part}]" if isinstance(part, int) else f".{part}"
    return key.lstrip(".")


_ALLOWED = {
    "type": lambda e: f"allowed: {_words(e.validator_value)}",
    "enum": lambda e: f"allowed: {', '.join(map(str, e.validator_value))}",
    "minimum": lambda e: f"allowed: at least {e.validator_value:g}",
    "maximum": lambda e: f"allowed: at most {e.validator_value:g}",
    "exclusiveMinimum": lambda e: f"allowed: above {e.validator_value:g}",
    "exclusiveMaximum": lambda e: f"allowed: below {e.validator_value:g}",
    "minItems": lambda e: f"allowed: at least {e.validator_value} values",
    "maxItems": lambda e: f"allowed: at most {e.validator_value} values",
    "uniqueItems": lambda e: "allowed: no value twice",
    "minProperties": lambda e: f"allowed: at least {e.validator_value} keys",
    "minLength": lambda e: "allowed: at least one letter",
    "maxLength": lambda e: f"allowed: at most {e.validator_value} letters",
    "pattern": lambda e: f"allowed: {e.schema.get('description', e.validator_value)}",
    "oneOf": lambda e: f"allowed: {e.schema.get('description', 'one of several forms')}",
}


def _words(kinds) -> str:
    """JSON Schema's type names as a person says them."""
    named = {"object": "keys with values", "array": "a list", "string": "a word", "null": "nothing"}
    kinds = [kinds] if isinstance(kinds, str) else kinds
    return " or ".join(named.get(kind, f"a{'n' * (kind[0] in 'aeiou')} {kind}") for kind in kinds)


def _explained(error) -> str:
    """One line for a schema error."""
    key = _key(error) or "configuration"
    if error.validator == "additionalProperties":
        known = sorted(error.schema.get("properties", {}))
        patterns = error.schema.get("patternProperties", {})
        extra = next(
            name for name in error.instance if name not in known and not _matches(name, patterns)
        )
        return (
            f"{key}: unknown key {shown(extra)}; allowed: {', '.join(known) or ', '.join(patterns)}"
        )
    if error.validator == "required":
        missing = next(name for name in error.validator_value if name not in error.instance)
        return f"{key}: key {missing!r} is missing; allowed: it must be given"
    allowed = _ALLOWED.get(error.validator, lambda e: e.message)(error)
    return f"{key} is {shown(error.instance)}; {allowed}"


def _matches(name, patterns) -> bool:
    import re

    return any(re.search(pattern, name) for pattern in patterns)


def shown(value) -> str:
    text = repr(value)
    return text if len(text) <= 60 else f"{text[:57]}..."
