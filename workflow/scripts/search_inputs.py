"""Search the unprinted inputs of one interpretation, over all statements or without those of a fold."""

import numpy as np

from thirdbody.job_log import logged
from thirdbody.model.parameters import Parameters
from thirdbody.study.calibration import Interpretation, Objective, make_folds
from thirdbody.study.claims import load_claims
from thirdbody.study.record import read_rows, write_rows
from thirdbody.study.search import search


def run(name, seeds, fold, claims, scattered, settings, parameters, evaluations):
    """Write all evaluations of the search; a number ``fold`` says whose statements are left out.

    The first of ``seeds`` starts from the best of the scattered inputs, the second from the second best.
    """
    statements, base = load_claims(claims), Parameters(**parameters)
    fitted = statements if fold is None else make_folds(statements, settings["folds"])[fold].fitted
    objective = Objective.of(fitted, settings, base)
    interpretation = Interpretation.of(name, settings)
    every = Objective.of(statements, settings, base)
    places = _with_objective(interpretation, objective, every, read_rows(scattered))
    ranking = np.argsort(places[:, -1], kind="stable")
    found = [places]
    for seed in seeds:
        start = places[ranking[seed - 1], :-1]
        found.append(search(interpretation, objective, start, settings["budget"], seed))
    write_rows(evaluations, np.vstack(found))


def _with_objective(interpretation, objective, every, rows):
    """Scattered positions, with the ``objective`` in place of the scores of ``every`` statement."""
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


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        run(
            snakemake.wildcards.interpretation,
            snakemake.params.seeds,
            snakemake.params.fold,
            snakemake.input.claims,
            snakemake.input.scattered,
            snakemake.params.settings,
            snakemake.params.parameters,
            snakemake.output.evaluations,
        )
