"""Values and file names in one-line messages; long ones are cut."""

from os import PathLike
from typing import Any

LONGEST = 60  # letters


def format_value(value: Any) -> str:
    """The ``repr`` of a value on one line, cut if it is long; numbers of numpy as plain numbers."""
    is_number = type(value).__module__ == "numpy" and getattr(value, "shape", None) == ()
    value = value.item() if is_number and hasattr(value, "item") else value
    text = " ".join(repr(value).split())
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 3]}..."


def format_path(path: str | PathLike) -> str:
    """The name of a file, quoted if it is empty or not printable."""
    name = str(path)
    return name if name.isprintable() and name else format_value(name)
