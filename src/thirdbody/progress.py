"""Progress of a long call: a bar on a terminal, an occasional line in a log.

Both go to standard error.  A short call writes nothing.  ``tqdm`` is not used: its import takes a
sixth as long as all other imports, and its bar fills a log with one long line.
"""

import sys
from contextlib import suppress
from time import monotonic
from typing import Self

FIRST_BAR, NEXT_BAR = 2.0, 0.2  # s
LINE = 30.0  # s
WIDTH = 30  # letters of the bar


class Progress:
    """Context manager that reports the progress of one call, if ``is_shown``; ``add`` counts."""

    def __init__(self, total: int, things: str, is_shown: bool) -> None:
        self._total, self._things = total, things
        self._is_shown = is_shown and sys.stderr is not None  # None without a console
        self._done = 0
        self._written: int | None = None  # the count when last written
        self._is_bar = self._is_shown and sys.stderr.isatty()
        self._start = monotonic()
        self._due = self._start + (FIRST_BAR if self._is_bar else LINE)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        if self._written is not None and (self._is_bar or self._written != self._done):
            self._write(end="\n")

    def add(self, count: int) -> None:
        """Count ``count`` more as done."""
        self._done += count
        if self._is_shown and monotonic() >= self._due:
            self._write(end="" if self._is_bar else "\n")
            self._due = monotonic() + (NEXT_BAR if self._is_bar else LINE)

    def _write(self, end: str) -> None:
        fraction = self._done / max(self._total, 1)
        spent = monotonic() - self._start
        text = f"{fraction:4.0%} of {self._total:,} {self._things}, {_duration(spent)}"
        if 0.0 < fraction < 1.0:
            text += f", about {_duration(spent / fraction - spent)} left"
        if self._is_bar:
            bar = "#" * int(fraction * WIDTH)
            text = f"\r[{bar:<{WIDTH}}] {text}\x1b[K"  # \x1b[K clears the rest of the line
        self._written = self._done
        with suppress(OSError, ValueError):  # a full or closed stream must not stop the call
            print(text, end=end, file=sys.stderr, flush=True)


def _duration(seconds: float) -> str:
    if seconds < 100.0:
        return f"{seconds:.0f} s"
    return f"{seconds / 60.0:.0f} min" if seconds < 6000.0 else f"{seconds / 3600.0:.1f} h"
