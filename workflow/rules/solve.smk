# Solving: datasets, the ensemble ranges of their curves, what is extracted from them; the atlas.


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
        ensemble_range="<results>/bands/{scene}.nc",
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


rule recompute_paper_tables:
    output:
        table1="<results>/extracted/table1/all.csv",
        table2="<results>/extracted/table2/all.csv",
    log:
        "<logs>/recompute_paper_tables.log",
    params:
        *sources_of("recompute_paper_tables.py"),
        PAPER_TABLES_TEXT,
        printed=PAPER_TABLES,
        parameters=settings["parameters"],
    message:
        "Recompute Tables 1 and 2 of the paper"
    script:
        "../scripts/recompute_paper_tables.py"


# The atlas: `snakemake -c2 atlas`, not part of the default run.  A job solves the conditions at a
# roughness.  An interruption loses only the running chunks.


rule solve_chunk:
    output:
        chunk="<results>/atlas/chunks/{roughness_nm}nm.nc",
    log:
        "<logs>/solve_chunk/{roughness_nm}nm.log",
    benchmark:
        "<logs>/solve_chunk/{roughness_nm}nm.tsv"
    resources:
        runtime=30,
    params:
        *sources_of("solve_chunk.py"),
        *SOFTWARE,
        asked=lambda wildcards: settings["atlas"] | {"roughness_nm": float(wildcards.roughness_nm)},
        parameters=settings["parameters"],
    message:
        "Solve the atlas at a roughness of {wildcards.roughness_nm} nm"
    script:
        "../scripts/solve_chunk.py"


rule atlas:
    input:
        [f"<results>/atlas/chunks/{each:.12g}nm.nc" for each in settings["atlas"]["roughness_nm"]],
    message:
        "The atlas"
