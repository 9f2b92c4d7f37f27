"""Count the statements of each part of the paper by their verdict."""

from chenhorng.claims.claims import load_claims
from chenhorng.claims.judge import Judge, counts_by_part
from chenhorng.job_log import job
from chenhorng.tables import TABLES, write_csv

with job(snakemake) as output:
    claims = load_claims(snakemake.params.claims)
    judge = Judge(claims, snakemake.params.parameters, snakemake.params.newtons)
    write_csv(output.table, counts_by_part(claims, judge({})), TABLES["counts"])
