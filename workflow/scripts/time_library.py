"""Measure the times of points and grids, of the baselines, and of typical uses."""

import os
from pathlib import Path

# users run the library with the instructions that the workflow switches off
for name in ("NPY_DISABLE_CPU_FEATURES", "OPENBLAS_CORETYPE"):
    os.environ.pop(name, None)

from benchmarks.accuracy import time_rows
from benchmarks.baselines import load_plain_model
from benchmarks.uses import use_rows
from chenhorng.job_log import job
from chenhorng.tables import TABLES, write_csv
from thirdbody.core.parameters import Parameters

with job(snakemake) as output:
    budget = snakemake.params.budget
    inputs = Parameters(**snakemake.params.parameters)
    rows = list(use_rows(inputs, budget, Path(snakemake.resources.tmpdir)))
    write_csv(output.uses, rows, TABLES["uses"])
    rows = time_rows(inputs, budget, load_plain_model(snakemake.input.plain))
    write_csv(output.times, rows, TABLES["times"])
    print(f"{len(rows)} times")
