"""How the time of the heaviest class grows with the number of points, and falls with processes."""

from __future__ import annotations

import time
from concurrent.futures import ProcessPoolExecutor
from functools import cache, partial
from operator import call
from statistics import median

from benchmarks.classes import HEAVIEST, random_conditions
from benchmarks.measuring import (
    MICROSECONDS,
    least_seconds,
    processor_seconds,
    wall_seconds,
)
from thirdbody.model.parameters import Parameters
from thirdbody.solver.plan import COMPILED
from thirdbody.solver.solve import solve

WAKING = 0.5  # seconds: while one process waits, the pool starts the next


def scaling_rows(parameters: Parameters, budget) -> list[dict]:
    """Rows of the table ``scaling``; ``budget`` as in ``config/accuracy.yaml``."""
    return [*_size_rows(parameters, budget), *_process_rows(parameters, budget)]


def _size_rows(parameters, budget):
    """Processor time of a point for each number of points, over that of the cheapest.

    More than a block are solved block by block and their results dropped, as when they are
    streamed; of fewer, a block of points is solved in arrays of that size.  The sizes take turns, so
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
        _row("points", count, 1, rtol, cost, cost / min(costs.values()))
        for count, cost in costs.items()
    ]


def _solve_arrays(given, count, parameters, rtol):
    """Solve the points of ``given`` in arrays of ``count`` points at most."""
    for start in range(0, given["load"].size, count):
        some = {name: values[start : start + count] for name, values in given.items()}
        solve(**some, parameters=parameters, rtol=rtol, way=COMPILED)


def _process_rows(parameters, budget):
    """Least time on the clock for the same blocks in one process and in several; speed over one."""
    settings = budget["processes"]
    rtol, block, blocks = settings["rtol"], settings["block"], settings["blocks"]
    points = block * blocks
    pools = {
        workers: partial(_wall_seconds_of, blocks, block, parameters, rtol, workers)
        for workers in (1, settings["workers"])
    }
    seconds = least_seconds(pools, budget["rounds"], timed=call)
    return [
        _row("processes", points, workers, rtol, each / points, seconds[1] / each)
        for workers, each in seconds.items()
    ]


def _wall_seconds_of(blocks, block, parameters, rtol, workers):
    """Time on the clock [s] of ``blocks`` in a pool of ``workers`` that are up and prepared."""
    task = parameters, block, rtol
    with ProcessPoolExecutor(workers, initializer=_solve_block, initargs=task) as pool:
        list(pool.map(time.sleep, [WAKING] * workers))
        return wall_seconds(lambda: [each.result() for each in _submitted(pool, blocks, task)])


def _submitted(pool, blocks, task):
    return [pool.submit(_solve_block, *task) for _ in range(blocks)]


def _solve_block(parameters, block, rtol):
    """Solve the points that this process has drawn once and keeps."""
    solve(**_points_of_block(parameters, block), parameters=parameters, rtol=rtol, way=COMPILED)


@cache
def _points_of_block(parameters, block):
    return random_conditions(HEAVIEST, block, parameters)


def _row(axis, points, processes, rtol, seconds, ratio):
    return {
        "axis": axis,
        "points": points,
        "processes": processes,
        "rtol": rtol,
        "microseconds_per_point": MICROSECONDS * seconds,
        "ratio": ratio,
    }
