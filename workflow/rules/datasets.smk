# Solving: one dataset a figure, the ranges of the ensemble around its curves, the sections of a schematic.


rule solve_scene:
    input:
        modules=modules_of("solve_scene.py"),
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
    message:
        "Solving {wildcards.figure}"
    script:
        "../scripts/solve_scene.py"


rule solve_ensemble:
    input:
        dataset="<results>/datasets/{figure}.nc",
        modules=modules_of("solve_ensemble.py"),
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
    message:
        "Solving {wildcards.figure} for each member of the ensemble"
    script:
        "../scripts/solve_ensemble.py"


rule compute_schematic:
    input:
        modules=modules_of("compute_schematic.py"),
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
    message:
        "Solving the sections of {wildcards.figure}"
    script:
        "../scripts/compute_schematic.py"
