"""Solve the conditions of the atlas at a roughness, and write them to a file."""

from chenhorng.job_log import job
from thirdbody.core.parameters import Parameters
from thirdbody.grids import stream

with job(snakemake) as output:
    parameters = Parameters(**snakemake.params.parameters)
    stream(output.chunk, **snakemake.params.asked, parameters=parameters, compression=1)
