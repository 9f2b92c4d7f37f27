"""Solve some surfaces of the atlas, for the default inputs and each member of the ensemble."""

import numpy as np

from thirdbody.atlas.chunk import atlas_axes, write_chunk
from thirdbody.data.files import atomic_write
from thirdbody.job_log import logged
from thirdbody.model.parameters import Parameters


def solve(item, axes, variables, rtol, parameters, ensemble, chunk):
    """Write the ``chunk`` called ``item``, as 3-of-8."""
    number, chunks = map(int, item.split("-of-"))
    grid = atlas_axes(axes)
    grid["roughness"] = np.array_split(grid["roughness"], chunks)[number - 1]
    with atomic_write(chunk) as part:
        write_chunk(part, grid, Parameters(**parameters), ensemble, variables, rtol)


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        solve(
            snakemake.wildcards.scatteritem,
            *(snakemake.params[name] for name in ("axes", "variables", "rtol")),
            *(snakemake.params[name] for name in ("parameters", "ensemble")),
            snakemake.output.chunk,
        )
