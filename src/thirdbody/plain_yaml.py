"""Reading plain YAML: no Python tags, no duplicate keys, decimal numbers alone."""

import re
from pathlib import Path
from typing import Any

import yaml

from thirdbody.messages import format_path

KINDS: dict[type, str] = {dict: "keys with values", list: "a list"}
OTHER_BASES = re.compile(r"[-+]?(0[0-9xb_]|.*:)")


class _KeysOnce(yaml.CSafeLoader):
    """PyYAML's loader, restricted to unique keys that are strings."""

    def construct_mapping(self, node, deep=False):
        seen = set()
        for place, _ in node.value:
            key = self.construct_object(place, deep=True)
            if not isinstance(key, str):
                raise _fault(place, f"key {key!r}; allowed: strings")
            if key in seen:
                raise _fault(place, f"duplicate key {key!r}")
            seen.add(key)
        return super().construct_mapping(node, deep)


def _decimal(loader, node):
    """An integer as typed: YAML 1.1 reads 0300 as 192, and 1:30 as 90."""
    if OTHER_BASES.match(node.value):
        raise _fault(node, f"number {node.value}; allowed: decimal numbers, or text in quotes")
    construct = getattr(loader, f"construct_yaml_{node.tag.rpartition(':')[2]}")
    return construct(node)


for kind in ("int", "float"):
    _KeysOnce.add_constructor(f"tag:yaml.org,2002:{kind}", _decimal)


def read_yaml(path: str | Path, kind: type = dict) -> Any:
    """The content of a plain YAML file in UTF-8: a ``dict``, or a ``list`` if this is its ``kind``;
    ``ValueError`` in one line with the file, the line in it, and the error."""
    name = format_path(path)
    try:
        text = Path(path).read_text(encoding="utf-8")
    except OSError as error:
        raise ValueError(f"{name}: {error.strerror}; allowed: a readable YAML file") from None
    except UnicodeDecodeError as error:
        raise ValueError(f"{name}: byte {error.start} is not UTF-8") from None
    try:
        content = yaml.load(text, _KeysOnce)
    except (yaml.YAMLError, ValueError) as error:
        mark = getattr(error, "problem_mark", None)
        place = f"line {mark.line + 1}: " if mark else ""
        problem = " ".join(str(getattr(error, "problem", error)).split())
        raise ValueError(f"{name}: {place}{problem}") from None
    if not isinstance(content, kind):
        raise ValueError(f"{name}: contains {type(content).__name__}; allowed: {KINDS[kind]}")
    return content


def _fault(place: yaml.Node, problem: str) -> yaml.MarkedYAMLError:
    return yaml.MarkedYAMLError(problem=problem, problem_mark=place.start_mark)
