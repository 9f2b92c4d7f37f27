"""The printed numbers of the paper, with their tolerances, as a table."""

from thirdbody.data.files import atomic_write
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged
from thirdbody.study.claims import load_claims, printed_rows

with logged(snakemake.log[0]), atomic_write(snakemake.output.table) as part:
    write_csv(part, printed_rows(load_claims(snakemake.params.claims)), TABLES["printed"])
