"""From the start of a process to its answer: what a person waits for, by each way of solving.

``python -m benchmarks.starts`` prints the numbers of points from which one way takes less time
than the next, which ``thirdbody.solver.plan`` keeps as its constants.
"""

from __future__ import annotations

import os
import subprocess
import sys
from functools import partial
from itertools import count
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from benchmarks.measuring import least_seconds, wall_seconds
from thirdbody.configuration.inputs import load_parameters
from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.solver.plan import COMPILED, LOOP_WORTH, QUADRATURE, TABLE_WORTH, TABLES, WAYS
from thirdbody.solver.solve import solve

ACCURACY = Path(__file__).parents[1] / "config" / "accuracy.yaml"
COLD, WARM = "cold", "warm"  # nothing compiled on disk; the loop that an earlier process compiled
AUTOMATIC = "automatic"
ROUNDS = 15  # of what takes some milliseconds
PROGRAM = """
import sys
import numpy as np
import thirdbody
points, rtol, way = int(sys.argv[1]), float(sys.argv[2]), sys.argv[3]
loads = np.random.default_rng(0).permutation(np.geomspace(1e-7, 1e-4, points))
thirdbody.solve(
    loads, 9e-5, 5e-7, 3e-7, 1e11, thirdbody.load_parameters(), rtol,
    way=None if way == "automatic" else way,
)
"""


def start_rows(budget) -> list[dict]:
    """Time from the start of a process to the solution of lubricated three-body points.

    Parameters
    ----------
    budget : dict
        What ``config/accuracy.yaml`` says under ``starts``.

    Returns
    -------
    list of dict
        Rows of the table ``starts``: least time of each number of points, start and way.
    """
    with TemporaryDirectory() as kept:
        run_process(kept, budget["rtol"], (1, WARM, COMPILED))  # fills the folder
        times = least_times(partial(process_seconds, kept, budget["rtol"]), budget)
    return [
        {
            "points": points,
            "start": start,
            "way": way,
            "seconds": times[run_of(points, start, way)],
            "over_best": over_best(times, points, start, way),
            "remark": "" if times[run_of(points, start, way)] else "left out: takes too long",
        }
        for points in budget["points"]
        for start in (COLD, WARM)
        for way in (*WAYS, AUTOMATIC)
    ]


def run_of(points, start, way) -> tuple:
    """The run that a row tells of: what is compiled on disk matters to two ways alone."""
    return points, start if way in (COMPILED, AUTOMATIC) else WARM, way


def over_best(times, points, start, way):
    """The time of a way over that of the fastest of all; None where it was left out."""
    seconds = times[run_of(points, start, way)]
    ways = (times[run_of(points, start, each)] for each in WAYS)
    return seconds and seconds / min(each for each in ways if each)


def least_times(timed, budget) -> dict:
    """Least time of each run, or None where it is expected to take too long.

    All runs take turns, so that what else the machine does falls on all of them; a run is
    repeated until it has had its ``rounds``, or so many seconds that noise matters little.
    """
    runs = {
        run_of(points, start, way): []
        for points in sorted(budget["points"])
        for start in (COLD, WARM)
        for way in (*WAYS, AUTOMATIC)
    }
    for _ in range(budget["rounds"]):
        for run, times in runs.items():
            enough = sum(times) >= budget["enough_seconds"]
            if not enough and expected_seconds(run, runs) <= budget["limit_seconds"]:
                times.append(timed(run))
    return {run: min(times, default=None) for run, times in runs.items()}


def expected_seconds(run, runs) -> float:
    """What a run will take if each point takes as long as in those with fewer points."""
    points, *same = run
    fewer = [(other[0], min(t)) for other, t in runs.items() if t and list(other[1:]) == same]
    fewer = [(number, seconds) for number, seconds in fewer if number < points]
    if not fewer:
        return 0.0
    (_, start), (number, seconds) = fewer[0], fewer[-1]
    return start + max(seconds - start, 0.0) * points / number


def process_seconds(kept, rtol, run) -> float:
    """Time on the clock [s] of a process; ``kept`` is the folder of what is compiled."""
    _, start, _ = run
    if start == WARM:
        return wall_seconds(partial(run_process, kept, rtol, run))
    with TemporaryDirectory() as empty:
        return wall_seconds(partial(run_process, empty, rtol, run))


def run_process(kept, rtol, run) -> None:
    """Solve in a process of its own."""
    points, _, way = run
    command = [sys.executable, "-c", PROGRAM, str(points), repr(rtol), way]
    subprocess.run(command, env=os.environ | {"NUMBA_CACHE_DIR": kept}, check=True)


def loading_break_even(rows, start) -> float:
    """Number of points from which the compiled loop is faster than tables after this ``start``."""
    seconds = {
        way: {
            row["points"]: row["seconds"]
            for row in rows
            if (row["start"], row["way"]) == (start, way)
        }
        for way in (TABLES, COMPILED)
    }
    sizes = [size for size in seconds[TABLES] if all(each[size] for each in seconds.values())]
    return break_even(sizes, *([each[size] for size in sizes] for each in seconds.values()))


def surface_break_even(parameters, rtol, ways, points) -> float:
    """Number of points on a new roughness from which the second of two ways is faster than the
    first, in a process that has used both; sought from a quarter of ``points`` to four times."""
    roughness = (3e-7 * (1.0 + 1e-6 * number) for number in count())

    def run(way, size):
        loads = np.geomspace(1e-7, 1e-5, size)
        solve(loads, 9e-5, 5e-7, next(roughness), 1e11, parameters, rtol, way=way)

    sizes = [int(points * factor) for factor in (0.25, 0.5, 1.0, 2.0, 4.0)]
    runs = {(way, size): partial(run, way, size) for way in ways for size in sizes}
    times = least_seconds(runs, ROUNDS)
    return break_even(sizes, *([times[way, size] for size in sizes] for way in ways))


def break_even(sizes, first, second) -> float:
    """Size from which ``second`` takes less time than ``first``, between two of ``sizes``."""
    saved = np.subtract(first, second)
    return float(np.interp(0.0, np.maximum.accumulate(saved), sizes))


def main() -> None:
    """Print all break-evens, at the tolerance of ``config/accuracy.yaml``."""
    budget = read_yaml(ACCURACY)["starts"]
    inputs, rtol = load_parameters(), budget["rtol"]
    for name, ways, points in (
        ("TABLE_WORTH", (QUADRATURE, TABLES), TABLE_WORTH),
        ("LOOP_WORTH", (TABLES, COMPILED), LOOP_WORTH),
    ):
        print(f"{name} {surface_break_even(inputs, rtol, ways, points):.2g}")
    rows = start_rows(budget)
    for name, start in (("LOADING_WORTH", WARM), ("COMPILING_WORTH", COLD)):
        print(f"{name} {loading_break_even(rows, start):.2g}")


if __name__ == "__main__":
    main()
