"""Search the unprinted inputs of one interpretation, over all statements or without those of a
fold.
"""

import numpy as np

from chenhorng.calibration.calibration import Interpretation, Objective, read_rows, write_rows
from chenhorng.calibration.search import find_inputs, nearby_starts, scattered_starts
from chenhorng.claims.claims import load_claims
from chenhorng.job_log import job

with job(snakemake) as output:
    fold, settings = snakemake.params.fold, snakemake.params.settings
    seeds, budget = snakemake.params.seeds, settings["budget"]
    statements = load_claims(snakemake.params.claims)
    base = snakemake.params.parameters
    objective = Objective.without(fold, statements, settings, base)
    interpretation = Interpretation.of(snakemake.wildcards.interpretation, settings)
    rows = np.vstack([read_rows(path) for path in snakemake.input.start])
    entry = settings["interpretations"][interpretation.name]
    if nearby := entry.get("nearby"):
        starts = nearby_starts(interpretation, Interpretation.of(nearby, settings), rows)
        evaluations = entry.get("evaluations", budget["nearby_evaluations"])
        budget = budget | {"evaluations": evaluations}
        hops = 0
    else:
        every = Objective.of(statements, settings, base)
        starts = scattered_starts(objective, every, rows, settings, seeds)
        hops = budget["hops"]
    found = find_inputs(interpretation, objective, starts, budget, hops, seeds[0])
    write_rows(output.evaluations, found)
