"""Solve one scene: its dataset, what its curves show, and the envelope of the ensemble around them."""

from thirdbody.run.job import logged

import time

from thirdbody.data.dataset import scene_dataset
from thirdbody.data.extraction import tpca_rows, transition_rows
from thirdbody.data.files import whole
from thirdbody.data.netcdf import read_plain, write_dataset
from thirdbody.data.scene import Scene
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.model.parameters import Parameters
from thirdbody.study.band import band


def solve(figure, scene, inputs, ensemble, dataset, cost, tpca_loads, transitions, envelope):
    """Write the dataset of the scene ``figure`` and what solving it cost; then, from the dataset, its
    turning points, its transitions and the ``envelope`` of the ``ensemble``."""
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
    places = dataset, cost, tpca_loads, transitions, envelope
    with whole(*places) as (dataset_part, cost_part, tpca_part, transitions_part, envelope_part):
        write_dataset(solved, dataset_part)
        write_csv(cost_part, [row], TABLES["solver_cost"])
        curves = read_plain(dataset_part)
        write_csv(tpca_part, tpca_rows(figure, curves, inputs), TABLES["tpca_loads"])
        write_csv(transitions_part, transition_rows(figure, curves, inputs), TABLES["transitions"])
        write_dataset(band(curves, inputs, ensemble), envelope_part)
    print(f"{figure}: {shown.size} points in {seconds:.3f} s; {len(ensemble)} members around them")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        solve(
            snakemake.wildcards.figure,
            snakemake.params.scene,
            Parameters(**snakemake.params.parameters),
            snakemake.params.ensemble,
            snakemake.output.dataset,
            snakemake.output.cost,
            snakemake.output.tpca_loads,
            snakemake.output.transitions,
            snakemake.output.band,
        )
