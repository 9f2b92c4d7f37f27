"""Sample the inputs that explain about as much as the best ones, without the statements of a
fold.
"""

from chenhorng.calibration.calibration import Interpretation, Objective, read_rows, write_rows
from chenhorng.calibration.profile import along_the_means
from chenhorng.calibration.search import best_of, posterior_sample
from chenhorng.claims.claims import load_claims
from chenhorng.job_log import job

with job(snakemake) as output:
    settings, fold = snakemake.params.settings, int(snakemake.wildcards.fold)
    statements = load_claims(snakemake.params.claims)
    objective = Objective.without(fold, statements, settings, snakemake.params.parameters)
    interpretation = Interpretation.of(snakemake.wildcards.interpretation, settings)
    best = interpretation.values(best_of(read_rows(snakemake.input.evaluations))[:-1])
    budget = settings["budget"]
    starts = along_the_means(interpretation, best, budget["walkers"])
    drawn = posterior_sample(interpretation, objective, starts, budget["steps"], fold)
    write_rows(output.samples, drawn)
