"""Reading plain YAML: no Python tags, no duplicate keys, and no more than a person would write."""

import re
from pathlib import Path
from typing import Any

import yaml

from thirdbody.messages import format_path

KINDS: dict[type, str] = {dict: "keys with values", list: "a list"}
LARGEST = 1_000_000  # bytes of a file
DEEPEST = 20  # lists and mappings in one another
MOST_VALUES = 100_000  # with what aliases repeat
OTHER_BASES = re.compile(r"[-+]?(0[0-9xb_]|.*:)")


def config_directory() -> Path:
    """The configuration folder: inside an installed package, otherwise beside ``src/``."""
    package = Path(__file__).resolve().parent
    home = package if (package / "config").is_dir() else package.parents[1]
    return home / "config"


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
        with Path(path).open("rb") as file:
            read = file.read(LARGEST + 1)
        text = read.decode("utf-8")
    except OSError as error:
        raise ValueError(f"{name}: {error.strerror}; allowed: a readable YAML file") from None
    except UnicodeDecodeError as error:
        raise ValueError(f"{name}: byte {error.start} is not UTF-8") from None
    if len(read) > LARGEST:
        raise ValueError(f"{name}: has more than {LARGEST} bytes; allowed: smaller files")
    try:
        _check_size(text)
        content = yaml.load(text, _KeysOnce)
    except (yaml.YAMLError, ValueError) as error:
        mark = getattr(error, "problem_mark", None)
        place = f"line {mark.line + 1}: " if mark else ""
        problem = " ".join(str(getattr(error, "problem", error)).split())
        raise ValueError(f"{name}: {place}{problem}") from None
    if not isinstance(content, kind):
        raise ValueError(f"{name}: contains {type(content).__name__}; allowed: {KINDS[kind]}")
    return content


def _check_size(text: str) -> None:
    """Refuse what is nested too deeply, or holds too many values once its aliases are replaced."""
    open_sizes = [0]  # values in the document, and in each list or mapping that is not closed
    anchors = []  # of these lists and mappings
    sizes = {}  # values of what an anchor names
    for event in yaml.parse(text, yaml.CSafeLoader):
        if isinstance(event, yaml.CollectionStartEvent):
            open_sizes.append(1)
            anchors.append(event.anchor)
            if len(anchors) > DEEPEST:
                raise _fault(event, f"nested more than {DEEPEST} levels deep")
            continue
        if isinstance(event, yaml.CollectionEndEvent):
            size = open_sizes.pop()
            sizes[anchors.pop()] = size
        elif isinstance(event, yaml.AliasEvent):
            if event.anchor in anchors:
                raise _fault(event, f"alias *{event.anchor} in what it names")
            size = sizes.get(event.anchor, 1)
        elif isinstance(event, yaml.ScalarEvent):
            size = 1
        else:
            continue
        open_sizes[-1] += size
        if open_sizes[-1] > MOST_VALUES:
            raise _fault(event, f"more than {MOST_VALUES} values, with what aliases repeat")


def _fault(place: yaml.Node | yaml.Event, problem: str) -> yaml.MarkedYAMLError:
    return yaml.MarkedYAMLError(problem=problem, problem_mark=place.start_mark)
