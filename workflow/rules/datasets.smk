# Solving: all that takes solutions of a scene, in one process, as loading what solves takes longer
# than solving; and one NetCDF file a schematic with the sections that it shows.


rule solve_scene:
    input:
        modules=import_closure("workflow/scripts/solve_scene.py"),
    output:
        dataset="<results>/datasets/{figure}.nc",
        cost="<results>/accuracy/solver_cost/{figure}.csv",
        tpca_loads="<results>/extracted/tpca_loads/{figure}.csv",
        transitions="<results>/extracted/transitions/{figure}.csv",
        band="<results>/bands/{figure}.nc",
    log:
        "<logs>/solve_scene/{figure}.log",
    benchmark:
        "<logs>/solve_scene/{figure}.tsv"
    wildcard_constraints:
        figure="|".join(settings["scenes"]),
    priority: 1
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    params:
        scene=lookup(dpath="scenes/{figure}", within=settings),
        parameters=settings["parameters"],
        ensemble=settings["ensemble"],
        software=settings["software"],
    message:
        "Solving {wildcards.figure}"
    script:
        "../scripts/solve_scene.py"


rule compute_schematic:
    input:
        modules=import_closure("workflow/scripts/compute_schematic.py"),
    output:
        sections="<results>/schematics/{figure}.nc",
    log:
        "<logs>/compute_schematic/{figure}.log",
    benchmark:
        "<logs>/compute_schematic/{figure}.tsv"
    wildcard_constraints:
        figure="|".join(settings["schematics"]),
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    params:
        panels=lookup(dpath="schematics/{figure}", within=settings),
        parameters=settings["parameters"],
    message:
        "Solving the sections of {wildcards.figure}"
    script:
        "../scripts/compute_schematic.py"
