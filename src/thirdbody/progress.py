"""How far a long call has come: a bar on a terminal, a line now and then in a log.

Both go to the standard error stream.  A call that is over soon says nothing.
"""

from __future__ import annotations

import sys
from contextlib import suppress
from threading import Lock
from time import monotonic
from types import TracebackType
from typing import Any, Self, TextIO

FIRST_BAR, NEXT_BAR = 2.0, 0.2  # s
FIRST_LINE = NEXT_LINE = 30.0  # s
WIDTH = 30  # letters of the bar


def check_progress(progress: Any) -> None:
    """Raises ``ValueError`` unless ``progress`` says whether progress is shown."""
    if not isinstance(progress, bool):
        raise ValueError(f"progress is {progress!r}; allowed: True or False")


class Progress:
    """The progress of one call, a context manager.

    Parameters
    ----------
    total : int
        How many there are to be done.
    things : str
        What they are called.
    is_shown : bool
        Whether anything is said.

    Examples
    --------
    >>> with Progress(2, "points", is_shown=True) as progress:
    ...     progress.add(1)
    ...     progress.add(1)
    """

    def __init__(self, total: int, things: str, is_shown: bool) -> None:
        self._total, self._things = total, things
        self._done = 0
        self._lock = Lock()
        self._stream: TextIO | None = sys.stderr if is_shown else None
        self._is_bar = self._stream is not None and self._stream.isatty()
        self._start = monotonic()
        self._due = self._start + (FIRST_BAR if self._is_bar else FIRST_LINE)
        self._told: int | None = None  # how many were done when this was last said

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        if self._told is not None and (self._is_bar or self._told != self._done):
            self._say(monotonic(), end="\n")

    def add(self, count: int) -> None:
        """So many more are done; from any thread."""
        with self._lock:
            self._done += count
            now = monotonic()
            if self._stream is not None and now >= self._due:
                self._say(now, end="" if self._is_bar else "\n")
                self._due = now + (NEXT_BAR if self._is_bar else NEXT_LINE)

    def _say(self, now: float, end: str) -> None:
        share = self._done / max(self._total, 1)
        spent = now - self._start
        told = f"{share:4.0%} of {self._total:,} {self._things}, {_duration(spent)}"
        if 0.0 < share < 1.0:
            told += f", about {_duration(spent / share - spent)} left"
        if self._is_bar:
            bar = "#" * int(share * WIDTH)
            told = f"\r[{bar:<{WIDTH}}] {told}\x1b[K"  # and what was longer is wiped out
        self._told = self._done
        with suppress(OSError, ValueError):  # a stream that is full or closed stops no call
            self._stream.write(told + end)
            self._stream.flush()


def _duration(seconds: float) -> str:
    """So many seconds as a person says them.

    Examples
    --------
    >>> _duration(12.3), _duration(200), _duration(9000)
    ('12 s', '3 min', '2.5 h')
    """
    if seconds < 100.0:
        return f"{seconds:.0f} s"
    return f"{seconds / 60.0:.0f} min" if seconds < 6000.0 else f"{seconds / 3600.0:.1f} h"
