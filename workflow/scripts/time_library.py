"""Times of points and grids beside the baselines, and of typical uses."""

from pathlib import Path

from benchmarks.accuracy import time_rows
from benchmarks.baselines import load_plain_model
from benchmarks.uses import use_rows
from thirdbody.data.files import atomic_write
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged
from thirdbody.model.parameters import Parameters


def measure(plain, budget, parameters, directory, times, uses):
    """Write both tables; ``plain`` is the file of the plain equations."""
    inputs = Parameters(**parameters)
    with atomic_write(times, uses) as (times_part, uses_part):
        rows = list(use_rows(inputs, budget, Path(directory)))
        write_csv(uses_part, rows, TABLES["uses"])
        rows = time_rows(inputs, budget, load_plain_model(plain))
        write_csv(times_part, rows, TABLES["times"])
    print(f"{len(rows)} times")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        measure(
            snakemake.input.plain,
            snakemake.params.budget,
            snakemake.params.parameters,
            snakemake.resources.tmpdir,
            snakemake.output.times,
            snakemake.output.uses,
        )
