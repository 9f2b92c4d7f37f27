"""Evaluate scattered inputs of one interpretation; its searches start from the best."""

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
    places = scatter(interpretation, settings["budget"])
    scores = [objective.scores(interpretation, interpretation.values(place)) for place in places]
    write_rows(output.scattered, np.column_stack([places, scores]))
