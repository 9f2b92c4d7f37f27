"""Search the unprinted inputs of one interpretation, over all statements or without those of a fold."""

import numpy as np

from thirdbody.job_log import logged
from thirdbody.study.calibration import Interpretation, Objective, make_folds, read_rows, write_rows
from thirdbody.study.claims import load_claims
from thirdbody.study.search import search


def _with_objective(interpretation, objective, every, rows):
    """Scattered positions, with the ``objective`` instead of the scores of ``every`` statement."""
    count = len(interpretation.unknowns)
    ids = {claim.id for claim in objective.claims}
    fitted = [place for place, claim in enumerate(every.claims) if claim.id in ids]
    values = [
        objective.value(
            interpretation.penalty(interpretation.values(row[:count])), row[count:][fitted]
        )
        for row in rows
    ]
    return np.column_stack([rows[:, :count], values])


with logged(snakemake.log[0]):
    fold = snakemake.params.fold
    settings = snakemake.params.settings
    statements = load_claims(snakemake.input.claims)
    base = snakemake.params.parameters
    # a number is the fold whose statements are left out
    fitted = statements if fold is None else make_folds(statements, settings["folds"])[fold].fitted
    objective = Objective.of(fitted, settings, base)
    interpretation = Interpretation.of(snakemake.wildcards.interpretation, settings)
    every = Objective.of(statements, settings, base)
    places = _with_objective(interpretation, objective, every, read_rows(snakemake.input.scattered))
    ranking = np.argsort(places[:, -1], kind="stable")
    found = [places]
    # the first seed starts at the best of the scattered inputs, the second at the second best
    for seed in snakemake.params.seeds:
        start = places[ranking[seed - 1], :-1]
        found.append(search(interpretation, objective, start, settings["budget"], seed))
    write_rows(snakemake.output.evaluations, np.vstack(found))
