"""Times of points and grids, of the baselines, and of typical uses."""

from pathlib import Path

from benchmarks.accuracy import time_rows
from benchmarks.baselines import load_plain_model
from benchmarks.uses import use_rows
from thirdbody.core.parameters import Parameters
from thirdbody.data.files import atomic_write
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged

with logged(snakemake.log[0]):
    budget = snakemake.params.budget
    inputs = Parameters(**snakemake.params.parameters)
    with atomic_write(snakemake.output.times, snakemake.output.uses) as (times_part, uses_part):
        rows = list(use_rows(inputs, budget, Path(snakemake.resources.tmpdir)))
        write_csv(uses_part, rows, TABLES["uses"])
        rows = time_rows(inputs, budget, load_plain_model(snakemake.input.plain))
        write_csv(times_part, rows, TABLES["times"])
    print(f"{len(rows)} times")
