# The atlas: `snakemake -c2 atlas`, not part of the default run.  A job solves some of the roughnesses
# for all inputs.  An interruption loses only the running chunks.

ATLAS = settings["atlas"]


scattergather:
    atlas=ATLAS["chunks"],


rule solve_chunk:
    output:
        chunk="<results>/atlas/chunks/{scatteritem}.nc",
    log:
        "<logs>/solve_chunk/{scatteritem}.log",
    benchmark:
        "<logs>/solve_chunk/{scatteritem}.tsv"
    resources:
        runtime=30,
    params:
        *sources_of("solve_chunk.py"),
        *SOFTWARE,
        axes=ATLAS["axes"],
        variables=ATLAS["variables"],
        rtol=ATLAS["rtol"],
        parameters=settings["parameters"],
        ensemble=settings["ensemble"],
    message:
        "Solve chunk {wildcards.scatteritem} of the atlas"
    script:
        "../scripts/solve_chunk.py"


rule atlas:
    input:
        gather.atlas("<results>/atlas/chunks/{scatteritem}.nc"),
    message:
        "The atlas is there"
