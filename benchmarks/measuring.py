"""Time that calls of functions without arguments take."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping

MICROSECONDS = 1e6  # in a second


def least_seconds(
    functions: Mapping, rounds: int, clock: Callable[[], float] = time.process_time
) -> dict:
    """Least time [s] of each function over several rounds, by name.

    Other programs can only add to a time, so the least one counts.  The functions take turns, so that a busy
    minute falls on all of them.  Give ``time.perf_counter`` for what waits for a disk or another process.
    """
    times = {name: [] for name in functions}
    for _ in range(rounds):
        for name, function in functions.items():
            start = clock()
            function()
            times[name].append(clock() - start)
    return {name: min(each) for name, each in times.items()}
