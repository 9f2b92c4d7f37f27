"""Time and memory that a call of a function without arguments takes."""

from __future__ import annotations

import time
import tracemalloc
from collections.abc import Callable, Mapping

MICROSECONDS = 1e6  # in a second
MEGABYTE = 1e6  # bytes


def processor_seconds(function: Callable[[], object]) -> float:
    """Processor time [s] that one call takes in this process.

    Examples
    --------
    >>> processor_seconds(lambda: sum(range(100_000))) > 0.0
    True
    """
    return _seconds(function, time.process_time)


def least_seconds(
    functions: Mapping,
    rounds: int,
    timed: Callable[[Callable], float] = processor_seconds,
) -> dict:
    """Least time of each of several functions, called in turn.

    What else a machine does can only add to a time: therefore the least of several counts.  It may
    go on for long and spoil everything that is timed meanwhile: therefore the functions are called
    in turn, and not each of them several times in a row.

    Parameters
    ----------
    functions : mapping
        Functions without arguments, by any names.
    rounds : int
        How often each is called.
    timed : callable
        Calls a function and returns the time [s].

    Returns
    -------
    dict
        Least time [s] of each, by the same names.

    Examples
    --------
    >>> times = least_seconds({"few": lambda: sum([1]), "many": lambda: sum(range(10**5))}, 3)
    >>> times["few"] < times["many"]
    True
    """
    times = [{name: timed(function) for name, function in functions.items()} for _ in range(rounds)]
    return {name: min(each[name] for each in times) for name in functions}


def wall_seconds(function: Callable[[], object]) -> float:
    """Time on the clock [s] of one call, for what waits for other processes or for a disk.

    Examples
    --------
    >>> wall_seconds(lambda: time.sleep(0.01)) >= 0.01
    True
    """
    return _seconds(function, time.perf_counter)


def _seconds(function, clock):
    start = clock()
    function()
    return clock() - start


def peak_megabytes(function: Callable[[], object]) -> float:
    """Most memory [MB] that one call holds at a time in Python objects and numpy arrays.

    Examples
    --------
    >>> round(peak_megabytes(lambda: bytes(3_000_000)))
    3
    """
    tracemalloc.start()
    function()
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    return peak / MEGABYTE
