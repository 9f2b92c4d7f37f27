"""Products that appear whole or not at all."""

from __future__ import annotations

import errno
import glob
import os
import secrets
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from thirdbody.messages import shown, shown_file
from thirdbody.run.custody import record_of, record_text
from thirdbody.run.places import PRODUCTS


@contextmanager
def whole(*paths: str | Path, recorded: bool = True) -> Iterator[Path | tuple[Path, ...]]:
    """Write files that take their places together, once all of them are written.

    Parameters
    ----------
    *paths
        The places of the files.
    recorded
        Whether those in ``results/`` get a record of what was made (`thirdbody.run.custody`).

    Yields
    ------
    Path or tuple of Path
        Names beside the places, to be written to: one, or as many as there are ``paths``.

    Raises
    ------
    ValueError
        For what is no name of a file.
    OSError
        Naming the places, if a file was not written, or could not be for want of room or right; what
        cannot be begun is refused before the block runs.  Whatever the block raises, nothing new
        appears in any place.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     place = Path(folder) / "table.csv"
    ...     with whole(place) as part:
    ...         size = part.write_text("load,area")
    ...         print(place.exists())
    ...     print(place.exists())
    False
    True
    """
    places = [_place(path) for path in paths]
    products = [place for place in places if recorded and place.is_relative_to(PRODUCTS)]
    # records first: what a process killed between them leaves differs from its record
    parts = {place: _part_of(place) for place in [*map(record_of, products), *places]}
    try:
        for place in places:
            _require_possible(place, parts[place])
        yield parts[places[0]] if len(places) == 1 else tuple(parts[place] for place in places)
        for place in places:
            with open(parts[place], "rb") as written:
                os.fsync(written.fileno())
        for product in products:
            _write_record(product, parts)
        for place, part in parts.items():
            os.replace(part, place)
    except OSError as error:
        elsewhere = error.filename and Path(error.filename) not in (*parts, *parts.values())
        if elsewhere or error.strerror is None:
            raise
        names = ", ".join(map(shown_file, places))
        raise OSError(f"{names} cannot be written ({error.strerror})") from None
    finally:
        for part in parts.values():
            with suppress(OSError):
                part.unlink()


def _place(path: str | Path) -> Path:
    """``path`` as the place of a file."""
    try:
        place = Path(path)
    except TypeError:
        place = Path()
    if not place.name or "\0" in place.name:
        raise ValueError(f"{shown(path)} is no name of a file; allowed: the path of one to write")
    return place


def _part_of(place: Path) -> Path:
    """Name beside ``place`` for this process alone, after removal of what others left there.

    Such a process was killed, or lives on without the run that started it, maybe on another host.
    """
    for left in place.parent.glob(f".{glob.escape(place.stem)}.partial*{place.suffix}"):
        left.unlink(missing_ok=True)
    return place.with_name(f".{place.stem}.partial{secrets.token_hex(4)}{place.suffix}")


def _require_possible(place: Path, part: Path) -> None:
    """Raise ``OSError`` if ``part``, which will take its ``place``, cannot be made there."""
    if place.is_dir():
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), part)
    part.touch()
    part.unlink()


def _write_record(product: Path, parts: dict[Path, Path]) -> None:
    record = record_of(product)
    record.parent.mkdir(parents=True, exist_ok=True)
    with open(parts[product], "rb") as content:
        parts[record].write_text(record_text(product, content), encoding="utf-8")
