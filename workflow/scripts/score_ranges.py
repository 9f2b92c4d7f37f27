"""At how many random conditions other sets of inputs lie within the range of the ensemble."""

import pandas as pd

from chenhorng.coverage import random_conditions, sets_and_ranges
from chenhorng.job_log import job
from chenhorng.tables import TABLES, write_csv
from thirdbody.core.parameters import Parameters
from thirdbody.files import read_yaml
from thirdbody.inputs import ensemble_of

with job(snakemake) as output:
    calibrated = read_yaml(snakemake.params.default)
    profiles = pd.read_csv(snakemake.input.profiles)
    radius = profiles[profiles["along"].eq("mean_ratio") & profiles["level"].eq(0.5)]
    best = radius.loc[radius["objective"].idxmin()].dropna()
    known = calibrated["inputs"]
    sets = {
        "the default": known,
        **{
            f"without Figures {', '.join(map(str, fold['figures']))}": fold["inputs"]
            for fold in calibrated["folds"]
        },
        "the best with a mean of x_a/2": best[[name for name in best.index if name in known]],
    }
    rows = sets_and_ranges(
        ensemble_of(calibrated),
        {name: Parameters(**known | dict(inputs)) for name, inputs in sets.items()},
        random_conditions(snakemake.params.conditions),
    )
    write_csv(output.coverage, rows, TABLES["coverage_of_sets"])
