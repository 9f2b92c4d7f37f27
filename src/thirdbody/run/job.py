"""What a script begins with: its log, and imports without a search for garbage.

Each script imports this module before all others.  What they import stays: looking for garbage in
it, again and again while it is imported and once more at the end, takes long and finds nothing.
"""

from __future__ import annotations

import gc
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

gc.disable()  # until ``logged``


@contextmanager
def logged(log: str | Path) -> Iterator[None]:
    """Send what a script prints to the file ``log``; garbage is searched for from now on.

    Raises
    ------
    SystemExit
        With code 1 after ``ValueError``, ``OSError`` and ``MemoryError``, whose message is then a
        line of the log; with a message if the log itself cannot be written.
    """
    gc.freeze()  # also at the end of the process
    gc.enable()
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
