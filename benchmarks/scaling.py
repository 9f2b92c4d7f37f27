"""How the time of the heaviest class depends on the number of points, from a single one to very many,
of processes and of threads."""

from __future__ import annotations

import os
import pickle
import subprocess
import sys
import time
from collections.abc import Mapping
from concurrent.futures import ProcessPoolExecutor
from functools import cache, partial
from operator import call
from pathlib import Path
from statistics import median
from subprocess import PIPE
from typing import Any
from unittest.mock import patch

from benchmarks.classes import HEAVIEST, random_conditions
from benchmarks.measuring import (
    MICROSECONDS,
    least_seconds,
    processor_seconds,
    wall_seconds,
)
from thirdbody.model.parameters import Parameters
from thirdbody.solver import availability
from thirdbody.solver.plan import COMPILED
from thirdbody.solver.solve import solve

# a process that calls a function
CALLED = """
import pickle, sys
function, *given = pickle.load(sys.stdin.buffer)
pickle.dump(function(*given), sys.stdout.buffer)
"""
PATIENCE = 3000  # calls, in case that the loop could not be left on disk
WAKING = 0.5  # [s] for which each process waits, so that the pool starts all of them


def scaling_rows(parameters: Parameters, budget: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Measure the cost of a point for few and many points, that of a call with a single one, and the
    gain of several processes and of several threads.

    Parameters
    ----------
    parameters : Parameters
        Inputs of the model.
    budget : mapping
        Content of ``config/accuracy.yaml``: ``sizes``, ``calls``, ``processes``, ``threads`` and
        ``rounds`` are used.

    Returns
    -------
    list of dict
        Rows of the table ``scaling``.
    """
    return [
        *_size_rows(parameters, budget),
        *_call_rows(parameters, budget),
        *_process_rows(parameters, budget),
        *_thread_rows(parameters, budget),
    ]


def _size_rows(parameters, budget):
    """Rows with the processor time of a point for each number of points.

    More points than a block are solved block by block and their results dropped, as when they are
    streamed.  Of fewer, a whole block is solved in arrays of that size.  The sizes take turns, so
    that what else the machine does falls on all of them.
    """
    settings = budget["sizes"]
    counts, block, rtol = settings["points"], settings["block"], settings["rtol"]
    rounds = max(budget["rounds"], max(counts) // block)
    costs = {count: [] for count in counts}
    for number in range(rounds):
        drawn = random_conditions(HEAVIEST, min(block, max(counts)), parameters, number)
        if number == 0:
            solve(**drawn, parameters=parameters, rtol=rtol, way=COMPILED)  # prepares the surface
        for count in counts:
            if number % (rounds // max(count // block, 1)) and count > block:
                continue
            seconds = processor_seconds(partial(_solve_arrays, drawn, count, parameters, rtol))
            costs[count].append(seconds / drawn["load"].size)
    costs = {count: median(each) for count, each in costs.items()}
    return [
        _row("points", count, 1, 1, rtol, cost, cost / min(costs.values()))
        for count, cost in costs.items()
    ]


def _solve_arrays(given, count, parameters, rtol):
    """Solve the points of ``given`` in arrays of ``count`` points at most."""
    for start in range(0, given["load"].size, count):
        some = {name: values[start : start + count] for name, values in given.items()}
        solve(**some, parameters=parameters, rtol=rtol, way=COMPILED)


def _call_rows(parameters, budget):
    """Rows with the processor time of a call that solves one point, in a new process that does nothing
    else: of those before it takes the time to load the loop; and of those after, under other loads of
    one interface, and of interfaces that no call had before."""
    settings = budget["calls"]
    drawn = random_conditions(HEAVIEST, settings["calls"], parameters)
    points = [
        dict(zip(drawn, numbers, strict=True))
        for numbers in zip(*(values.tolist() for values in drawn.values()), strict=True)
    ]
    given = {"parameters": parameters, "rtol": settings["rtol"]}
    solve(**points[0], **given, way=COMPILED)  # which leaves the loop on disk
    told = pickle.dumps((_call_again, points, given, budget["rounds"]))
    path = {"PYTHONPATH": str(Path(__file__).parents[1])}
    command = [sys.executable, "-c", CALLED]
    ran = subprocess.run(command, input=told, stdout=PIPE, env=os.environ | path, check=True)
    waiting, first, later, other = pickle.loads(ran.stdout)
    rtol = settings["rtol"]
    return [
        _row("first_calls", waiting, 1, 1, rtol, first, first / later),
        _row("calls", 1, 1, 1, rtol, later, 1.0),
        _row("new_calls", 1, 1, 1, rtol, other, other / later),
    ]


def _call_again(points, given, rounds):
    """How many calls a process makes before it loads the loop, and the least time [s] of a call before;
    and after, under the loads of all ``points`` on the first interface, and of the points themselves."""
    first = []
    while not availability.is_loaded() and len(first) < PATIENCE:
        first.append(processor_seconds(partial(solve, **points[0], **given)))

    def solve_each(some):
        for point in some:
            solve(**point, **given)

    loaded = [points[0] | {"load": point["load"]} for point in points]
    solve_each(points)
    sets = {"loaded": partial(solve_each, loaded), "points": partial(solve_each, points)}
    seconds = least_seconds(sets, rounds)
    *before, _ = first  # the last one has loaded it
    later, other = (seconds[name] / len(points) for name in ("loaded", "points"))
    return len(before), min(before), later, other


def _process_rows(parameters, budget):
    """Rows with the time on the clock for the same blocks in one process and in several, each of one
    thread."""
    settings = budget["processes"]
    rtol, block, blocks = settings["rtol"], settings["block"], settings["blocks"]
    points = block * blocks
    pools = {
        workers: partial(_wall_seconds_of, blocks, block, parameters, rtol, workers)
        for workers in (1, settings["workers"])
    }
    with _threads(1):
        seconds = least_seconds(pools, budget["rounds"], timed=call)
    return [
        _row("processes", points, workers, 1, rtol, each / points, seconds[1] / each)
        for workers, each in seconds.items()
    ]


def _thread_rows(parameters, budget):
    """Rows with the time on the clock for the same points by one thread and by several."""
    settings = budget["threads"]
    rtol, points = settings["rtol"], settings["points"]
    given = random_conditions(HEAVIEST, points, parameters)
    solving = partial(solve, **given, parameters=parameters, rtol=rtol, way=COMPILED)

    def seconds_of(threads):
        with _threads(threads):
            return wall_seconds(solving)

    solving()
    numbers = {threads: threads for threads in (1, settings["threads"])}
    seconds = least_seconds(numbers, budget["rounds"], timed=seconds_of)
    return [
        _row("threads", points, 1, threads, rtol, each / points, seconds[1] / each)
        for threads, each in seconds.items()
    ]


def _threads(number):
    """Context in which this process, and those that it starts, solve in so many threads at most."""
    return patch.dict(os.environ, OMP_NUM_THREADS=str(number))


def _wall_seconds_of(blocks, block, parameters, rtol, workers):
    """Time on the clock [s] of ``blocks`` in a pool whose ``workers`` have all solved once."""
    task = parameters, block, rtol
    with ProcessPoolExecutor(workers, initializer=_solve_block, initargs=task) as pool:
        list(pool.map(time.sleep, [WAKING] * workers))
        return wall_seconds(lambda: [each.result() for each in _submitted(pool, blocks, task)])


def _submitted(pool, blocks, task):
    return [pool.submit(_solve_block, *task) for _ in range(blocks)]


def _solve_block(parameters, block, rtol):
    """Solve points that this process draws once and keeps."""
    solve(**_points_of_block(parameters, block), parameters=parameters, rtol=rtol, way=COMPILED)


@cache
def _points_of_block(parameters, block):
    return random_conditions(HEAVIEST, block, parameters)


def _row(axis, points, processes, threads, rtol, seconds, ratio):
    return {
        "axis": axis,
        "points": points,
        "processes": processes,
        "threads": threads,
        "rtol": rtol,
        "microseconds_per_point": MICROSECONDS * seconds,
        "ratio": ratio,
    }
