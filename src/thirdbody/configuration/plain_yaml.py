"""Reading YAML that is plain data: no tags, no anchors, no key twice."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import yaml

from thirdbody.messages import shown, shown_file


class _StrictLoader(yaml.composer.Composer, yaml.CSafeLoader):
    """YAML without duplicate keys, anchors or tags: a configuration is plain data.

    Parsed in C, which takes a quarter of the time, but composed in Python, where it can be refused.
    """

    def __init__(self, stream):
        yaml.CSafeLoader.__init__(self, stream)
        yaml.composer.Composer.__init__(self)

    def compose_node(self, parent, index):
        if self.check_event(yaml.AliasEvent):
            event = self.peek_event()
            raise yaml.composer.ComposerError(
                None, None, f"alias *{event.anchor}; allowed: plain values", event.start_mark
            )
        event = self.peek_event()
        for extra in ("tag", "anchor"):
            if getattr(event, extra, None) not in (None, "!"):
                problem = f"{extra} {getattr(event, extra)}; allowed: plain values"
                raise yaml.composer.ComposerError(None, None, problem, event.start_mark)
        return super().compose_node(parent, index)

    def construct_mapping(self, node, deep=False):
        seen = set()
        for key_node, _ in node.value:
            key = self.construct_object(key_node, deep=True)
            if not isinstance(key, str):
                raise yaml.constructor.ConstructorError(
                    None, None, f"key {key!r}; allowed: words", key_node.start_mark
                )
            if key in seen:
                raise yaml.constructor.ConstructorError(
                    None, None, f"key {key!r} stands twice", key_node.start_mark
                )
            seen.add(key)
        return super().construct_mapping(node, deep)


KINDS = {dict: "keys with values", list: "a list"}


def read_yaml(path: str | Path, kind: type = dict, strict: bool = True) -> Any:
    """Read a YAML file that is plain data.

    Parameters
    ----------
    path : str or Path
        The file, in UTF-8.
    kind : type, optional
        What it must hold, ``dict`` or ``list``.
    strict : bool, optional
        Whether tags, anchors, and keys that stand twice or are no words are refused.  Schemas are read
        without, in a quarter of the time: they are part of the program, and tested to be plain.

    Returns
    -------
    dict or list
        Plain data: mappings, lists, numbers, words, truth values, dates and nothing.

    Raises
    ------
    ValueError
        In one line: the file, the line in it, and what is wrong there.
    """
    name = shown_file(path)
    try:
        text = Path(path).read_bytes().decode("utf-8")
    except OSError as error:
        raise ValueError(f"{name}: {error.strerror}; allowed: a readable YAML file") from None
    except UnicodeDecodeError as error:
        raise ValueError(f"{name}: byte {error.start} is not UTF-8") from None
    except (TypeError, ValueError):
        raise ValueError(f"{shown(path)} is no path; allowed: that of a YAML file") from None
    try:
        content = yaml.load(text, _StrictLoader if strict else yaml.CSafeLoader)
    except RecursionError:
        raise ValueError(f"{name}: nested too deeply") from None
    except (yaml.YAMLError, ValueError) as error:
        raise ValueError(f"{name}: {_one_line(error)}") from None
    if not isinstance(content, kind):
        raise ValueError(f"{name}: holds {type(content).__name__}; allowed: {KINDS[kind]}")
    return content


def _one_line(error) -> str:
    """Message of a YAML error with its place, in one line."""
    mark = getattr(error, "problem_mark", None)
    place = f"line {mark.line + 1}: " if mark else ""
    problem = getattr(error, "problem", None) or str(error)
    return " ".join(f"{place}{problem}".split())
