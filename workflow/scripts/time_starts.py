"""What a person waits for: time from the start of a process to its answer, by each way of solving."""

from benchmarks.starts import start_rows
from thirdbody.data.files import whole
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged


def measure(settings, table):
    """Write the times that ``settings`` ask for to ``table``."""
    rows = start_rows(settings)
    with whole(table) as part:
        write_csv(part, rows, TABLES["starts"])
    print(f"{len(rows)} starts timed")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        measure(snakemake.params.settings, snakemake.output.table)
