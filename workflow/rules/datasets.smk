# Solving: one dataset per figure, the ensemble ranges of its curves, and the sections of the schematics.


rule solve_scene:
    output:
        dataset="<results>/datasets/{scene}.nc",
    log:
        "<logs>/solve_scene/{scene}.log",
    params:
        *sources_of("solve_scene.py"),
        *SOFTWARE,
        scene=lookup(dpath="{scene}", within=settings["scenes"]),
        version=version_of("datasets"),
        parameters=settings["parameters"],
    message:
        "Solve the curves of {wildcards.scene}"
    script:
        "../scripts/solve_scene.py"


rule solve_ensemble:
    input:
        dataset="<results>/datasets/{scene}.nc",
    output:
        band="<results>/bands/{scene}.nc",
    log:
        "<logs>/solve_ensemble/{scene}.log",
    params:
        *sources_of("solve_ensemble.py"),
        *SOFTWARE,
        parameters=settings["parameters"],
        ensemble=settings["ensemble"],
        version=version_of("bands"),
    message:
        "Solve the curves of {wildcards.scene} for the ensemble"
    script:
        "../scripts/solve_ensemble.py"


rule compute_schematic:
    output:
        sections="<results>/schematics/{schematic}.nc",
    log:
        "<logs>/compute_schematic/{schematic}.log",
    params:
        *sources_of("compute_schematic.py"),
        *SOFTWARE,
        panels=lookup(dpath="{schematic}", within=settings["schematics"]),
        version=version_of("schematics"),
        parameters=settings["parameters"],
    message:
        "Compute the sections of {wildcards.schematic}"
    script:
        "../scripts/compute_schematic.py"
