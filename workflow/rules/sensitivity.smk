# Sensitivity: how results respond to the inputs that the paper does not print, at the default.

SENSITIVITY = settings["sensitivity"]


rule compute_sensitivities:
    output:
        elasticities="<results>/extracted/sensitivity/elasticities.csv",
        indices="<results>/extracted/sensitivity/sobol_indices.csv",
    log:
        "<logs>/compute_sensitivities.log",
    # the longest job: run last, it would leave a core idle
    priority: 1
    conda:
        "../envs/thirdbody.yaml"
    params:
        settings=SENSITIVITY,
        unpublished=[*settings["calibration"]["unknowns"], *SENSITIVITY["also"]],
        parameters=settings["parameters"],
        sources=sources_of("compute_sensitivities.py"),
    message:
        "Computing how results respond to each unpublished input"
    script:
        "../scripts/compute_sensitivities.py"
