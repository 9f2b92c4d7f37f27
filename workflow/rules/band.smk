# Bands: the envelope of the calibrated ensemble around each figure's curves, drawn if config asks.


rule compute_band:
    input:
        dataset="<results>/datasets/{figure}.nc",
        calibrated=settings["calibrated"],
        modules=import_closure("workflow/scripts/compute_band.py"),
    output:
        band="<results>/bands/{figure}.nc",
    log:
        "<logs>/compute_band/{figure}.log",
    benchmark:
        "<logs>/compute_band/{figure}.tsv"
    priority: 1
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    params:
        parameters=settings["parameters"],
        laid_over=settings["inputs"],
    message:
        "Solving the ensemble around {wildcards.figure}"
    script:
        "../scripts/compute_band.py"
