"""The log file of a job of the workflow."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from pathlib import Path


@contextmanager
def logged(log: str | Path) -> Iterator[None]:
    """Send what a script prints to the file ``log``.

    For ``ValueError``, ``OSError`` and ``MemoryError``, which a user can fix, the log ends with the
    message instead of a traceback, and the script exits with code 1.  If the log cannot be written,
    the message goes to standard error.
    """
    try:
        stream = open(log, "w", encoding="utf-8", buffering=1)  # noqa: SIM115
    except OSError as error:
        raise SystemExit(f"{log} cannot be written ({error.strerror})") from None
    failure = None
    with redirect_stdout(stream), redirect_stderr(stream):
        try:
            yield
        except (ValueError, OSError, MemoryError) as error:
            failure = str(error) or type(error).__name__
    try:
        with stream:
            stream.write(f"{failure}\n" if failure else "")
    except OSError as error:  # the disk is full
        raise SystemExit(failure or f"{log} cannot be written ({error.strerror})") from None
    if failure:
        raise SystemExit(1)
