"""Search the unprinted inputs of one reading from one seed, and sample those that explain as much."""

import numpy as np

from thirdbody.data.files import logged, whole
from thirdbody.model.parameters import Parameters
from thirdbody.study.calibration import Objective, Reading, search
from thirdbody.study.claims import load_claims
from thirdbody.study.sampling import posterior_sample


def run(name, seed, claims, settings, parameters, evaluations, samples):
    """Write every evaluation of the search of the reading ``name`` from ``seed``, and its samples."""
    objective = Objective.of(load_claims(claims), settings, Parameters(**parameters))
    reading, budget = Reading.of(name, settings), settings["budget"]
    rows = search(reading, objective, budget, seed)
    drawn = posterior_sample(reading, objective, rows, budget, seed)
    with whole(evaluations, samples) as parts:
        for part, each in zip(parts, (rows, drawn), strict=True):
            np.savetxt(part, each, fmt="%.10g", delimiter=",")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        run(
            snakemake.wildcards.reading,
            int(snakemake.wildcards.seed),
            snakemake.input.claims,
            snakemake.params.settings,
            snakemake.params.parameters,
            snakemake.output.evaluations,
            snakemake.output.samples,
        )
