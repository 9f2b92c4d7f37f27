"""Sample the inputs of an interpretation that explain about as much as its best inputs, from one
seed.
"""

import numpy as np

from chenhorng.calibration.calibration import Interpretation, Objective, read_rows, write_rows
from chenhorng.calibration.search import posterior_sample
from chenhorng.claims.claims import load_claims
from chenhorng.job_log import job

with job(snakemake) as output:
    settings, seed = snakemake.params.settings, int(snakemake.wildcards.seed)
    base = snakemake.params.parameters
    objective = Objective.of(load_claims(snakemake.params.claims), settings, base)
    found = np.vstack([read_rows(path) for path in snakemake.input.evaluations])
    interpretation = Interpretation.of(snakemake.wildcards.interpretation, settings)
    drawn = posterior_sample(interpretation, objective, found, settings["budget"], seed)
    write_rows(output.samples, drawn)
