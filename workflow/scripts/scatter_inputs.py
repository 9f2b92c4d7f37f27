"""Evaluate scattered inputs of an interpretation.  Its searches start from the best of them."""

import numpy as np

from chenhorng.calibration.calibration import Interpretation, Objective, write_rows
from chenhorng.calibration.search import scatter
from chenhorng.claims.claims import load_claims
from chenhorng.job_log import job

with job(snakemake) as output:
    settings = snakemake.params.settings
    objective = Objective.of(
        load_claims(snakemake.params.claims), settings, snakemake.params.parameters
    )
    interpretation = Interpretation.of(snakemake.wildcards.interpretation, settings)
    positions = scatter(interpretation, settings["budget"])
    scores = [objective.scores(interpretation, interpretation.values(row)) for row in positions]
    write_rows(output.scattered, np.column_stack([positions, scores]))
