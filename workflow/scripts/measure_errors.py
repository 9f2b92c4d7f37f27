"""Errors of the library and of the baselines at points known in multiple precision."""

from benchmarks.baselines import load_plain_model
from benchmarks.errors import error_rows
from benchmarks.points import read_rows
from thirdbody.data.files import whole
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged


def measure(points, plain, rtols, errors):
    """Write the errors at the golden ``points`` for each of ``rtols``; ``plain`` is the file of
    the plain equations."""
    rows = error_rows(read_rows(points), rtols, load_plain_model(plain))
    with whole(errors) as part:
        write_csv(part, rows, TABLES["errors"])
    worst = max(row["largest_error"] / row["rtol"] for row in rows if row["method"] == "library")
    print(f"largest error of the library over the error asked for: {worst:.3g}")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        measure(
            snakemake.input.points,
            snakemake.input.plain,
            snakemake.params.rtol,
            snakemake.output.errors,
        )
