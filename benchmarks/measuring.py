"""Time that calls of functions without arguments take."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping

MICROSECONDS = 1e6  # in a second


def processor_seconds(function: Callable[[], object]) -> float:
    """Processor time [s] of one call in this process, all threads together."""
    return _seconds(function, time.process_time)


def wall_seconds(function: Callable[[], object]) -> float:
    """Elapsed time [s] of one call, for what waits for other processes or for a disk."""
    return _seconds(function, time.perf_counter)


def least_seconds(
    functions: Mapping,
    rounds: int,
    timed: Callable[[Callable], float] = processor_seconds,
) -> dict:
    """Least time [s] of each function over several rounds.

    Other programs can only add to a time, so the least one counts.  The functions take turns, so that a busy
    minute falls on all of them.
    """
    times = [{name: timed(function) for name, function in functions.items()} for _ in range(rounds)]
    return {name: min(each[name] for each in times) for name in functions}


def _seconds(function, clock):
    start = clock()
    function()
    return clock() - start
