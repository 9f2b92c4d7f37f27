"""The calibrated inputs of one reading from its searches."""

import json
from pathlib import Path

import numpy as np
import yaml

from thirdbody.data.files import logged, whole
from thirdbody.study.calibration import Reading
from thirdbody.study.posterior import summary

HEADER = (
    "# Calibrated inputs of one reading, made by `snakemake -c2 calibrate`; not edited by hand.\n"
)


def summarise(reading, evaluations, samples, fronts, settings, calibrated):
    """Write the best inputs of ``reading``, their ensemble and what it identifies."""
    searches, drawn = (
        [np.loadtxt(path, delimiter=",", ndmin=2) for path in paths]
        for paths in (evaluations, samples)
    )
    seen = [json.loads(Path(path).read_text(encoding="utf-8")) for path in fronts]
    content = summary(Reading.of(reading, settings), searches, drawn, seen, settings)
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
            snakemake.params.settings,
            snakemake.output.calibrated,
        )
