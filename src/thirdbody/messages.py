"""How a message shows what it names: in one line, and cut where it is long."""

from __future__ import annotations

from os import PathLike
from typing import Any

LONGEST = 60  # letters


def shown(value: Any) -> str:
    """A value as a message shows it.

    Examples
    --------
    >>> shown("load"), shown(10**100)
    ("'load'", '100000000000000000000000000000000000000000000000000000000...')
    """
    text = " ".join(repr(value).split())
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 3]}..."


def shown_file(path: str | PathLike) -> str:
    """The name of a file as a message shows it, in quotes where it is no plain text.

    Examples
    --------
    >>> shown_file("mine.yaml"), shown_file("")
    ('mine.yaml', "''")
    """
    name = str(path)
    return name if name.isprintable() and name else shown(name)
