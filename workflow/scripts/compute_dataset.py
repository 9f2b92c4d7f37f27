"""Solve one scene and write it as a dataset."""

import time

from thirdbody.data.dataset import scene_dataset
from thirdbody.data.files import logged, whole
from thirdbody.data.netcdf import write_dataset
from thirdbody.data.scene import Scene
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.model.parameters import Parameters


def compute(figure, scene, parameters, dataset, cost):
    """Write the dataset of the scene ``figure``, and beside it what solving it cost."""
    inputs = Parameters(**parameters)
    shown = Scene.of(figure, scene, inputs.newtons_per_load)
    start = time.process_time()
    solved = scene_dataset(shown, inputs, scene["rtol"])
    seconds = time.process_time() - start
    row = {
        "figure": figure,
        "points": shown.size,
        "rtol": scene["rtol"],
        "seconds": seconds,
        "microseconds_per_point": 1e6 * seconds / shown.size,
    }
    with whole(dataset, cost) as (dataset_part, cost_part):
        write_dataset(solved, dataset_part)
        write_csv(cost_part, [row], TABLES["solver_cost"])
    print(f"{figure}: {shown.size} points in {seconds:.3f} s")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        compute(
            snakemake.wildcards.figure,
            snakemake.params.scene,
            snakemake.params.parameters,
            snakemake.output.dataset,
            snakemake.output.cost,
        )
