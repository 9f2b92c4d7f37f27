"""Write the printed numbers of the paper, with their tolerances, as a table."""

from chenhorng.claims.claims import load_claims, printed_rows
from chenhorng.job_log import job
from chenhorng.tables import TABLES, write_csv

with job(snakemake) as output:
    rows = printed_rows(load_claims(snakemake.params.claims))
    write_csv(output.table, rows, TABLES["printed"])
