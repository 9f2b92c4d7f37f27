"""The profile of the objective of one interpretation along one quantity."""

import pandas as pd

from chenhorng.calibration.calibration import Interpretation, Objective, read_rows
from chenhorng.calibration.profile import profile
from chenhorng.calibration.search import best_of
from chenhorng.claims.claims import load_claims
from chenhorng.job_log import job

with job(snakemake) as output:
    settings, along = snakemake.params.settings, snakemake.wildcards.along
    claims = load_claims(snakemake.params.claims)
    objective = Objective.of(claims, settings, snakemake.params.parameters)
    interpretation = Interpretation.of(snakemake.wildcards.interpretation, settings)
    best = interpretation.values(best_of(read_rows(snakemake.input.evaluations))[:-1])
    rows = profile(interpretation, objective, best, along, snakemake.params.levels)
    table = pd.DataFrame(rows)
    table.insert(0, "along", along)
    table.insert(0, "interpretation", interpretation.name)
    table.to_csv(output.profile, index=False, float_format="%.6g")
