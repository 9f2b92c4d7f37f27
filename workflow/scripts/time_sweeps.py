"""Times of the heaviest class: with something left out, in any number, and in several processes."""

from benchmarks.omissions import omission_rows
from benchmarks.scaling import scaling_rows
from thirdbody.data.files import logged, whole
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.model.parameters import Parameters


def measure(budget, parameters, omissions, scaling):
    """Write the times that ``budget`` asks for as the tables of these names."""
    inputs = Parameters(**parameters)
    with whole(omissions, scaling) as (omissions_part, scaling_part):
        write_csv(omissions_part, omission_rows(inputs, budget), TABLES["omissions"])
        write_csv(scaling_part, scaling_rows(inputs, budget), TABLES["scaling"])
    print("two tables written")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        measure(
            snakemake.params.budget,
            snakemake.params.parameters,
            snakemake.output.omissions,
            snakemake.output.scaling,
        )
