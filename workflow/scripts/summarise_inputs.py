"""The calibrated inputs of one interpretation from its searches."""

import yaml

from chenhorng.calibration.calibration import Interpretation, read_rows
from chenhorng.calibration.results import summary
from chenhorng.claims.claims import load_claims
from chenhorng.job_log import job

with job(snakemake) as output:
    settings = snakemake.params.settings
    content = summary(
        Interpretation.of(snakemake.wildcards.interpretation, settings),
        [read_rows(path) for path in snakemake.input.evaluations],
        [read_rows(path) for path in snakemake.input.folds],
        load_claims(snakemake.params.claims),
        settings,
    )
    with open(output.calibrated, "w", encoding="utf-8") as stream:
        yaml.safe_dump(content, stream, sort_keys=False, width=100, default_flow_style=None)
