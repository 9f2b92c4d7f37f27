"""Count the statements of each part of the paper by their verdict."""

from chenhorng.claims.claims import load_claims
from chenhorng.claims.judge import Judge, outcome
from chenhorng.claims.words import counts_by_part
from chenhorng.job_log import job
from chenhorng.tables import TABLES, write_csv

with job(snakemake) as output:
    claims = load_claims(snakemake.params.claims)
    judge = Judge(claims, snakemake.params.parameters, snakemake.params.newtons)
    verdicts = judge({})
    outcomes = [(claim.place, outcome(claim, verdicts[claim.id])) for claim in claims]
    write_csv(output.table, counts_by_part(outcomes), TABLES["counts"])
