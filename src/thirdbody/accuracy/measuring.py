"""Time and memory of a function without arguments."""

from __future__ import annotations

import time
import tracemalloc
from statistics import median

MICROSECONDS = 1e6  # of a second
MEGABYTE = 1e6  # bytes


def median_seconds(function, repeats: int) -> float:
    """Median processor time [s] of ``repeats`` calls."""
    return median(_seconds(function, time.process_time) for _ in range(repeats))


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
