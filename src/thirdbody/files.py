"""Files: atomic writing, the error for damaged files, the SHA-256, plain YAML, and values and file
names in one-line messages.

Plain YAML has no tags of Python, no duplicate keys, and only decimal numbers.
"""

import errno
import glob
import hashlib
import os
import re
import secrets
import shutil
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from os import PathLike
from pathlib import Path
from typing import Any

import yaml

LONGEST = 60  # letters of a value in a message
CONTENT_WORDS: dict[type, str] = {dict: "keys with values", list: "a list"}
OTHER_BASES = re.compile(r"[-+]?(0[0-9xb_]|.*:)")


def format_value(value: Any) -> str:
    """The ``repr`` of a value on one line, cut if it is long.  A number of numpy loses its type."""
    is_number = type(value).__module__ == "numpy" and getattr(value, "shape", None) == ()
    value = value.item() if is_number and hasattr(value, "item") else value
    text = " ".join(repr(value).split())
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 3]}..."


def format_path(path: str | PathLike) -> str:
    """The name of a file, quoted if it is empty or not printable."""
    name = str(path)
    return name if name.isprintable() and name else format_value(name)


@contextmanager
def atomic_write(*paths: str | PathLike) -> Iterator[tuple[Path, ...]]:
    """Yield temporary names beside the ``paths``, and rename these files once all are written.

    If the block raises an error, no file changes.  Raises ``ValueError`` for an invalid file name,
    and ``OSError`` if a file cannot be written, if possible before the block runs.
    """
    places = [*map(_place, paths)]
    if len(places) == 1 and _is_device(places[0]):
        yield (places[0],)
        return
    # the number of the process in the name shows later whether it was killed and left the file
    mark = f"partial{os.getpid()}-{secrets.token_hex(4)}"
    parts = {place: place.with_name(f".{place.stem}.{mark}{place.suffix}") for place in places}
    try:
        for place, part in parts.items():
            _prepare(place, part)
        yield tuple(parts.values())
        for part in parts.values():
            with open(part, "r+b") as stream:  # Windows syncs only files that are open for writing
                os.fsync(stream.fileno())
        for place, part in parts.items():
            if place.exists():
                shutil.copymode(place, part)
            os.replace(part, place)
    except OSError as error:
        elsewhere = error.filename and Path(error.filename) not in (*parts, *parts.values())
        if elsewhere or error.strerror is None:
            raise
        names = ", ".join(map(format_path, parts))
        raise OSError(f"{names} cannot be written ({error.strerror})") from None
    finally:
        for part in parts.values():
            with suppress(OSError):
                part.unlink()


def _is_device(place):
    """Whether a path is a pipe or a device: it is written to, and never replaced."""
    try:
        return stat.S_ISFIFO(mode := place.stat().st_mode) or stat.S_ISCHR(mode)
    except OSError:
        return False


def _prepare(place, part):
    """Remove temporary files of killed processes, then check the paths.

    Raises ``OSError`` unless ``part`` can be written and renamed to ``place``.
    """
    start = f".{place.stem}.partial"
    for leftover in place.parent.glob(f"{glob.escape(start)}*-*{glob.escape(place.suffix)}"):
        process = leftover.name.removeprefix(start).partition("-")[0]
        if process.isdecimal() and not _is_alive(int(process)):
            with suppress(OSError):
                leftover.unlink()
    if place.exists() and not place.is_file():  # a device must not be replaced
        reason = "Is a directory" if place.is_dir() else "Not a regular file"
        raise OSError(errno.EINVAL, reason, part)
    if place.exists() and not os.access(place, os.W_OK):
        raise OSError(errno.EACCES, "Permission denied", part)
    part.touch()
    part.unlink()


def _is_alive(process):
    if os.name == "nt":  # signal 0 is Ctrl-C on Windows
        return True
    try:
        os.kill(process, 0)  # signal 0 only checks the process
    except OSError as error:
        return error.errno != errno.ESRCH  # the process may belong to another user
    return True


def _place(path: str | PathLike) -> Path:
    """``path``, or the file to which ``path`` links."""
    place = Path(path)
    is_link_to_file = os.path.islink(place) and not _is_device(place)
    return Path(os.path.realpath(place)) if is_link_to_file else place


def is_same_file(one: str | PathLike, other: str | PathLike) -> bool:
    """Whether two names are of one file: by links too, or but for capitals, which some systems
    ignore.  Devices and pipes are no files."""
    places = Path(one), Path(other)
    if any(map(_is_device, places)):
        return False
    names = {os.path.realpath(place).casefold() for place in places}
    return len(names) == 1 or (all(p.exists() for p in places) and os.path.samefile(*places))


class DamagedFile(OSError):
    """The file ``path``, which a program wrote, has changed since."""

    def __init__(self, path: str | os.PathLike, message: str) -> None:
        super().__init__(f"{path} {message}")
        self.path = path


def unreadable(path: str | os.PathLike, reason: object) -> DamagedFile:
    """The error for a file that cannot be read."""
    return DamagedFile(path, f"cannot be read ({reason})")


def digest(path: str | os.PathLike) -> str:
    """The SHA-256 of a file, in hexadecimal."""
    with open(path, "rb") as content:
        return hashlib.file_digest(content, "sha256").hexdigest()


class _KeysOnce(yaml.CSafeLoader):
    """The loader of PyYAML, restricted to unique keys that are strings."""

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
    """A decimal number.  YAML 1.1 would read 0300 as 192, and 1:30 as 90; both are refused."""
    if OTHER_BASES.match(node.value):
        raise _fault(node, f"number {node.value}; allowed: decimal numbers, or text in quotes")
    construct = getattr(loader, f"construct_yaml_{node.tag.rpartition(':')[2]}")
    return construct(node)


for tag in ("int", "float"):
    _KeysOnce.add_constructor(f"tag:yaml.org,2002:{tag}", _decimal)


def read_yaml(path: str | Path, content_type: type = dict) -> Any:
    """The content of a plain YAML file in UTF-8, of the ``content_type`` dict or list.

    Raises ``ValueError`` in one line, with the file, the number of the line, and the fault.
    """
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
    if not isinstance(content, content_type):
        raise ValueError(
            f"{name}: contains {type(content).__name__}; allowed: {CONTENT_WORDS[content_type]}"
        )
    return content


def _fault(place: yaml.Node, problem: str) -> yaml.MarkedYAMLError:
    return yaml.MarkedYAMLError(problem=problem, problem_mark=place.start_mark)
