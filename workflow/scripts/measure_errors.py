"""Errors at points known in multiple precision, and the verdict on every extreme."""

from collections import Counter

from benchmarks.accuracy import error_rows
from benchmarks.baselines import load_plain_model
from benchmarks.extremes import judge_extremes
from benchmarks.points import read_rows
from thirdbody.data.files import atomic_write
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged


def measure(points, extremes, plain, rtols, errors, verdicts):
    """Write both tables for each of ``rtols``; ``plain`` is the file of the plain equations."""
    rows = error_rows(read_rows(points), rtols, load_plain_model(plain))
    golden = read_rows(extremes)
    judged = [row for rtol in rtols for row in judge_extremes(golden, rtol)]
    with atomic_write(errors, verdicts) as (errors_part, verdicts_part):
        write_csv(errors_part, rows, TABLES["errors"])
        write_csv(verdicts_part, judged, TABLES["extremes"])
    library = [row for row in rows if row["method"].startswith("library")]
    worst = max(row["largest_error"] / row["rtol"] for row in library)
    print(f"largest error of the library over the error asked for: {worst:.3g}")
    print(dict(Counter(row["verdict"].partition(":")[0] for row in judged)))


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        measure(
            snakemake.input.points,
            snakemake.input.extremes,
            snakemake.input.plain,
            snakemake.params.rtol,
            snakemake.output.errors,
            snakemake.output.verdicts,
        )
