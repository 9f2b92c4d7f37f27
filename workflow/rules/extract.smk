# Extraction: turning points and transitions of datasets, windows, and the printed numbers.


rule extract_curves:
    input:
        dataset="<results>/datasets/{scene}.nc",
    output:
        tpca_loads="<results>/extracted/tpca_loads/{scene}.csv",
        transitions="<results>/extracted/transitions/{scene}.csv",
    log:
        "<logs>/extract_curves/{scene}.log",
    conda:
        "../envs/thirdbody.yaml"
    params:
        parameters=settings["parameters"],
        sources=sources_of("extract_curves.py"),
    message:
        "Extracting turning points and transitions of {wildcards.scene}"
    script:
        "../scripts/extract_curves.py"


rule find_windows:
    output:
        windows="<results>/extracted/tpca_windows/all.csv",
    log:
        "<logs>/find_windows.log",
    conda:
        "../envs/thirdbody.yaml"
    params:
        windows=settings["windows"],
        load_axis=settings["load_axis"],
        parameters=settings["parameters"],
        sources=sources_of("find_windows.py"),
    message:
        "Searching the x_a/sigma windows of the turning point"
    script:
        "../scripts/find_windows.py"


rule gather_printed:
    output:
        table="<results>/extracted/printed/all.csv",
    log:
        "<logs>/gather_printed.log",
    conda:
        "../envs/thirdbody.yaml"
    params:
        claims=configured("claims"),
        sources=sources_of("gather_printed.py", config=["claims"]),
    message:
        "Gathering the printed numbers of the paper"
    script:
        "../scripts/gather_printed.py"


rule recompute_paper_tables:
    output:
        table1="<results>/extracted/table1/all.csv",
        table2="<results>/extracted/table2/all.csv",
    log:
        "<logs>/recompute_paper_tables.log",
    priority: SMALL
    conda:
        "../envs/thirdbody.yaml"
    params:
        printed=configured("paper_tables"),
        parameters=settings["parameters"],
        sources=sources_of("recompute_paper_tables.py", config=["paper_tables"]),
    message:
        "Recomputing the tables of the paper"
    script:
        "../scripts/recompute_paper_tables.py"


# sensitivity of the results to the unprinted inputs, at the default
rule compute_sensitivities:
    output:
        elasticities="<results>/extracted/sensitivity/elasticities.csv",
        indices="<results>/extracted/sensitivity/sobol_indices.csv",
    log:
        "<logs>/compute_sensitivities.log",
    conda:
        "../envs/thirdbody.yaml"
    params:
        settings=settings["sensitivity"],
        unpublished=[*settings["calibration"]["unknowns"], *settings["sensitivity"]["also"]],
        parameters=settings["parameters"],
        sources=sources_of("compute_sensitivities.py"),
    message:
        "Computing the sensitivity to each unprinted input"
    script:
        "../scripts/compute_sensitivities.py"
