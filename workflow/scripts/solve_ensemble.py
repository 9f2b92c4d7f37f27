"""Solve the points of a dataset for each member of the ensemble, for the band around its curves."""

from chenhorng.bands import band
from chenhorng.job_log import job
from thirdbody.core.parameters import Parameters
from thirdbody.netcdf import read_plain, write_dataset

with job(snakemake) as output:
    dataset = snakemake.input.dataset
    ensemble = snakemake.params.ensemble
    inputs = Parameters(**snakemake.params.parameters)
    solved = band(read_plain(dataset), inputs, ensemble)
    write_dataset(solved, output.band)
    print(f"{dataset}: {len(ensemble)} members")
