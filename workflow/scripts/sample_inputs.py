"""Sample the inputs that explain about as much as the best ones of one interpretation, from one seed."""

import numpy as np

from thirdbody.job_log import logged
from thirdbody.model.parameters import Parameters
from thirdbody.study.calibration import Interpretation, Objective
from thirdbody.study.claims import load_claims
from thirdbody.study.record import read_rows, write_rows
from thirdbody.study.sampling import posterior_sample


def sample(name, seed, evaluations, claims, settings, parameters, samples):
    """Write sets of inputs drawn from what the searches have found."""
    objective = Objective.of(load_claims(claims), settings, Parameters(**parameters))
    found = np.vstack([read_rows(path) for path in evaluations])
    interpretation = Interpretation.of(name, settings)
    write_rows(
        samples, posterior_sample(interpretation, objective, found, settings["budget"], seed)
    )


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        sample(
            snakemake.wildcards.interpretation,
            int(snakemake.wildcards.seed),
            snakemake.input.evaluations,
            snakemake.input.claims,
            snakemake.params.settings,
            snakemake.params.parameters,
            snakemake.output.samples,
        )
