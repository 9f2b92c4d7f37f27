"""Processor time and memory of a function without arguments."""

from __future__ import annotations

import time
import tracemalloc
from statistics import median

MEGABYTE = 1e6


def median_seconds(function, repeats: int) -> float:
    """Median processor time [s] of ``repeats`` calls."""
    return median(_seconds(function, time.process_time) for _ in range(repeats))


def median_wall_seconds(function, repeats: int) -> float:
    """Median time on the clock [s] of ``repeats`` calls: for several processes or a disk."""
    return median(_seconds(function, time.perf_counter) for _ in range(repeats))


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
