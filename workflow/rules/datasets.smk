# Solving: one dataset per figure, the ensemble ranges of its curves, and the sections of the schematics.


rule solve_scene:
    output:
        dataset="<results>/datasets/{scene}.nc",
    log:
        "<logs>/solve_scene/{scene}.log",
    conda:
        "../envs/thirdbody.yaml"
    params:
        scene=lookup(dpath="scenes/{scene}", within=settings),
        parameters=settings["parameters"],
        software=settings["software"],
        sources=sources_of("solve_scene.py"),
    message:
        "Solving {wildcards.scene}"
    script:
        "../scripts/solve_scene.py"


rule solve_ensemble:
    input:
        dataset="<results>/datasets/{scene}.nc",
    output:
        band="<results>/bands/{scene}.nc",
    log:
        "<logs>/solve_ensemble/{scene}.log",
    conda:
        "../envs/thirdbody.yaml"
    params:
        parameters=settings["parameters"],
        ensemble=settings["ensemble"],
        sources=sources_of("solve_ensemble.py"),
    message:
        "Solving {wildcards.scene} for each member of the ensemble"
    script:
        "../scripts/solve_ensemble.py"


rule compute_schematic:
    output:
        sections="<results>/schematics/{schematic}.nc",
    log:
        "<logs>/compute_schematic/{schematic}.log",
    priority: SMALL
    conda:
        "../envs/thirdbody.yaml"
    params:
        panels=lookup(dpath="schematics/{schematic}", within=settings),
        parameters=settings["parameters"],
        sources=sources_of("compute_schematic.py"),
    message:
        "Solving the sections of {wildcards.schematic}"
    script:
        "../scripts/compute_schematic.py"
