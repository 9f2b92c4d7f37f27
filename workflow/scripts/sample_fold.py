"""Sample the inputs that explain about as much as the best ones, without the statements of a
fold.
"""

from chenhorng.calibration.calibration import Interpretation, Objective, read_rows, write_rows
from chenhorng.calibration.search import posterior_sample
from chenhorng.claims.claims import load_claims
from chenhorng.job_log import job

with job(snakemake) as output:
    settings, fold = snakemake.params.settings, int(snakemake.wildcards.fold)
    statements = load_claims(snakemake.params.claims)
    objective = Objective.without(fold, statements, settings, snakemake.params.parameters)
    interpretation = Interpretation.of(snakemake.wildcards.interpretation, settings)
    found = read_rows(snakemake.input.evaluations)
    drawn = posterior_sample(interpretation, objective, found, settings["budget"], fold)
    write_rows(output.samples, drawn)
