# Sensitivity: how results respond to the inputs that the paper does not print, at the default.
SENSITIVITY = settings["sensitivity"]
UNPUBLISHED = [*CALIBRATION["unknowns"], *SENSITIVITY["also"]]


# both in one process, as loading what solves takes about as long as either
rule compute_sensitivities:
    input:
        modules=import_closure("workflow/scripts/compute_sensitivities.py"),
    output:
        elasticities="<results>/extracted/sensitivity/elasticities.csv",
        indices="<results>/extracted/sensitivity/sobol_indices.csv",
    log:
        "<logs>/compute_sensitivities.log",
    benchmark:
        "<logs>/compute_sensitivities.tsv"
    priority: 1
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    params:
        settings=SENSITIVITY,
        unpublished=UNPUBLISHED,
        parameters=settings["parameters"],
    message:
        "Computing how results respond to each unpublished input"
    script:
        "../scripts/compute_sensitivities.py"


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
