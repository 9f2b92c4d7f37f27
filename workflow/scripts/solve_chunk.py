"""Solve some surfaces of the atlas, for the default inputs and each member of the ensemble."""

import numpy as np

from thirdbody.atlas.chunk import atlas_axes, write_chunk
from thirdbody.core.parameters import Parameters
from thirdbody.data.files import atomic_write
from thirdbody.job_log import logged

with logged(snakemake.log[0]):
    settings = snakemake.params
    number, chunks = map(int, snakemake.wildcards.scatteritem.split("-of-"))
    axes = atlas_axes(settings.axes)
    axes["roughness"] = np.array_split(axes["roughness"], chunks)[number - 1]
    default = Parameters(**settings.parameters)
    with atomic_write(snakemake.output.chunk) as part:
        write_chunk(part, axes, default, settings.ensemble, settings.variables, settings.rtol)
