"""The printed numbers of the paper, with their tolerances, as a table."""

from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import job
from thirdbody.study.claims import load_claims, printed_rows

with job(snakemake) as output:
    rows = printed_rows(load_claims(snakemake.params.claims))
    write_csv(output.table, rows, TABLES["printed"])
