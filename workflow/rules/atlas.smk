# The atlas: `snakemake -c2 atlas`, not part of the default run.  A job solves some of the roughnesses
# for all inputs, once; all else is taken from its file.  An interruption loses the chunks under way.
import sys

from thirdbody.configuration.schema import read_valid

try:
    ATLAS = read_valid(settings["atlas"], "atlas")
except ValueError as error:
    sys.exit(f"{error}")


scattergather:
    atlas=ATLAS["chunks"],


rule solve_chunk:
    input:
        modules=import_closure("workflow/scripts/solve_chunk.py"),
    output:
        chunk="<results>/atlas/chunks/{scatteritem}.nc",
        cost="<results>/atlas/cost/{scatteritem}.csv",
    log:
        "<logs>/solve_chunk/{scatteritem}.log",
    benchmark:
        "<logs>/solve_chunk/{scatteritem}.tsv"
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    params:
        axes=ATLAS["axes"],
        variables=ATLAS["variables"],
        rtol=ATLAS["rtol"],
        parameters=settings["parameters"],
        ensemble=settings["ensemble"],
    message:
        "Solving chunk {wildcards.scatteritem} of the atlas"
    script:
        "../scripts/solve_chunk.py"


rule catalogue_atlas:
    input:
        chunks=gather.atlas("<results>/atlas/chunks/{scatteritem}.nc"),
        cost=gather.atlas("<results>/atlas/cost/{scatteritem}.csv"),
        modules=import_closure("workflow/scripts/catalogue_atlas.py"),
    output:
        catalogue="<results>/atlas/catalogue.json",
        cost="<results>/atlas/cost.csv",
    log:
        "<logs>/catalogue_atlas.log",
    benchmark:
        "<logs>/catalogue_atlas.tsv"
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    message:
        "Cataloguing the atlas"
    script:
        "../scripts/catalogue_atlas.py"


rule atlas:
    input:
        "<results>/atlas/catalogue.json",
        "<results>/atlas/cost.csv",
    message:
        "All of the atlas is made"
