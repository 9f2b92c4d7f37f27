"""Time of typical uses: one point alone, many surfaces, a grid to a file, the first answer of a new
process.
"""

import math
import resource
import subprocess
import sys
import warnings
from collections.abc import Iterator, Mapping
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter, process_time
from typing import Any

import numpy as np

import thirdbody as tb
from benchmarks.classes import HEAVIEST, MICROSECONDS, grid_axes, least_seconds, random_conditions

ONE, SURFACES, STREAM, START = (
    "one point a call",
    "each point on a surface of its own",
    "a grid streamed to a file",
    "import and first answer in a new process",
)
ROUGHNESS = 100e-9, 500e-9  # ends of sigma [m], those of the paper
FIRST_ANSWER = """
import thirdbody as tb
tb.solve(load=1e-5, viscosity=9e-5, particle_diameter=5e-7, roughness=3e-7, particle_density=1e11,
         parameters=tb.load_parameters(), rtol={rtol})
"""


def use_rows(
    parameters: tb.Parameters, budget: Mapping[str, Any], directory: Path
) -> Iterator[dict[str, Any]]:
    """Rows of the table ``uses``, of as many points as ``config/accuracy.yaml`` says.

    A grid is written to a file in ``directory``, and the file is removed.
    """
    rtol, sizes = budget["uses"]["rtol"], budget["uses"]
    asked = {"parameters": parameters, "rtol": rtol}
    drawn = random_conditions(HEAVIEST, max(sizes["calls"], sizes["surfaces"]), parameters)
    points = [dict(zip(drawn, map(float, one), strict=True)) for one in zip(*drawn.values())]
    axes = grid_axes(HEAVIEST, budget["grid"][HEAVIEST.span], parameters)

    def call_each():
        for point in points[: sizes["calls"]]:
            tb.solve(**point, **asked)

    def solve_surfaces():
        count = sizes["surfaces"]
        given = {name: values[:count] for name, values in drawn.items()}
        tb.solve(**given | {"roughness": np.geomspace(*ROUGHNESS, count)}, **asked)

    def stream():
        with TemporaryDirectory(dir=directory) as folder:
            tb.stream(Path(folder) / "grid.nc", **axes, **asked, progress=False)

    command = [sys.executable, "-c", FIRST_ANSWER.format(rtol=rtol)]
    runs = {
        ONE: (call_each, process_time, sizes["calls"]),
        SURFACES: (solve_surfaces, process_time, sizes["surfaces"]),
        STREAM: (stream, perf_counter, math.prod(axis.size for axis in axes.values())),
        START: (partial(subprocess.run, command, check=True), perf_counter, 1),
    }
    with warnings.catch_warnings(action="ignore"):
        for use, (function, clock, count) in runs.items():
            seconds = least_seconds({use: function}, budget["rounds"], clock)[use]
            yield {
                "use": use,
                "points": count,
                "rtol": rtol,
                "seconds": seconds,
                "microseconds_per_point": MICROSECONDS * seconds / count,
                "resident_memory_MB": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e3,
            }
