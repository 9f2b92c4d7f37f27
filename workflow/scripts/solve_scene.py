"""Solve one scene: the dataset of a figure."""

from chenhorng.job_log import job
from chenhorng.scenes import scene_dataset
from thirdbody.core.parameters import Parameters
from thirdbody.netcdf import write_dataset

with job(snakemake) as output:
    figure = snakemake.wildcards.scene
    scene = snakemake.params.scene
    inputs = Parameters(**snakemake.params.parameters)
    solved = scene_dataset(scene, inputs, scene["rtol"])
    write_dataset(solved, output.dataset)
    shape = " x ".join(map(str, solved.sizes.values()))
    print(f"{figure}: {shape} points")
