"""The calibrated inputs of one interpretation from its searches."""

import yaml

from thirdbody.data.files import atomic_write
from thirdbody.job_log import logged
from thirdbody.study.calibration import Interpretation, read_rows
from thirdbody.study.results import summary

with logged(snakemake.log[0]):
    settings = snakemake.params.settings
    content = summary(
        Interpretation.of(snakemake.wildcards.interpretation, settings),
        [read_rows(path) for path in snakemake.input.evaluations],
        [read_rows(path) for path in snakemake.input.samples],
        [read_rows(path) for path in snakemake.input.folds],
        settings,
    )
    with (
        atomic_write(snakemake.output.calibrated) as part,
        open(part, "w", encoding="utf-8") as stream,
    ):
        yaml.safe_dump(content, stream, sort_keys=False, width=100, default_flow_style=None)
