"""Judge scattered inputs of one interpretation, from the best of which its searches start."""

import numpy as np

from thirdbody.job_log import logged
from thirdbody.model.parameters import Parameters
from thirdbody.study.calibration import Interpretation, Objective
from thirdbody.study.claims import load_claims
from thirdbody.study.record import write_rows
from thirdbody.study.search import scatter


def judge_scattered(name, claims, settings, parameters, scattered):
    """Write the positions, and after them the score of each statement."""
    objective = Objective.of(load_claims(claims), settings, Parameters(**parameters))
    interpretation = Interpretation.of(name, settings)
    places = scatter(interpretation, settings["budget"])
    scores = [objective.scores(interpretation, interpretation.values(place)) for place in places]
    write_rows(scattered, np.column_stack([places, scores]))


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        judge_scattered(
            snakemake.wildcards.interpretation,
            snakemake.input.claims,
            snakemake.params.settings,
            snakemake.params.parameters,
            snakemake.output.scattered,
        )
