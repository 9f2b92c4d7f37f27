"""Which digits depend on the processor: all figures, solved with some of its instructions off.

    python -m benchmarks.processors

A process for each row solves the points with fewer of numpy's optional instructions, with the
linear algebra of another processor, or with both.  The table compares values with those of the
first row.
"""

import os
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from time import process_time

import numpy as np
from tabulate import tabulate

import thirdbody
from chenhorng.configuration.settings import read_settings
from chenhorng.home import config_directory
from chenhorng.scenes import scene_groups
from thirdbody.core.solve import solve_points
from thirdbody.grids import crossed
from thirdbody.variables import NUMBERS

ROUNDS = 5
OPTIONAL = " ".join(np.show_config(mode="dicts")["SIMD Extensions"].get("found", []))
PLAIN_NUMPY = {"NPY_DISABLE_CPU_FEATURES": OPTIONAL}
PLAIN_ALGEBRA = {"OPENBLAS_CORETYPE": "Prescott"}
SETTINGS = {
    "as it is": {},
    "numpy without optional instructions": PLAIN_NUMPY,
    "linear algebra of a Pentium 4": PLAIN_ALGEBRA,
    "both": PLAIN_NUMPY | PLAIN_ALGEBRA,
}


def solve_figures(path: str) -> None:
    """Write the numbers of all figures, one after another, and the least time [s] to the file
    ``path``.
    """
    parameters = thirdbody.load_parameters().best
    settings = read_settings({}, config_directory())
    groups = [
        crossed(group)
        for scene in settings["scenes"].values()
        for group in scene_groups(
            {"load_axis": settings["load_axis"]} | scene, parameters.newtons_per_load
        )
    ]
    seconds = []
    for _ in range(ROUNDS):
        start = process_time()
        solved = [solve_points(group, parameters, settings["rtol"], NUMBERS) for group in groups]
        seconds.append(process_time() - start)
    numbers = np.concatenate(
        [
            variables[name].ravel()
            for variables in solved
            for name in NUMBERS
            if name != "error_bound"
        ]
    )
    np.savez(path, numbers=numbers, seconds=min(seconds))


def main() -> None:
    """Print the table."""
    rows, numbers = [], {}
    with TemporaryDirectory() as folder:
        for name, variables in SETTINGS.items():
            path = str(Path(folder) / "solved.npz")
            command = [sys.executable, "-m", "benchmarks.processors", path]
            subprocess.run(command, env=os.environ | variables, check=True)
            with np.load(path) as found:
                numbers[name], seconds = found["numbers"], found["seconds"].item()
            first = numbers["as it is"]
            known = np.isfinite(first) & (first != 0.0)
            change = np.abs(numbers[name][known] / first[known] - 1.0)
            rows.append(
                {
                    "processor": name,
                    "numbers that differ": f"{np.mean(change > 0.0):.1%}",
                    "largest relative difference": f"{change.max():.0e}" if change.any() else "0",
                    "time": f"{seconds / rows[0]['seconds'] if rows else 1.0:.2f}",
                    "seconds": seconds,
                }
            )
    shown = [{key: row[key] for key in row if key != "seconds"} for row in rows]
    print(tabulate(shown, headers="keys", tablefmt="github", disable_numparse=True))


if __name__ == "__main__":
    solve_figures(sys.argv[1]) if sys.argv[1:] else main()
