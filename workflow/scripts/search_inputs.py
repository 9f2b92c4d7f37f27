"""Search the unprinted inputs of one interpretation, over all statements or without those of a fold."""

from pathlib import Path

from thirdbody.job_log import logged
from thirdbody.model.parameters import Parameters
from thirdbody.study.calibration import Interpretation, Objective, make_folds
from thirdbody.study.claims import load_claims
from thirdbody.study.record import write_rows
from thirdbody.study.search import search


def run(name, seed, fold, claims, settings, parameters, evaluations):
    """Write all evaluations of the search; a number ``fold`` says whose statements are left out."""
    statements = load_claims(claims)
    if fold is not None:
        statements = make_folds(statements, settings["folds"])[fold].fitted
    objective = Objective.of(statements, settings, Parameters(**parameters))
    record = Path(evaluations).with_suffix(".record")
    rows = search(Interpretation.of(name, settings), objective, settings["budget"], seed, record)
    write_rows(evaluations, rows)
    record.unlink()


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        run(
            snakemake.wildcards.reading,
            snakemake.params.seed,
            snakemake.params.fold,
            snakemake.input.claims,
            snakemake.params.settings,
            snakemake.params.parameters,
            snakemake.output.evaluations,
        )
