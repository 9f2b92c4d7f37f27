"""Compare the library with the oracle in extended precision, in all interpretations."""

from benchmarks.oracle import oracle_rows
from chenhorng.job_log import job
from chenhorng.tables import TABLES, write_csv

with job(snakemake) as output:
    rows = oracle_rows(snakemake.params.settings, snakemake.threads)
    write_csv(output.table, rows, TABLES["oracle"])
    points, beyond, wrong = (
        sum(row[name] for row in rows) for name in ("points", "beyond_bound", "wrong")
    )
    print(f"{points} points: {beyond} beyond their bound, {wrong} wrong")
