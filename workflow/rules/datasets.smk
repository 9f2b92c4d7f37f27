# Solving: one dataset per figure, and the ensemble ranges of its curves.


rule solve_scene:
    output:
        dataset="<results>/datasets/{scene}.nc",
    log:
        "<logs>/solve_scene/{scene}.log",
    params:
        *sources_of("solve_scene.py"),
        *SOFTWARE,
        scene=lookup(dpath="{scene}", within=settings["scenes"]),
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
    message:
        "Solve the curves of {wildcards.scene} for the ensemble"
    script:
        "../scripts/solve_ensemble.py"
