"""Turning points and transitions of the curves of one dataset."""

from thirdbody.data.extraction import tpca_rows, transition_rows
from thirdbody.data.files import logged, whole
from thirdbody.data.netcdf import read_dataset
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.model.parameters import Parameters


def extract(figure, dataset, parameters, tpca_loads, transitions):
    """Write the turning points and the transitions of the curves in ``dataset``."""
    curves = read_dataset(dataset)
    inputs = Parameters(**parameters)
    with whole(tpca_loads, transitions) as (tpca_part, transitions_part):
        write_csv(tpca_part, tpca_rows(figure, curves, inputs), TABLES["tpca_loads"])
        write_csv(transitions_part, transition_rows(figure, curves, inputs), TABLES["transitions"])


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        extract(
            snakemake.wildcards.figure,
            snakemake.input.dataset,
            snakemake.params.parameters,
            snakemake.output.tpca_loads,
            snakemake.output.transitions,
        )
