"""Measure errors at points that are known in multiple precision, and check all extremes."""

from collections import Counter

from benchmarks.accuracy import error_rows
from benchmarks.baselines import load_plain_model
from benchmarks.extremes import judge_extremes
from benchmarks.points import read_rows
from chenhorng.job_log import job
from chenhorng.tables import TABLES, write_csv

with job(snakemake) as output:
    rtols = snakemake.params.rtol
    rows = error_rows(
        read_rows(snakemake.input.points), rtols, load_plain_model(snakemake.input.plain)
    )
    golden = read_rows(snakemake.input.extremes)
    judged = [row for rtol in rtols for row in judge_extremes(golden, rtol)]
    write_csv(output.errors, rows, TABLES["errors"])
    write_csv(output.verdicts, judged, TABLES["extremes"])
    library = [row for row in rows if row["method"].startswith("library")]
    worst = max(row["largest_error"] / row["rtol"] for row in library)
    print(f"largest error of the library over the error asked for: {worst:.3g}")
    print(dict(Counter(row["verdict"].partition(":")[0] for row in judged)))
