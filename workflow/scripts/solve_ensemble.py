"""Solve the points of a dataset for each member of the ensemble, for the band around its curves."""

from thirdbody.core.parameters import Parameters
from thirdbody.netcdf import read_plain, write_dataset
from thirdbody.paper.bands import band
from thirdbody.paper.job_log import job

with job(snakemake) as output:
    dataset = snakemake.input.dataset
    ensemble = snakemake.params.ensemble
    solved = band(read_plain(dataset), Parameters(**snakemake.params.parameters), ensemble)
    write_dataset(solved, output.band)
    print(f"{dataset}: {len(ensemble)} members")
