"""Time of a point in the library and in the baselines, class by class."""

from benchmarks.baselines import load_plain_model
from benchmarks.times import time_rows
from thirdbody.data.files import whole
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged
from thirdbody.model.parameters import Parameters


def measure(plain, budget, parameters, times):
    """Write the times that ``budget`` asks for; ``plain`` is the file of the plain equations."""
    rows = time_rows(Parameters(**parameters), budget, load_plain_model(plain))
    with whole(times) as part:
        write_csv(part, rows, TABLES["times"])
    print(f"{len(rows)} times")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        measure(
            snakemake.input.plain,
            snakemake.params.budget,
            snakemake.params.parameters,
            snakemake.output.times,
        )
