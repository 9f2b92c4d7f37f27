"""Time and memory of a function without arguments."""

from __future__ import annotations

import time
import tracemalloc

MICROSECONDS = 1e6  # of a second
MEGABYTE = 1e6  # bytes


def processor_seconds(function) -> float:
    """Processor time [s] of one call."""
    return _seconds(function, time.process_time)


def least_seconds(functions: dict, rounds: int, timed=processor_seconds) -> dict:
    """Least time [s] of each of ``functions`` in so many rounds of all; ``timed`` takes it.

    What else a machine does only adds to a time, and does so for long enough to spoil all that is
    timed meanwhile: hence the least, and the rounds.
    """
    times = [{name: timed(function) for name, function in functions.items()} for _ in range(rounds)]
    return {name: min(each[name] for each in times) for name in functions}


def wall_seconds(function) -> float:
    """Time on the clock [s] of one call: for several processes, or a disk."""
    return _seconds(function, time.perf_counter)


def _seconds(function, clock):
    start = clock()
    function()
    return clock() - start


def peak_megabytes(function) -> float:
    """Most memory [MB] that one call holds at a time in Python objects and numpy arrays."""
    tracemalloc.start()
    function()
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    return peak / MEGABYTE
