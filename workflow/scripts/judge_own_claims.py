"""The verdict on statements of one's own, as a table."""

from chenhorng.claims.claims import load_claims
from chenhorng.claims.judge import Judge, claim_columns
from chenhorng.configuration.schema import read_schema, validate
from chenhorng.job_log import job
from chenhorng.tables import TABLES, write_csv
from thirdbody.plain_yaml import read_yaml

with job(snakemake) as output:
    path = snakemake.params.claims
    validate(read_yaml(path, list), read_schema("claims"), path)
    claims = load_claims(path)
    judge = Judge(claims, snakemake.params.parameters, snakemake.params.newtons)
    verdicts = judge({}).values()
    rows = [claim_columns(*pair) for pair in zip(claims, verdicts, strict=True)]
    columns = [column for column in TABLES["claims"] if column.name in rows[0]]
    write_csv(output.table, rows, columns)
