"""The numbers that the paper prints, with their tolerances, as a table."""

from thirdbody.data.files import atomic_write
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged
from thirdbody.study.claims import load_claims
from thirdbody.study.printed import printed_rows


def gather(claims, table):
    """Write a row for each number and curve of the statements in ``claims``."""
    with atomic_write(table) as part:
        write_csv(part, printed_rows(load_claims(claims)), TABLES["printed"])


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        gather(snakemake.input.claims, snakemake.output.table)
