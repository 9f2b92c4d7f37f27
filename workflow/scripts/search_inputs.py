"""Search the unprinted inputs of one interpretation, over all statements or without those of a fold."""

import numpy as np

from thirdbody.job_log import logged
from thirdbody.study.calibration import Interpretation, Objective, make_folds, read_rows, write_rows
from thirdbody.study.claims import load_claims
from thirdbody.study.search import best_of, find_inputs, rank_starts

with logged(snakemake.log[0]):
    fold, settings = snakemake.params.fold, snakemake.params.settings
    statements = load_claims(snakemake.params.claims)
    base = snakemake.params.parameters
    # a number is the fold whose statements are left out
    fitted = statements if fold is None else make_folds(statements, settings["folds"])[fold].fitted
    objective = Objective.of(fitted, settings, base)
    interpretation = Interpretation.of(snakemake.wildcards.interpretation, settings)
    rows = np.vstack([read_rows(path) for path in snakemake.input.start])
    if nearby := settings["interpretations"][interpretation.name].get("nearby"):
        other = Interpretation.of(nearby, settings)
        hops = settings["budget"]["nearby_hops"]
        known = other.fixed | other.values(best_of(rows)[:-1])
        starts = interpretation.positions(known)[None]
    else:
        hops = settings["budget"]["hops"]
        count = len(interpretation.unknowns)
        places, scores = rows[:, :count], rows[:, count:]
        every = Objective.of(statements, settings, base)
        ranking = rank_starts(objective, objective.take(every, scores))
        # every seed has starts of its own
        seeds, most = settings["seeds"], settings["budget"]["starts"]
        ranks = [ranking[seeds.index(seed) :: len(seeds)][:most] for seed in snakemake.params.seeds]
        starts = places[np.concatenate(ranks)]
    found = find_inputs(
        interpretation, objective, starts, settings["budget"], hops, snakemake.params.seeds[0]
    )
    write_rows(snakemake.output.evaluations, found)
