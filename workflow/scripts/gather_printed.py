"""The printed numbers of the paper, with their tolerances, as a table."""

from thirdbody.paper.claims.claims import load_claims, printed_rows
from thirdbody.paper.job_log import job
from thirdbody.paper.tables import TABLES, write_csv

with job(snakemake) as output:
    rows = printed_rows(load_claims(snakemake.params.claims))
    write_csv(output.table, rows, TABLES["printed"])
