"""The envelope of the calibrated ensemble around the curves of one dataset."""

from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.data.files import logged, whole
from thirdbody.data.netcdf import read_dataset, write_dataset
from thirdbody.model.parameters import Parameters
from thirdbody.study.band import band


def compute(dataset, calibrated, parameters, laid_over, place):
    """Write the band around ``dataset``: the ensemble is that of the file ``calibrated``, and each
    member has the inputs ``laid_over`` it."""
    ensemble = [member | laid_over for member in read_yaml(calibrated)["ensemble"]]
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
            snakemake.params.laid_over,
            snakemake.output.band,
        )
