"""Solve the points of a dataset for each member of the ensemble: the band around its curves."""

from thirdbody.data.files import atomic_write
from thirdbody.data.netcdf import read_plain, write_dataset
from thirdbody.job_log import logged
from thirdbody.model.parameters import Parameters
from thirdbody.study.band import band


def solve(dataset, inputs, ensemble, envelope):
    """Write the ``envelope`` of the ``ensemble`` around the curves of ``dataset``."""
    solved = band(read_plain(dataset), inputs, ensemble)
    with atomic_write(envelope) as part:
        write_dataset(solved, part)
    print(f"{dataset}: {len(ensemble)} members")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        solve(
            snakemake.input.dataset,
            Parameters(**snakemake.params.parameters),
            snakemake.params.ensemble,
            snakemake.output.band,
        )
