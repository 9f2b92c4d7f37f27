# The atlas: `snakemake -c2 atlas`, not part of the default run.  A job solves the conditions at a
# roughness.  An interruption loses only the running chunks.


rule solve_chunk:
    output:
        chunk="<results>/atlas/chunks/{roughness_nm}nm.nc",
    log:
        "<logs>/solve_chunk/{roughness_nm}nm.log",
    benchmark:
        "<logs>/solve_chunk/{roughness_nm}nm.tsv"
    resources:
        runtime=30,
    params:
        *sources_of("solve_chunk.py"),
        *SOFTWARE,
        asked=lambda wildcards: settings["atlas"] | {"roughness_nm": float(wildcards.roughness_nm)},
        parameters=settings["parameters"],
    message:
        "Solve the atlas at a roughness of {wildcards.roughness_nm} nm"
    script:
        "../scripts/solve_chunk.py"


rule atlas:
    input:
        [f"<results>/atlas/chunks/{each:.12g}nm.nc" for each in settings["atlas"]["roughness_nm"]],
    message:
        "The atlas is there"
