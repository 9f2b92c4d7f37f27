# Datasets: one NetCDF file a scene.


rule compute_dataset:
    input:
        modules=import_closure("workflow/scripts/compute_dataset.py"),
    output:
        dataset="results/datasets/{figure}.nc",
        cost="results/accuracy/solver_cost/{figure}.csv",
    log:
        "logs/compute_dataset/{figure}.log",
    benchmark:
        "logs/compute_dataset/{figure}.tsv"
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
