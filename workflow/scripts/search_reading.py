"""Search the unprinted inputs of one reading from one seed."""

import numpy as np

from thirdbody.data.files import logged, whole
from thirdbody.model.parameters import Parameters
from thirdbody.study.calibration import Objective, Reading, search
from thirdbody.study.claims import load_claims


def run(reading, seed, claims, settings, parameters, evaluations):
    """Write every evaluation of the search of ``reading`` that starts from ``seed``."""
    objective = Objective.of(load_claims(claims), settings, Parameters(**parameters))
    rows = search(Reading.of(reading, settings), objective, settings["budget"], seed)
    with whole(evaluations) as part:
        np.savetxt(part, rows, fmt="%.10g", delimiter=",")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        run(
            snakemake.wildcards.reading,
            int(snakemake.wildcards.seed),
            snakemake.input.claims,
            snakemake.params.settings,
            snakemake.params.parameters,
            snakemake.output.evaluations,
        )
