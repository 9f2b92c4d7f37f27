"""The measured errors and times as one dataset."""

from thirdbody.accuracy.archive import accuracy_dataset
from thirdbody.files import logged, whole
from thirdbody.tables import TABLES, read_csv


def gather(errors, times, dataset):
    """Write both tables as arrays."""
    gathered = accuracy_dataset(
        read_csv(errors, TABLES["errors"]), read_csv(times, TABLES["times"])
    )
    with whole(dataset) as part:
        gathered.to_netcdf(part, engine="netcdf4", format="NETCDF4")
    print(f"{len(gathered.data_vars)} variables over {dict(gathered.sizes)}")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        gather(snakemake.input.errors, snakemake.input.times, snakemake.output.dataset)
