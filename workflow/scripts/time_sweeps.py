"""Times of the heaviest class: with something left out, in any number, on many surfaces, and in
several processes and threads."""

from benchmarks.omissions import omission_rows
from benchmarks.scaling import scaling_rows
from benchmarks.surfaces import surface_rows
from thirdbody.data.files import whole
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged
from thirdbody.model.parameters import Parameters


def measure(budget, parameters, omissions, scaling, surfaces):
    """Write the times that ``budget`` asks for as the tables of these names."""
    inputs = Parameters(**parameters)
    with whole(omissions, scaling, surfaces) as (omissions_part, scaling_part, surfaces_part):
        write_csv(omissions_part, omission_rows(inputs, budget), TABLES["omissions"])
        write_csv(scaling_part, scaling_rows(inputs, budget), TABLES["scaling"])
        write_csv(surfaces_part, surface_rows(inputs, budget), TABLES["surfaces"])
    print("three tables written")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        measure(
            snakemake.params.budget,
            snakemake.params.parameters,
            snakemake.output.omissions,
            snakemake.output.scaling,
            snakemake.output.surfaces,
        )
