"""Rank the interpretations, choose the default by the rule, and gather its ensemble."""

import json

from chenhorng.calibration.calibration import Interpretation, read_rows
from chenhorng.calibration.choice import Candidate, rank_interpretations
from chenhorng.calibration.results import fold_members
from chenhorng.claims.claims import load_claims
from chenhorng.claims.judge import Judge
from chenhorng.job_log import job
from thirdbody.files import read_yaml

with job(snakemake) as output:
    settings = snakemake.params.settings
    claims = load_claims(snakemake.params.claims)
    judge = Judge(claims, snakemake.params.parameters, settings["newtons"])
    contents = [read_yaml(path) for path in snakemake.input.calibrated]
    candidates = [Candidate.of(judge, content) for content in contents]
    table = rank_interpretations(judge, candidates, settings)
    print(table.to_string(index=False))
    members = fold_members(
        Interpretation.of(settings["ensemble"]["of"], settings),
        [read_rows(path) for path in snakemake.input.samples],
        settings["folds"],
        settings["ensemble"]["of_each_fold"],
    )
    chosen = {"interpretation": table.loc[0, "interpretation"], "members": members}
    output.chosen.write_text(json.dumps(chosen, indent=1) + "\n", encoding="utf-8")
    table.to_csv(output.ranking, index=False, float_format="%.6g")
