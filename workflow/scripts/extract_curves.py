"""Turning points and transitions of the curves of one dataset."""

from thirdbody.core.parameters import Parameters
from thirdbody.data.extraction import tpca_rows, transition_rows
from thirdbody.data.files import atomic_write
from thirdbody.data.netcdf import read_plain
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged

with logged(snakemake.log[0]):
    figure = snakemake.wildcards.scene
    inputs = Parameters(**snakemake.params.parameters)
    curves = read_plain(snakemake.input.dataset)
    turning = tpca_rows(figure, curves, inputs)
    crossings = transition_rows(figure, curves, inputs)
    with atomic_write(snakemake.output.tpca_loads, snakemake.output.transitions) as parts:
        write_csv(parts[0], turning, TABLES["tpca_loads"])
        write_csv(parts[1], crossings, TABLES["transitions"])
    print(f"{figure}: {len(turning)} turning points, {len(crossings)} transitions")
