"""The envelope of the calibrated ensemble around the curves of one dataset."""

from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.data.files import logged, whole
from thirdbody.data.netcdf import read_dataset, write_dataset
from thirdbody.model.parameters import Parameters
from thirdbody.study.band import band


def compute(dataset, calibrated, parameters, place):
    """Write the band around ``dataset``; the ensemble is that of the file ``calibrated``.

    Inputs without an ensemble leave the band as wide as the curves.
    """
    ensemble = read_yaml(calibrated).get("ensemble", [])
    envelope = band(read_dataset(dataset), Parameters(**parameters), ensemble)
    with whole(place) as part:
        write_dataset(envelope, part)
    print(f"{place}: {len(ensemble)} members of {calibrated}")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        compute(
            snakemake.input.dataset,
            snakemake.input.calibrated,
            snakemake.params.parameters,
            snakemake.output.band,
        )
