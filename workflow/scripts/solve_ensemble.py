"""Solve a dataset for each member of the ensemble, and write the range of each quantity."""

from chenhorng.ensemble_range import ensemble_range
from chenhorng.job_log import job
from thirdbody.core.parameters import Parameters
from thirdbody.netcdf import read_plain, write_dataset

with job(snakemake) as output:
    dataset = snakemake.input.dataset
    ensemble = snakemake.params.ensemble
    inputs = Parameters(**snakemake.params.parameters)
    ranges = ensemble_range(read_plain(dataset), inputs, ensemble)
    write_dataset(ranges, output.ensemble_range)
    print(f"{dataset}: {len(ensemble)} members")
