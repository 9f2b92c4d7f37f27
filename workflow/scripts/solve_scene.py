"""Solve one scene: the dataset of a figure."""

from thirdbody.data.dataset import Scene, scene_dataset
from thirdbody.data.files import atomic_write
from thirdbody.data.netcdf import write_dataset
from thirdbody.job_log import logged
from thirdbody.model.parameters import Parameters

with logged(snakemake.log[0]):
    figure = snakemake.wildcards.scene
    scene = snakemake.params.scene
    inputs = Parameters(**snakemake.params.parameters)
    points = Scene.of(scene, inputs.newtons_per_load)
    solved = scene_dataset(points, inputs, scene["rtol"])
    with atomic_write(snakemake.output.dataset) as part:
        write_dataset(solved, part)
    print(f"{figure}: {points.size} points")
