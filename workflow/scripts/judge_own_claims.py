"""The verdict on statements of one's own, as a table."""

from thirdbody.paper.claims.claims import load_claims
from thirdbody.paper.claims.judge import Judge, outcome
from thirdbody.paper.configuration.schema import read_schema, validate
from thirdbody.paper.job_log import job
from thirdbody.paper.tables import TABLES, write_csv
from thirdbody.plain_yaml import read_yaml

with job(snakemake) as output:
    path = snakemake.params.claims
    validate(read_yaml(path, list), read_schema("claims"), path)
    claims = load_claims(path)
    judge = Judge(claims, snakemake.params.parameters, snakemake.params.newtons)
    rows = []
    for claim, verdict in zip(claims, judge({}).values(), strict=True):
        others = {
            "curves": claim.curves_text,
            "published": claim.published_text,
            "score": verdict.score,
            "value": verdict.value,
            "verdict": outcome(claim, verdict),
            "contradicts": " ".join(claim.contradicts),
        }
        rows.append(vars(claim) | verdict._asdict() | others)
    columns = [column for column in TABLES["claims"] if column.name in rows[0]]
    write_csv(output.table, rows, columns)
