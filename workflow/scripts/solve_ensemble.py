"""Solve the points of a dataset for each member of the ensemble, for the band around its curves."""

from thirdbody.core.parameters import Parameters
from thirdbody.data.files import atomic_write
from thirdbody.data.netcdf import read_plain, write_dataset
from thirdbody.job_log import logged
from thirdbody.study.band import band

with logged(snakemake.log[0]):
    dataset = snakemake.input.dataset
    ensemble = snakemake.params.ensemble
    solved = band(read_plain(dataset), Parameters(**snakemake.params.parameters), ensemble)
    with atomic_write(snakemake.output.band) as part:
        write_dataset(solved, part)
    print(f"{dataset}: {len(ensemble)} members")
