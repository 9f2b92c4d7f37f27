"""Search the unprinted inputs of one reading from one seed."""

import json

import numpy as np

from thirdbody.data.files import whole
from thirdbody.job_log import logged
from thirdbody.model.parameters import Parameters
from thirdbody.study.calibration import Objective, Reading
from thirdbody.study.claims import load_claims
from thirdbody.study.fronts import Witness
from thirdbody.study.search import search


def run(name, seed, claims, settings, parameters, evaluations, fronts):
    """Write all evaluations of a search of the reading ``name``, and their fronts."""
    inputs = Parameters(**parameters)
    objective = Objective.of(load_claims(claims), settings, inputs, watched=True)
    witness = Witness(objective, settings["headline"])
    rows = search(Reading.of(name, settings), objective, settings["budget"], seed, see=witness.see)
    told = {statement: front.tolist() for statement, front in witness.fronts.items()}
    with whole(evaluations, fronts) as (part, seen):
        np.savetxt(part, rows, fmt="%.10g", delimiter=",")
        seen.write_text(json.dumps(told), encoding="utf-8")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        run(
            snakemake.wildcards.reading,
            int(snakemake.wildcards.seed),
            snakemake.input.claims,
            snakemake.params.settings,
            snakemake.params.parameters,
            snakemake.output.evaluations,
            snakemake.output.fronts,
        )
