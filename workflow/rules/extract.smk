# Extraction: turning points and transitions of datasets, windows, sensitivities, and the printed numbers.


rule extract_curves:
    input:
        dataset="<results>/datasets/{scene}.nc",
    output:
        tpca_loads="<results>/extracted/tpca_loads/{scene}.csv",
        transitions="<results>/extracted/transitions/{scene}.csv",
    log:
        "<logs>/extract_curves/{scene}.log",
    params:
        *sources_of("extract_curves.py"),
        *SOFTWARE,
        parameters=settings["parameters"],
    message:
        "Find the turning points and transitions of {wildcards.scene}"
    script:
        "../scripts/extract_curves.py"


rule find_windows:
    output:
        windows="<results>/extracted/tpca_windows/all.csv",
    log:
        "<logs>/find_windows.log",
    params:
        *sources_of("find_windows.py"),
        *SOFTWARE,
        windows=settings["windows"],
        load_axis=settings["load_axis"],
        parameters=settings["parameters"],
    message:
        "Find the ranges of x_a/sigma with a turning point"
    script:
        "../scripts/find_windows.py"


# to the unprinted inputs, at the default
rule compute_sensitivities:
    output:
        elasticities="<results>/extracted/sensitivity/all.csv",
    log:
        "<logs>/compute_sensitivities.log",
    params:
        *sources_of("compute_sensitivities.py"),
        *SOFTWARE,
        settings=settings["sensitivity"],
        unpublished=[*settings["calibration"]["unknowns"], *settings["sensitivity"]["also"]],
        parameters=settings["parameters"],
    message:
        "Compute how much each input changes each result"
    script:
        "../scripts/compute_sensitivities.py"


rule gather_printed:
    output:
        table="<results>/extracted/printed/all.csv",
    log:
        "<logs>/gather_printed.log",
    params:
        *sources_of("gather_printed.py"),
        settings_text(CLAIMS, list),
        claims=CLAIMS,
    message:
        "Gather the numbers that the paper prints"
    script:
        "../scripts/gather_printed.py"


rule recompute_paper_tables:
    output:
        table1="<results>/extracted/table1/all.csv",
        table2="<results>/extracted/table2/all.csv",
    log:
        "<logs>/recompute_paper_tables.log",
    params:
        *sources_of("recompute_paper_tables.py"),
        settings_text(PAPER_TABLES),
        printed=PAPER_TABLES,
        parameters=settings["parameters"],
    message:
        "Recompute Tables 1 and 2 of the paper"
    script:
        "../scripts/recompute_paper_tables.py"
