# Sensitivity: how results respond to the inputs that the paper does not print, at the default.
SENSITIVITY = settings["sensitivity"]
UNPUBLISHED = [*CALIBRATION["unknowns"], *SENSITIVITY["also"]]


rule compute_elasticities:
    input:
        modules=import_closure("workflow/scripts/compute_elasticities.py"),
    output:
        rows="<results>/extracted/sensitivity/elasticities.csv",
    log:
        "<logs>/compute_elasticities.log",
    benchmark:
        "<logs>/compute_elasticities.tsv"
    priority: 1
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    params:
        settings=SENSITIVITY,
        unpublished=UNPUBLISHED,
        parameters=settings["parameters"],
    message:
        "Differentiating results with respect to each unpublished input"
    script:
        "../scripts/compute_elasticities.py"


rule compute_sobol_indices:
    input:
        modules=import_closure("workflow/scripts/compute_sobol_indices.py"),
    output:
        rows="<results>/extracted/sensitivity/sobol_indices.csv",
    log:
        "<logs>/compute_sobol_indices.log",
    benchmark:
        "<logs>/compute_sobol_indices.tsv"
    priority: 1
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    params:
        settings=SENSITIVITY,
        unpublished=UNPUBLISHED,
        parameters=settings["parameters"],
    message:
        "Dividing the variance of results among the unpublished inputs"
    script:
        "../scripts/compute_sobol_indices.py"


rule render_sensitivity:
    input:
        table="<results>/tables/sensitivity.csv",
        style=place_of("src/thirdbody/figures/paper.mplstyle"),
        modules=import_closure("workflow/scripts/render_sensitivity.py"),
    output:
        multiext("<results>/figures/sensitivity", svg=".svg", pdf=".pdf", csv=".csv", md=".md"),
        png=report("<results>/figures/sensitivity.png", subcategory="Figures", **IN_REPORT),
    log:
        "<logs>/render_sensitivity.log",
    benchmark:
        "<logs>/render_sensitivity.tsv"
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    message:
        "Drawing the sensitivities"
    script:
        "../scripts/render_sensitivity.py"
