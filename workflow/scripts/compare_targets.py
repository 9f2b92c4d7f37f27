"""Compare the measurements with the targets; nothing is measured here."""

from benchmarks.targets import target_rows
from chenhorng.job_log import job
from chenhorng.tables import TABLES, read_csv, write_csv

MEASURED = "errors", "extremes", "oracle", "times", "uses"

with job(snakemake) as output:
    rows = target_rows({name: read_csv(snakemake.input[name], TABLES[name]) for name in MEASURED})
    write_csv(output.targets, rows, TABLES["targets"])
    print(f"{sum(row['verdict'] == 'reached' for row in rows)} of {len(rows)} targets are reached")
