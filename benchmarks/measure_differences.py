"""How datasets differ from those of an earlier version, under the inputs of then: docs/differences.md.

    git archive --prefix=before/ 4d71c003 | tar x --directory /tmp
    python -m benchmarks.measure_differences /tmp/before

The version of then solves figures 3 to 13 for each of its calibrated readings, into the folder `then` of
its own, where what is there is taken as it is; today's solves the same points.  Prints a table for the
default of then, and one for the other readings.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
from collections import Counter
from pathlib import Path
from typing import NamedTuple

import netCDF4
import numpy as np
from tabulate import tabulate

import thirdbody as tb
from benchmarks.points import VARIABLES, relative_error
from thirdbody.data.conditions import DIMENSIONS
from thirdbody.data.quantities import FILL_FLOAT
from thirdbody.model.regimes import SOLUTION_STATUSES
from thirdbody.solver.plan import REPEATABLE

DEFAULT = "centred_plane_free"  # of then
# run by the version of then, in its folder: a reading, and where its datasets go
SOLVE = """
import json, pathlib, sys, yaml
from thirdbody.configuration.settings import workflow_settings
from thirdbody.data.dataset import scene_dataset
from thirdbody.data.netcdf import write_dataset
from thirdbody.data.scene import Scene
from thirdbody.model.parameters import Parameters
reading, folder = sys.argv[1], pathlib.Path(sys.argv[2])
config, scenes = (yaml.safe_load(open(f"config/{name}.yaml")) for name in ("config", "scenes"))
settings = workflow_settings(config | scenes | {"inputs": f"config/calibrated/{reading}.yaml"})
inputs = Parameters(**settings["parameters"])
folder.mkdir(parents=True)
for name, scene in settings["scenes"].items():
    shown = Scene.of(name, scene, inputs.newtons_per_load)
    write_dataset(scene_dataset(shown, inputs, scene["rtol"]), folder / f"{name}.nc")
(folder / "parameters.json").write_text(json.dumps(inputs.as_dict()))
"""


class Difference(NamedTuple):
    """Between a dataset of then and the same points today."""

    figure: str
    points: int
    change: float  # the largest relative one of any variable
    variable: str  # which has it
    statuses: Counter  # pairs of statuses that differ


def solved_then(before: Path, reading: str) -> Path:
    """The folder of datasets of a ``reading``, solved by the version in the folder ``before``."""
    folder = before / "then" / reading
    if not (folder / "parameters.json").is_file():
        environment = os.environ | {"PYTHONPATH": str(before / "src")}
        command = [sys.executable, "-W", "ignore", "-c", SOLVE, reading, str(folder)]
        subprocess.run(command, cwd=before, env=environment, check=True)
    return folder


def differences(folder: Path) -> list[Difference]:
    """A row a figure."""
    given = json.loads((folder / "parameters.json").read_text(encoding="utf-8"))
    inputs = tb.Parameters(**{"particle_plane": "surface"} | given)  # the only plane of then
    return [_difference(path, inputs) for path in sorted(folder.glob("*.nc"))]


def _difference(path, inputs):
    with netCDF4.Dataset(path) as file:
        file.set_auto_maskandscale(False)
        places = np.nonzero(file["separation"][:] != FILL_FLOAT)
        then = {name: file[name][:][places] for name in (*VARIABLES, "solution_status")}
        given = {name: file[name][:][at] for name, at in zip(DIMENSIONS, places, strict=True)}
        meanings = np.array(file["solution_status"].flag_meanings.split())
        rtol = float(file.rtol)
    now = tb.solve(**given, parameters=inputs, rtol=rtol, way=REPEATABLE)
    none = np.isnan(then["separation"]) & np.isnan(now.separation)
    changes = {
        name: np.where(none, 0.0, relative_error(then[name], getattr(now, name))).max()
        for name in VARIABLES
    }
    variable = max(changes, key=changes.get)
    statuses = zip(
        meanings[then["solution_status"]].tolist(),
        np.array(SOLUTION_STATUSES)[now.solution_status].tolist(),
        strict=True,
    )
    differing = Counter(pair for pair in statuses if pair[0] != pair[1])
    return Difference(path.stem, len(none), changes[variable], variable, differing)


def told(statuses: Counter) -> str:
    """How many points have which other status now."""
    return ", ".join(f"{count}: {then} → {now}" for (then, now), count in statuses.items())


def main(before: Path):
    """Print both tables."""
    readings = sorted(path.stem for path in (before / "config" / "calibrated").glob("*.yaml"))
    found = {name: differences(solved_then(before, name)) for name in readings}
    rows = [
        [row.figure, row.points, f"{row.change:.1e}", f"`{row.variable}`", told(row.statuses)]
        for row in found.pop(DEFAULT)
    ]
    headings = ["figure", "points", "largest relative change", "of", "another status"]
    print(tabulate(rows, headings, tablefmt="github", disable_numparse=True), end="\n\n")
    rows = []
    for name, each in found.items():
        most = max(each, key=lambda row: row.change)
        statuses = told(sum((row.statuses for row in each), Counter()))
        rows.append(
            [f"`{name}`", f"{most.change:.1e}", f"`{most.variable}`, {most.figure}", statuses]
        )
    headings = ["reading", "largest relative change", "of", "another status"]
    print(tabulate(rows, headings, tablefmt="github", disable_numparse=True))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("before", type=Path, help="folder of the earlier version")
    main(parser.parse_args().before.resolve())
