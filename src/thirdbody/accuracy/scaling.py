"""How the time of the heaviest class grows with the number of points, and falls with processes."""

from __future__ import annotations

import time
from concurrent.futures import ProcessPoolExecutor
from functools import cache

from thirdbody.accuracy.classes import HEAVIEST, random_conditions
from thirdbody.accuracy.measuring import MICROSECONDS, median_seconds, wall_seconds
from thirdbody.interface import solve
from thirdbody.parameters import Parameters

FEW_REPEATS = 25  # of sizes that are over in no time
WAKING = 0.5  # seconds: while one process waits, the pool starts the next


def scaling_rows(parameters: Parameters, budget) -> list[dict]:
    """Rows of the table ``scaling``; ``budget`` as in ``config/accuracy.yaml``."""
    return [*_size_rows(parameters, budget), *_process_rows(parameters, budget)]


def _size_rows(parameters, budget):
    """Processor time of a point for each number of points, over that of the cheapest."""
    settings = budget["sizes"]
    rtol = settings["rtol"]
    costs = {
        count: _seconds_of(count, settings["block"], parameters, rtol, budget["repeats"]) / count
        for count in settings["points"]
    }
    return [
        _row("points", count, 1, rtol, cost, cost / min(costs.values()))
        for count, cost in costs.items()
    ]


def _seconds_of(count, block, parameters, rtol, repeats):
    """Processor time [s] of ``count`` points, more than a ``block`` in several calls.

    Their results are dropped, as when they are streamed; drawing the points is not timed.
    """
    seconds = 0.0
    repeats = max(repeats, min(block // count, FEW_REPEATS)) if count <= block else 1
    for seed, start in enumerate(range(0, count, block)):
        size = min(block, count - start)
        given = random_conditions(HEAVIEST, size, parameters, seed)

        def run(given=given):
            solve(**given, parameters=parameters, rtol=rtol)

        if seed == 0:
            run()  # prepares the surface
        seconds += median_seconds(run, repeats)
    return seconds


def _process_rows(parameters, budget):
    """Time on the clock for the same blocks in one process and in several; speed over one."""
    settings = budget["processes"]
    rtol, block, blocks = settings["rtol"], settings["block"], settings["blocks"]
    points = block * blocks
    seconds = {
        workers: _wall_seconds_of(blocks, block, parameters, rtol, workers)
        for workers in (1, settings["workers"])
    }
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
    solve(**_points_of_block(parameters, block), parameters=parameters, rtol=rtol)


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
