"""Rank the interpretations and choose the default by the rule, with the ensemble of its equals."""

import json

from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.data.files import atomic_write
from thirdbody.job_log import logged
from thirdbody.study.choice import choose_default
from thirdbody.study.claims import load_claims
from thirdbody.study.judge import Judge

with logged(snakemake.log[0]):
    settings = snakemake.params.settings
    claims = load_claims(snakemake.params.claims)
    judge = Judge(claims, snakemake.params.parameters, settings["newtons"])
    contents = [read_yaml(path) for path in snakemake.input.calibrated]
    chosen, table = choose_default(judge, contents, settings)
    print(table.to_string(index=False))
    with atomic_write(snakemake.output.chosen, snakemake.output.ranking) as (as_json, as_csv):
        as_json.write_text(json.dumps(chosen, indent=1) + "\n", encoding="utf-8")
        table.to_csv(as_csv, index=False, float_format="%.6g")
