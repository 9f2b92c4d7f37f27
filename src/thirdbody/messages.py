"""Values and file names in one-line messages; long ones are cut."""

from collections.abc import Iterable
from difflib import get_close_matches
from os import PathLike
from typing import Any

LONGEST = 60  # letters


def format_value(value: Any) -> str:
    """The ``repr`` of a value on one line, cut if it is long; numbers of numpy as plain numbers."""
    is_number = type(value).__module__ == "numpy" and getattr(value, "shape", None) == ()
    value = value.item() if is_number and hasattr(value, "item") else value
    text = " ".join(repr(value).split())
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 3]}..."


def format_row(row: Any) -> str:
    """The label of a row of a table; of several levels with commas between them."""
    return ", ".join(map(str, row)) if isinstance(row, tuple) else str(row)


def did_you_mean(given: Any, known: Iterable[str]) -> str:
    """The end of a message about an unknown name: the ``known`` one nearest to it, or that it begins,
    if there is one."""
    by_letters = {name.lower(): name for name in known if name != str(given)}
    letters = str(given).lower()
    near = get_close_matches(letters, by_letters, 1)
    near = near or [name for name in by_letters if name.startswith(f"{letters}_")]
    return f"; did you mean {by_letters[near[0]]}?" if near else ""


def format_path(path: str | PathLike) -> str:
    """The name of a file, quoted if it is empty or not printable."""
    name = str(path)
    return name if name.isprintable() and name else format_value(name)
