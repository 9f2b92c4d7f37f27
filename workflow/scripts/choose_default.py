"""Rank the interpretations and choose the default by the rule, with the ensemble of its equals."""

import json

from chenhorng.calibration.choice import choose_default
from chenhorng.claims.claims import load_claims
from chenhorng.claims.judge import Judge
from chenhorng.job_log import job
from thirdbody.files import read_yaml

with job(snakemake) as output:
    settings = snakemake.params.settings
    claims = load_claims(snakemake.params.claims)
    judge = Judge(claims, snakemake.params.parameters, settings["newtons"])
    contents = [read_yaml(path) for path in snakemake.input.calibrated]
    chosen, table = choose_default(judge, contents, settings)
    print(table.to_string(index=False))
    output.chosen.write_text(json.dumps(chosen, indent=1) + "\n", encoding="utf-8")
    table.to_csv(output.ranking, index=False, float_format="%.6g")
