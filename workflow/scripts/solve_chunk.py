"""Solve some surfaces of the atlas, for the default inputs and each member of the ensemble."""

import math
import resource
import time
from pathlib import Path

from thirdbody.atlas.chunk import write_chunk
from thirdbody.atlas.grid import AtlasGrid
from thirdbody.data.files import atomic_write
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged
from thirdbody.model.parameters import Parameters


def solve(item, axes, variables, rtol, parameters, ensemble, chunk, cost):
    """Write the chunk called ``item``, as 3-of-8, and beside it what solving it cost."""
    grid = AtlasGrid.of(axes).chunk(*map(int, item.split("-of-")))
    begun, started = time.perf_counter(), time.process_time()
    with atomic_write(chunk, cost) as (chunk_part, cost_part):
        clock = write_chunk(chunk_part, grid, Parameters(**parameters), ensemble, variables, rtol)
        conditions = math.prod(grid.shape)
        row = {
            "chunk": item,
            "conditions": conditions,
            "points": conditions * clock.sets,
            "rtol": rtol,
            "solving_seconds": clock.solving,
            "searching_seconds": clock.searching,
            "seconds": time.process_time() - started,
            "clock_seconds": time.perf_counter() - begun,
            "resident_memory_MB": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e3,
            "file_MB": Path(chunk_part).stat().st_size / 1e6,
        }
        write_csv(cost_part, [row], TABLES["atlas_cost"])
    print(f"{item}: {row['points']} points in {row['seconds']:.1f} s")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        solve(
            snakemake.wildcards.scatteritem,
            *(snakemake.params[name] for name in ("axes", "variables", "rtol")),
            *(snakemake.params[name] for name in ("parameters", "ensemble")),
            snakemake.output.chunk,
            snakemake.output.cost,
        )
