"""Compare the measurements with the targets; nothing is measured here."""

from benchmarks.targets import target_rows
from thirdbody.data.files import atomic_write
from thirdbody.data.tables import TABLES, read_csv, write_csv
from thirdbody.job_log import logged

MEASURED = "errors", "extremes", "oracle", "times", "uses"

with logged(snakemake.log[0]):
    rows = target_rows({name: read_csv(snakemake.input[name], TABLES[name]) for name in MEASURED})
    with atomic_write(snakemake.output.targets) as part:
        write_csv(part, rows, TABLES["targets"])
    print(f"{sum(row['verdict'] == 'reached' for row in rows)} of {len(rows)} targets are reached")
