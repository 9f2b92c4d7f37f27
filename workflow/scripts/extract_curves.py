"""Find the turning points and transitions on the curves of a dataset."""

from chenhorng.extraction import tpca_rows, transition_rows
from chenhorng.job_log import job
from chenhorng.tables import TABLES, write_csv
from thirdbody.core.parameters import Parameters
from thirdbody.netcdf import read_plain

with job(snakemake) as output:
    figure = snakemake.wildcards.scene
    inputs = Parameters(**snakemake.params.parameters)
    curves = read_plain(snakemake.input.dataset)
    turning = tpca_rows(figure, curves, inputs)
    crossings = transition_rows(figure, curves, inputs)
    write_csv(output.tpca_loads, turning, TABLES["tpca_loads"])
    write_csv(output.transitions, crossings, TABLES["transitions"])
    print(f"{figure}: {len(turning)} turning points, {len(crossings)} transitions")
