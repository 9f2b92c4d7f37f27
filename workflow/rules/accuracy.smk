# `snakemake -c2 accuracy`, not part of the default run: errors, checks of extremes, times, and targets.

ACCURACY = settings["accuracy"]
MEASURED = digest(
    path for folder in ("src", "benchmarks") for path in HOME.glob(f"{folder}/**/*.py")
)


rule measure_errors:
    input:
        points=project_file("tests/golden/accuracy_points.csv"),
        extremes=project_file("tests/golden/extremes.csv"),
        plain=project_file("verification/plain_model.py"),
    output:
        errors="<results>/accuracy/errors.csv",
        verdicts="<results>/accuracy/extremes.csv",
    log:
        "<logs>/measure_errors.log",
    conda:
        "../envs/thirdbody.yaml"
    params:
        rtol=ACCURACY["rtol"],
        sources=MEASURED,
    message:
        "Measuring errors and checking all extremes"
    script:
        "../scripts/measure_errors.py"


rule compare_oracle:
    input:
        oracle=project_file("tests/oracle/contact.c"),
    output:
        table="<results>/accuracy/oracle.csv",
    log:
        "<logs>/compare_oracle.log",
    conda:
        "../envs/thirdbody.yaml"
    resources:
        runtime=60,
    params:
        settings=ACCURACY["oracle"],
        sources=MEASURED,
    message:
        "Comparing all interpretations with extended precision"
    script:
        "../scripts/compare_oracle.py"


# Uses the whole resource `quiet`, so that it runs alone.
rule time_library:
    input:
        plain=project_file("verification/plain_model.py"),
    output:
        times="<results>/accuracy/times.csv",
        uses="<results>/accuracy/uses.csv",
    log:
        "<logs>/time_library.log",
    conda:
        "../envs/thirdbody.yaml"
    resources:
        quiet=100,
        runtime=30,
    params:
        budget=ACCURACY,
        parameters=settings["parameters"],
        sources=MEASURED,
    message:
        "Timing points, grids and typical uses"
    script:
        "../scripts/time_library.py"


ACCURACY_TABLES = {
    name: f"<results>/accuracy/{name}.csv"
    for name in ("errors", "extremes", "oracle", "times", "uses")
}


rule compare_targets:
    input:
        **ACCURACY_TABLES,
    output:
        targets="<results>/accuracy/targets.csv",
    log:
        "<logs>/compare_targets.log",
    conda:
        "../envs/thirdbody.yaml"
    params:
        sources=MEASURED,
    message:
        "Comparing the measurements with the targets"
    script:
        "../scripts/compare_targets.py"


rule accuracy:
    input:
        *ACCURACY_TABLES.values(),
        "<results>/accuracy/targets.csv",
    message:
        "Errors, extremes, times and targets are complete"
