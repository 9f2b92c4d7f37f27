"""The calibrated inputs of one interpretation from its searches."""

import yaml

from thirdbody.data.files import atomic_write
from thirdbody.job_log import logged
from thirdbody.model.parameters import Parameters
from thirdbody.study.calibration import Interpretation
from thirdbody.study.checks import Judge
from thirdbody.study.claims import load_claims
from thirdbody.study.record import read_rows
from thirdbody.study.results import summary


def summarise(name, evaluations, samples, folds, claims, settings, parameters, calibrated):
    """Write the chosen inputs, their ensemble, those of the folds, and what is identified."""
    content = summary(
        Interpretation.of(name, settings),
        Judge(load_claims(claims), Parameters(**parameters), settings["newtons"]),
        [read_rows(path) for path in evaluations],
        [read_rows(path) for path in samples],
        [read_rows(path) for path in folds],
        settings,
    )
    with atomic_write(calibrated) as part, open(part, "w", encoding="utf-8") as stream:
        yaml.safe_dump(content, stream, sort_keys=False, width=100, default_flow_style=None)


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        summarise(
            snakemake.wildcards.interpretation,
            snakemake.input.evaluations,
            snakemake.input.samples,
            snakemake.input.folds,
            snakemake.input.claims,
            snakemake.params.settings,
            snakemake.params.parameters,
            snakemake.output.calibrated,
        )
