"""The calibrated inputs of one reading from its searches."""

import json
from functools import partial
from pathlib import Path

import numpy as np
import yaml

from thirdbody.data.files import whole
from thirdbody.job_log import logged
from thirdbody.model.parameters import Parameters
from thirdbody.study.calibration import Reading
from thirdbody.study.choice import most_held
from thirdbody.study.claims import load_claims
from thirdbody.study.posterior import summary
from thirdbody.study.verdicts import Court

HEADER = (
    "# Calibrated inputs of one reading, made by `snakemake -c2 calibrate`; not edited by hand.\n"
)


def summarise(reading, evaluations, samples, fronts, claims, settings, parameters, calibrated):
    """Write the chosen inputs of ``reading``, their ensemble and what it identifies."""
    searches, drawn = (
        [np.loadtxt(path, delimiter=",", ndmin=2) for path in paths]
        for paths in (evaluations, samples)
    )
    seen = [json.loads(Path(path).read_text(encoding="utf-8")) for path in fronts]
    reading = Reading.of(reading, settings)
    court = Court(load_claims(claims), Parameters(**parameters), tuple(settings["newtons"]))
    choose = partial(most_held, reading, court=court)
    content = summary(reading, searches, drawn, seen, settings, choose)
    with whole(calibrated) as part, open(part, "w", encoding="utf-8") as stream:
        stream.write(HEADER)
        yaml.safe_dump(content, stream, sort_keys=False, width=100, default_flow_style=None)


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        summarise(
            snakemake.wildcards.reading,
            snakemake.input.evaluations,
            snakemake.input.samples,
            snakemake.input.fronts,
            snakemake.input.claims,
            snakemake.params.settings,
            snakemake.params.parameters,
            snakemake.output.calibrated,
        )
