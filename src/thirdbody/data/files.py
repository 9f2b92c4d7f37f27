"""Products that appear whole or not at all, and scripts that say what went wrong in one line."""

from __future__ import annotations

import glob
import hashlib
import os
import sys
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def whole(*paths, recorded: bool = True):
    """Names beside ``paths`` to write to; they take their places together once all are written.

    Yields one ``Path``, or a tuple for several.  Nothing appears in its place if the block fails;
    ``OSError`` then names the places if it was for want of room or right.  What was made is, if
    ``recorded``, printed as ``sha256sum -c`` reads it: in a log, it tells a product that was
    damaged later.
    """
    places = [Path(path) for path in paths]
    for place in places:
        # of a process that was killed, or lives on without the run that started it
        for left in place.parent.glob(f".{glob.escape(place.stem)}.partial*{place.suffix}"):
            left.unlink(missing_ok=True)
    mine = f".partial{os.getpid()}"
    beside = [place.with_name(f".{place.stem}{mine}{place.suffix}") for place in places]
    digests = []
    try:
        yield beside[0] if len(beside) == 1 else tuple(beside)
        for part in beside:
            with open(part, "rb") as written:
                os.fsync(written.fileno())
                if recorded:
                    digests.append(hashlib.file_digest(written, "sha256").hexdigest())
        for part, place in zip(beside, places, strict=True):
            os.replace(part, place)
    except OSError as error:
        elsewhere = error.filename and str(error.filename) not in map(str, beside)
        if elsewhere or error.strerror is None:
            raise
        names = ", ".join(map(str, places))
        raise OSError(f"{names} cannot be written ({error.strerror})") from None
    finally:
        for part in beside:
            part.unlink(missing_ok=True)
    for digest, place in zip(digests, places if recorded else [], strict=True):
        print(f"{digest}  {place}")


@contextmanager
def logged(log):
    """Send what a script prints to the file ``log``; a foreseeable failure is one line, exit 1."""
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
