"""Time and memory of the atlas against its number of points, on one core and on two, by real runs.

    python -m benchmarks.measure_atlas [--points 1e6 1e7 1e8 1e9] [--cores 1 2]

Each run is `snakemake` in a folder of its own, from its start to the catalogue, on the axes of
config/atlas.yaml with fewer or more values; points are combinations of the axes times sets of inputs.
What is not solving is all processor time of the jobs but that of the solver and of its searches.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import yaml

from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.configuration.schema import config_directory
from thirdbody.data.tables import TABLES, read_csv

COUNTS = {  # of the evenly spaced values at 1e9 points of 16 sets of inputs
    "load_N": 96,
    "viscosity_cSt": 42,
    "particle_diameter_nm": 50,
    "roughness_nm": 24,
    "particle_density_per_m2": 13,
}
FULL = 1e9
ROOT = Path(__file__).resolve().parents[1]


def settings(points: float) -> dict:
    """Those of an atlas of about so many points: all axes have fewer or more values alike."""
    content = read_yaml(config_directory() / "atlas.yaml")
    for key, axis in content["axes"].items():
        axis |= {"count": max(round(COUNTS[key] * (points / FULL) ** 0.2), 2), "also": []}
    ends = {key: axis["from"] for key, axis in content["axes"].items()}
    for name, shown in content["charts"].items():
        panel = {key: ends[key] for key in shown[0]} if name not in ends else ends[name]
        content["charts"][name] = [panel]
    content["chunks"] = min(content["chunks"], content["axes"]["roughness_nm"]["count"])
    return content


def measured(points: float, cores: int) -> dict[str, float]:
    """What a run of about so many points takes."""
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        (place / "config").mkdir()
        (place / "config/measured.yaml").write_text(yaml.safe_dump(settings(points)))
        (place / "changes.yaml").write_text("atlas: config/measured.yaml\n")
        command = (
            *(str(Path(sys.executable).with_name("snakemake")), f"-c{cores}"),
            *("results/atlas/catalogue.json", "--snakefile", str(ROOT / "workflow/Snakefile")),
            *("--directory", folder, "--config", "changes=changes.yaml"),
            *("--workflow-profile", str(ROOT / "workflow/profiles/default")),
        )
        library = {"PYTHONPATH": os.pathsep.join([str(ROOT / "src"), str(ROOT)])}
        start = time.perf_counter()
        run = subprocess.run(
            command, cwd=folder, env=os.environ | library, capture_output=True, text=True
        )
        seconds = time.perf_counter() - start
        if run.returncode:
            raise SystemExit(run.stderr)
        rows = read_csv(place / "results/atlas/cost.csv", TABLES["atlas_cost"])
    total = {name: sum(row[name] for row in rows) for name in rows[0] if name != "chunk"}
    solving = total["solving_seconds"] + total["searching_seconds"]
    return {
        "points": total["points"],
        "seconds": seconds,
        "microseconds_per_point": 1e6 * seconds / total["points"],
        "processor_seconds": total["seconds"],
        "not_solving": 1.0 - solving / total["seconds"],
        "peak_MB": max(row["resident_memory_MB"] for row in rows),
        "files_MB": total["file_MB"],
    }


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--points", type=float, nargs="+", default=[1e6, 1e7, 1e8, 1e9])
    parser.add_argument("--cores", type=int, nargs="+", default=[1, 2])
    given = parser.parse_args()
    for points in given.points:
        for cores in given.cores:
            found = measured(points, cores)
            told = ", ".join(f"{name} {value:.4g}" for name, value in found.items())
            print(f"{cores} cores: {told}", flush=True)
