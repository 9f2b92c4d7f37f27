# `snakemake -c2 accuracy`, not part of the default run: errors, checks of extremes, times, and their figure.

ACCURACY = settings["accuracy"]
# all that may run: `sources_of` does not follow the imports of the benchmarks
MEASURED = [
    *(SOURCES.text(path) for path in sorted(HOME.glob("src/**/*.py"))),
    *(SOURCES.text(path) for path in sorted(HOME.glob("benchmarks/*.py"))),
]


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
    params:
        *MEASURED,
        *SOFTWARE,
        SOURCES.text(HOME / "workflow/scripts/measure_errors.py"),
        rtol=ACCURACY["rtol"],
    message:
        "Measure errors"
    script:
        "../scripts/measure_errors.py"


rule compare_oracle:
    input:
        oracle=project_file("tests/oracle/contact.c"),
    output:
        table="<results>/accuracy/oracle.csv",
    log:
        "<logs>/compare_oracle.log",
    threads: 8
    resources:
        runtime=60,
    params:
        *MEASURED,
        *SOFTWARE,
        SOURCES.text(HOME / "workflow/scripts/compare_oracle.py"),
        settings=ACCURACY["oracle"],
    message:
        "Compare with the oracle"
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
    resources:
        quiet=100,
        runtime=30,
    params:
        *MEASURED,
        *SOFTWARE,
        SOURCES.text(HOME / "workflow/scripts/time_library.py"),
        budget=ACCURACY,
        parameters=settings["parameters"],
    message:
        "Measure times"
    script:
        "../scripts/time_library.py"


ACCURACY_TABLES = {
    name: f"<results>/accuracy/{name}.csv"
    for name in ("errors", "extremes", "oracle", "times", "uses")
}


rule draw_work_precision:
    input:
        errors=ACCURACY_TABLES["errors"],
        times=ACCURACY_TABLES["times"],
    output:
        figure="<results>/accuracy/work_precision.png",
    log:
        "<logs>/draw_work_precision.log",
    params:
        *MEASURED,
        *SOFTWARE,
        SOURCES.text(HOME / "workflow/scripts/draw_work_precision.py"),
    message:
        "Draw times over errors"
    script:
        "../scripts/draw_work_precision.py"


rule accuracy:
    input:
        *ACCURACY_TABLES.values(),
        "<results>/accuracy/work_precision.png",
    message:
        "All measurements"
