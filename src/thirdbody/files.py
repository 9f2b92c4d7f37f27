"""Products that appear whole or not at all, and scripts that say what went wrong in one line."""

from __future__ import annotations

import os
import sys
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def whole(*paths):
    """Names beside ``paths`` to write to; they take their places together once all are written.

    Yields one ``Path``, or a tuple for several.  Nothing appears in its place if the block fails.
    """
    places = [Path(path) for path in paths]
    beside = [place.with_name(f".{place.stem}.partial{place.suffix}") for place in places]
    try:
        yield beside[0] if len(beside) == 1 else tuple(beside)
        for part in beside:
            with open(part, "rb") as written:
                os.fsync(written.fileno())
        for part, place in zip(beside, places, strict=True):
            os.replace(part, place)
    finally:
        for part in beside:
            part.unlink(missing_ok=True)


@contextmanager
def logged(log):
    """Send what a script prints to the file ``log``; a foreseeable failure is one line, exit 1."""
    with open(log, "w", encoding="utf-8", buffering=1) as stream:
        outer = sys.stdout, sys.stderr
        sys.stdout = sys.stderr = stream
        try:
            yield
        except (ValueError, OSError) as error:
            print(error, file=stream)
            raise SystemExit(1) from None
        finally:
            sys.stdout, sys.stderr = outer
