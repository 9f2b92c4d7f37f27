"""Solve the points of a dataset for each member of the ensemble, for the band around its curves."""

from thirdbody.core.parameters import Parameters
from thirdbody.netcdf import read_plain, write_dataset
from chenhorng.bands import band
from chenhorng.job_log import job
from thirdbody.version import Version

with job(snakemake) as output:
    dataset = snakemake.input.dataset
    ensemble = snakemake.params.ensemble
    inputs, version = Parameters(**snakemake.params.parameters), Version(*snakemake.params.version)
    solved = band(read_plain(dataset), inputs, ensemble, version)
    write_dataset(solved, output.band)
    print(f"{dataset}: {len(ensemble)} members")
