"""Products that appear whole or not at all, and scripts that say what went wrong in one line."""

from __future__ import annotations

import glob
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from thirdbody.run.custody import PRODUCTS, record_of, record_text


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
    OSError
        Naming the places, if a file was not written, or could not be for want of room or right.
        Whatever the block raises, nothing new appears in any place.

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
    places = [Path(path) for path in paths]
    products = [place for place in places if recorded and place.is_relative_to(PRODUCTS)]
    # records first: what a process killed between them leaves differs from its record
    parts = {place: _part_of(place) for place in [*map(record_of, products), *places]}
    try:
        yield parts[places[0]] if len(places) == 1 else tuple(parts[place] for place in places)
        for place in places:
            with open(parts[place], "rb") as written:
                os.fsync(written.fileno())
        for product in products:
            _write_record(product, parts)
        for place, part in parts.items():
            os.replace(part, place)
    except OSError as error:
        elsewhere = error.filename and Path(error.filename) not in parts.values()
        if elsewhere or error.strerror is None:
            raise
        names = ", ".join(map(str, places))
        raise OSError(f"{names} cannot be written ({error.strerror})") from None
    finally:
        for part in parts.values():
            part.unlink(missing_ok=True)


def _part_of(place: Path) -> Path:
    """Name beside ``place`` for this process, after removal of what others left there.

    Such a process was killed, or lives on without the run that started it.
    """
    for left in place.parent.glob(f".{glob.escape(place.stem)}.partial*{place.suffix}"):
        left.unlink(missing_ok=True)
    return place.with_name(f".{place.stem}.partial{os.getpid()}{place.suffix}")


def _write_record(product: Path, parts: dict[Path, Path]) -> None:
    record = record_of(product)
    record.parent.mkdir(parents=True, exist_ok=True)
    with open(parts[product], "rb") as content:
        parts[record].write_text(record_text(product, content), encoding="utf-8")


@contextmanager
def logged(log: str | Path) -> Iterator[None]:
    """Send what a script prints to the file ``log``.

    Raises
    ------
    SystemExit
        With code 1 after ``ValueError``, ``OSError`` and ``MemoryError``, whose message is then a
        line of the log; with a message if the log itself cannot be written.
    """
    outer = sys.stdout, sys.stderr
    try:
        with open(log, "w", encoding="utf-8", buffering=1) as stream:
            sys.stdout = sys.stderr = stream
            try:
                yield
            except (ValueError, OSError, MemoryError) as error:
                print(str(error) or type(error).__name__, file=stream)
                raise SystemExit(1) from None
            finally:
                sys.stdout, sys.stderr = outer
    except OSError as error:  # the log itself cannot be written
        raise SystemExit(f"{log} cannot be written ({error.strerror})") from None
