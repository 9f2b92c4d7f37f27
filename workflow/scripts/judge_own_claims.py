"""Judge statements that are not those of the paper; write the verdicts as a table."""

from chenhorng.claims.claims import load_claims
from chenhorng.claims.judge import Judge, claim_columns
from chenhorng.job_log import job
from chenhorng.tables import TABLES, write_csv

with job(snakemake) as output:
    claims = load_claims(snakemake.params.claims)
    judge = Judge(claims, snakemake.params.parameters, snakemake.params.newtons)
    verdicts = judge({}).values()
    rows = [claim_columns(*pair) for pair in zip(claims, verdicts, strict=True)]
    write_csv(output.table, rows, TABLES["own_claims"])
