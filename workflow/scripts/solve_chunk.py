"""Solve some surfaces of the atlas, for the default inputs and each member of the ensemble."""

import numpy as np

from thirdbody.core.parameters import Parameters
from chenhorng.atlas.chunk import atlas_axes, write_chunk
from chenhorng.job_log import job

with job(snakemake) as output:
    settings = snakemake.params
    number, chunks = map(int, snakemake.wildcards.scatteritem.split("-of-"))
    axes = atlas_axes(settings.axes)
    axes["roughness"] = np.array_split(axes["roughness"], chunks)[number - 1]
    default = Parameters(**settings.parameters)
    asked = settings.ensemble, settings.variables, settings.rtol
    write_chunk(output.chunk, axes, default, *asked)
