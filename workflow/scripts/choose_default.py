"""Choose the default by the rule, and search for the cost of each headline number that it misses."""

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
    columns = ["interpretation", "predicted", "fitted", "penalty", "inputs"]
    print(table[columns].to_string(index=False))
    with atomic_write(snakemake.output.chosen) as part:
        part.write_text(json.dumps(chosen, indent=1) + "\n", encoding="utf-8")
