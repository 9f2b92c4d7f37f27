"""Compare the library with the oracle in extended precision, for all interpretations."""

from benchmarks.oracle import oracle_rows
from thirdbody.data.files import atomic_write
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged

with logged(snakemake.log[0]):
    rows = oracle_rows(snakemake.params.settings, snakemake.threads)
    with atomic_write(snakemake.output.table) as part:
        write_csv(part, rows, TABLES["oracle"])
    points, beyond, wrong = (
        sum(row[name] for row in rows) for name in ("points", "beyond_bound", "wrong")
    )
    print(f"{points} points: {beyond} beyond their bound, {wrong} wrong")
