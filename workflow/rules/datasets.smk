# Datasets: one NetCDF file a scene, and one a schematic with the sections that it shows.


rule compute_dataset:
    input:
        modules=import_closure("workflow/scripts/compute_dataset.py"),
    output:
        dataset="<results>/datasets/{figure}.nc",
        cost="<results>/accuracy/solver_cost/{figure}.csv",
    log:
        "<logs>/compute_dataset/{figure}.log",
    benchmark:
        "<logs>/compute_dataset/{figure}.tsv"
    wildcard_constraints:
        figure="|".join(settings["scenes"]),
    priority: 1
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    params:
        scene=lookup(dpath="scenes/{figure}", within=settings),
        parameters=settings["parameters"],
        software=settings["software"],
    message:
        "Solving {wildcards.figure}"
    script:
        "../scripts/compute_dataset.py"


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
