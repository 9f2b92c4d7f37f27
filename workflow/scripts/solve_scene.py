"""Solve one scene: the dataset of a figure."""

from thirdbody.core.parameters import Parameters
from thirdbody.data.dataset import scene_dataset
from thirdbody.data.files import atomic_write
from thirdbody.data.netcdf import write_dataset
from thirdbody.job_log import logged

with logged(snakemake.log[0]):
    figure = snakemake.wildcards.scene
    scene = snakemake.params.scene
    inputs = Parameters(**snakemake.params.parameters)
    solved = scene_dataset(scene, inputs, scene["rtol"])
    with atomic_write(snakemake.output.dataset) as part:
        write_dataset(solved, part)
    shape = " x ".join(map(str, solved.sizes.values()))
    print(f"{figure}: {shape} points")
