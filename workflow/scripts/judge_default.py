"""The verdict on each statement with the inputs of the run alone."""

from chenhorng.claims.claims import load_claims
from chenhorng.claims.judge import Judge, outcome
from chenhorng.job_log import job
from chenhorng.tables import TABLES, write_csv

with job(snakemake) as output:
    claims = load_claims(snakemake.params.claims)
    judge = Judge(claims, snakemake.params.parameters, snakemake.params.newtons)
    verdicts = judge({})
    rows = [
        {"id": claim.id, "place": claim.place, "verdict": outcome(claim, verdicts[claim.id])}
        for claim in claims
    ]
    write_csv(output.table, rows, TABLES["verdicts"])
