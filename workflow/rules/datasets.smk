# Solving: one dataset a figure, the ranges of the ensemble around its curves, the sections of a schematic.


rule solve_scene:
    output:
        dataset="<results>/datasets/{figure}.nc",
    log:
        "<logs>/solve_scene/{figure}.log",
    benchmark:
        "<logs>/solve_scene/{figure}.tsv"
    wildcard_constraints:
        figure="|".join(settings["scenes"]),
    conda:
        "../envs/thirdbody.yaml"
    params:
        scene=lookup(dpath="scenes/{figure}", within=settings),
        parameters=settings["parameters"],
        software=settings["software"],
        sources=sources_of("solve_scene.py"),
    message:
        "Solving {wildcards.figure}"
    script:
        "../scripts/solve_scene.py"


rule solve_ensemble:
    input:
        dataset="<results>/datasets/{figure}.nc",
    output:
        band="<results>/bands/{figure}.nc",
    log:
        "<logs>/solve_ensemble/{figure}.log",
    benchmark:
        "<logs>/solve_ensemble/{figure}.tsv"
    wildcard_constraints:
        figure="|".join(settings["scenes"]),
    conda:
        "../envs/thirdbody.yaml"
    params:
        parameters=settings["parameters"],
        ensemble=settings["ensemble"],
        sources=sources_of("solve_ensemble.py"),
    message:
        "Solving {wildcards.figure} for each member of the ensemble"
    script:
        "../scripts/solve_ensemble.py"


rule compute_schematic:
    output:
        sections="<results>/schematics/{figure}.nc",
    log:
        "<logs>/compute_schematic/{figure}.log",
    wildcard_constraints:
        figure="|".join(SCHEMATICS),
    conda:
        "../envs/thirdbody.yaml"
    params:
        panels=lookup(dpath="schematics/{figure}", within=settings),
        parameters=settings["parameters"],
        sources=sources_of("compute_schematic.py"),
    message:
        "Solving the sections of {wildcards.figure}"
    script:
        "../scripts/compute_schematic.py"
