"""Time from the start of a process to its answer, by each way of solving: what a person waits.

``python -m benchmarks.starts`` prints the numbers of points from which one way takes less time
than another; they are the constants of ``thirdbody.solver.plan``.

A *run* is described by ``(points, start, way)``: how many points a new process solves, whether it
finds the loop compiled on disk, and by which way it solves.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from itertools import count, repeat
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from benchmarks.measuring import least_seconds, wall_seconds
from thirdbody.configuration.inputs import load_parameters
from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.model.parameters import Parameters
from thirdbody.solver.plan import COMPILED, QUADRATURE, TABLES, WAYS
from thirdbody.solver.solve import solve

ACCURACY = Path(__file__).parents[1] / "config" / "accuracy.yaml"
# Starts: with nothing compiled on disk, or with the loop that an earlier process compiled.
COLD, WARM = "cold", "warm"
LUBRICATED = {"viscosity": 9e-5, "particle_diameter": 5e-7, "particle_density": 1e11}
AUTOMATIC = "automatic"  # the way that the library chooses
ROUNDS = 15  # of calls that take some milliseconds each
SIZES = [2**power for power in range(4, 12)]  # numbers of points of these calls
NOISE = 0.5  # of the time of a process, at most
Run = tuple[int, str, str]  # points, start, way
PROGRAM = """
import sys
import numpy as np
import thirdbody
points, rtol, way = int(sys.argv[1]), float(sys.argv[2]), sys.argv[3]
loads = np.random.default_rng(0).permutation(np.geomspace(1e-7, 1e-4, points))
thirdbody.solve(
    load=loads, viscosity=9e-5, particle_diameter=5e-7, roughness=3e-7, particle_density=1e11,
    parameters=thirdbody.load_parameters(), rtol=rtol, way=None if way == "automatic" else way,
)
"""


def start_rows(budget: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Measure the time from the start of a process to the solution of lubricated three-body points.

    Parameters
    ----------
    budget : mapping
        The entry ``starts`` of ``config/accuracy.yaml``.

    Returns
    -------
    list of dict
        Rows of the table ``starts``: least time of each number of points, start and way.
    """
    with TemporaryDirectory() as kept:
        run_process(kept, budget["rtol"], (1, WARM, COMPILED))  # leaves the compiled loop there
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


def run_of(points: int, start: str, way: str) -> Run:
    """The run that a row of the table is about.

    What is compiled on disk makes no difference to tables and quadrature: rows that differ in the
    start alone are about the same run of these.
    """
    return points, start if way in (COMPILED, AUTOMATIC) else WARM, way


def over_best(times: Mapping[Run, float | None], points: int, start: str, way: str) -> float | None:
    """Time of a way over that of the fastest way [1], for so many points and this start.

    None if the run, or each way, was left out.

    Examples
    --------
    >>> times = {(1, WARM, QUADRATURE): 0.5, (1, WARM, TABLES): 1.0, (1, WARM, COMPILED): None}
    >>> over_best(times, 1, WARM, TABLES)
    2.0
    """
    seconds = times[run_of(points, start, way)]
    timed = [times[run_of(points, start, each)] for each in WAYS]
    best = min((each for each in timed if each), default=None)
    return seconds and best and seconds / best


def least_times(
    timed: Callable[[Run], float], budget: Mapping[str, Any]
) -> dict[Run, float | None]:
    """Least time of each run.

    All runs take turns, so that what else the machine does falls on all of them.  A run is repeated
    as often as ``rounds`` says, or until it has taken ``enough_seconds`` in all.

    Parameters
    ----------
    timed : callable
        Makes a run and returns its time [s].
    budget : mapping
        The entry ``starts`` of ``config/accuracy.yaml``.

    Returns
    -------
    dict
        Times [s] by run; None where it is expected to take longer than ``limit_seconds``.
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
            chosen = run[-1] == AUTOMATIC  # is as fast as the best way, whatever fewer points took
            if not enough and (chosen or expected_seconds(run, runs) <= budget["limit_seconds"]):
                times.append(timed(run))
    return {run: min(times, default=None) for run, times in runs.items()}


def expected_seconds(run: Run, runs: Mapping[Run, Sequence[float]]) -> float:
    """Time [s] that a run will take, if a point costs as much as in the runs with fewer points.

    Where that cannot be told from noise, it is the time of the last run with fewer points.

    Parameters
    ----------
    run : tuple
        The run.
    runs : mapping
        Times [s] of all runs so far.

    Returns
    -------
    float
        0 if no run with fewer points is known.

    Examples
    --------
    >>> expected_seconds((100, WARM, TABLES), {(1, WARM, TABLES): [1.0], (10, WARM, TABLES): [2.0]})
    11.0
    """
    points, *same = run
    fewer = [(other[0], min(t)) for other, t in runs.items() if t and list(other[1:]) == same]
    fewer = [(number, seconds) for number, seconds in fewer if number < points]
    if not fewer:
        return 0.0
    (_, start), (number, seconds) = fewer[0], fewer[-1]
    if seconds < (1.0 + NOISE) * start:
        return seconds
    return start + (seconds - start) * points / number


def process_seconds(kept: str, rtol: float, run: Run) -> float:
    """Time on the clock [s] of a run; ``kept`` is the folder that holds the compiled loop."""
    _, start, _ = run
    if start == WARM:
        return wall_seconds(partial(run_process, kept, rtol, run))
    with TemporaryDirectory() as empty:
        return wall_seconds(partial(run_process, empty, rtol, run))


def run_process(kept: str, rtol: float, run: Run) -> None:
    """Solve in a new process, which keeps what it compiles in the folder ``kept``.

    Raises
    ------
    subprocess.CalledProcessError
        If the process fails.
    """
    points, _, way = run
    command = [sys.executable, "-c", PROGRAM, str(points), repr(rtol), way]
    subprocess.run(command, env=os.environ | {"NUMBA_CACHE_DIR": kept}, check=True)


def loading_break_even(rows: Sequence[Mapping[str, Any]], start: str) -> float:
    """Number of points from which the compiled loop is faster than tables.

    Parameters
    ----------
    rows : sequence of mapping
        Rows of the table ``starts``.
    start : str
        ``COLD`` or ``WARM``.
    """
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


def surface_break_even(
    parameters: Parameters, rtol: float, ways: Sequence[str], roughness: Iterator[float]
) -> float:
    """Number of points on a new roughness from which one way is faster than another.

    The process has used both ways before.

    Parameters
    ----------
    parameters : Parameters
        Inputs of the model.
    rtol : float
        Relative error asked for [1].
    ways : sequence of str
        Two ways; the second is the one that is faster for many points.
    roughness : iterator of float
        Each sigma [m] that it gives is a new one, for which there are no tables.
    """
    times = {way: _seconds_of_calls(parameters, rtol, way, SIZES, roughness) for way in ways}
    return break_even(SIZES, *times.values())


def call_worths(parameters: Parameters, rtol: float) -> tuple[float, float, float]:
    """Numbers of points by quadrature that take as long as a call of quadrature does before it solves
    any, and as long as the loop takes for one point on a roughness whose tables it has; and number of
    points by tables that take as long as one by quadrature.

    Parameters
    ----------
    parameters : Parameters
        Inputs of the model.
    rtol : float
        Relative error asked for [1].
    """
    one, some, more = _seconds_of_calls(parameters, rtol, QUADRATURE, (1, 200, 600), repeat(3e-7))
    (loop,) = _seconds_of_calls(parameters, rtol, COMPILED, (1,), repeat(3e-7))
    few, many = _seconds_of_calls(parameters, rtol, TABLES, (4000, 12000), repeat(3e-7))
    point, by_tables = (more - some) / 400, (many - few) / 8000
    return one / point - 1.0, loop / point, point / by_tables


def _seconds_of_calls(parameters, rtol, way, sizes, roughness):
    """Least times [s] of calls with so many points, each on the next ``roughness`` [m]; the process
    has used the way before."""

    def run(size):
        loads = np.geomspace(1e-7, 1e-5, size)
        given = LUBRICATED | {"load": loads, "roughness": next(roughness)}
        solve(**given, parameters=parameters, rtol=rtol, way=way)

    run(1)
    times = least_seconds({size: partial(run, size) for size in sizes}, ROUNDS)
    return [times[size] for size in sizes]


def break_even(sizes: Sequence[float], first: Sequence[float], second: Sequence[float]) -> float:
    """Size from which a way takes less time than another.

    Parameters
    ----------
    sizes : sequence of float
        Numbers of points, increasing.
    first, second : sequence of float
        Times of the two ways for these sizes [s].

    Returns
    -------
    float
        Where the second way becomes the faster one, interpolated between the sizes; nan where it
        is faster, or slower, for all of them.

    Examples
    --------
    >>> break_even([10, 20, 30], first=[1.0, 2.0, 3.0], second=[2.0, 2.0, 2.0])
    20.0
    """
    saved = np.maximum.accumulate(np.subtract(first, second))
    return float(np.interp(0.0, saved, sizes, left=np.nan, right=np.nan))


def main() -> None:
    """Print all break-evens, at the tolerance of ``config/accuracy.yaml``."""
    budget = read_yaml(ACCURACY)["starts"]
    inputs, rtol = load_parameters(), budget["rtol"]
    new = (3e-7 * (1.0 + 1e-6 * number) for number in count())
    for name, way in (("TABLE_WORTH", TABLES), ("LOOP_WORTH", COMPILED)):
        print(f"{name} {surface_break_even(inputs, rtol, (QUADRATURE, way), new):.2g}")
    names = "CALL_WORTH", "GROUP_WORTH", "QUADRATURE_WORTH"
    for name, worth in zip(names, call_worths(inputs, rtol), strict=True):
        print(f"{name} {worth:.2g}")
    rows = start_rows(budget)
    for name, start in (("LOADING_WORTH", WARM), ("COMPILING_WORTH", COLD)):
        print(f"{name} {loading_break_even(rows, start):.2g}")


if __name__ == "__main__":
    main()
