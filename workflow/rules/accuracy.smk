# `snakemake -c2 accuracy`, not part of the default run: errors, verdicts on extremes, times, and targets.
import sys

from thirdbody.configuration.schema import read_valid

try:
    ACCURACY = read_valid(settings["accuracy"], "accuracy")
except ValueError as error:
    sys.exit(f"{error}")


rule measure_errors:
    input:
        points=place_of("tests/golden/accuracy_points.csv"),
        extremes=place_of("tests/golden/extremes.csv"),
        plain=place_of("verification/plain_model.py"),
        modules=import_closure("workflow/scripts/measure_errors.py"),
    output:
        errors="<results>/accuracy/errors.csv",
        verdicts="<results>/accuracy/extremes.csv",
    log:
        "<logs>/measure_errors.log",
    benchmark:
        "<logs>/measure_errors.tsv"
    conda:
        "../envs/thirdbody.yaml"
    params:
        rtol=ACCURACY["rtol"],
    message:
        "Measuring errors and judging every extreme"
    script:
        "../scripts/measure_errors.py"


rule compare_oracle:
    input:
        oracle=place_of("tests/oracle/contact.c"),
        modules=import_closure("workflow/scripts/compare_oracle.py"),
    output:
        table="<results>/accuracy/oracle.csv",
    log:
        "<logs>/compare_oracle.log",
    benchmark:
        "<logs>/compare_oracle.tsv"
    conda:
        "../envs/thirdbody.yaml"
    resources:
        runtime=60,
    params:
        settings=ACCURACY["oracle"],
    message:
        "Comparing all interpretations with extended precision"
    script:
        "../scripts/compare_oracle.py"


# Takes all of the resource `quiet`, so that it runs alone.
rule time_library:
    input:
        plain=place_of("verification/plain_model.py"),
        modules=import_closure("workflow/scripts/time_library.py"),
    output:
        times="<results>/accuracy/times.csv",
        uses="<results>/accuracy/uses.csv",
    log:
        "<logs>/time_library.log",
    benchmark:
        "<logs>/time_library.tsv"
    conda:
        "../envs/thirdbody.yaml"
    resources:
        quiet=100,
        runtime=30,
    params:
        budget=ACCURACY,
        parameters=settings["parameters"],
    message:
        "Timing points, grids and typical uses"
    script:
        "../scripts/time_library.py"


ACCURACY_TABLES = {
    name: f"<results>/accuracy/{name}.csv"
    for name in ("errors", "extremes", "oracle", "times", "uses")
}


rule render_accuracy:
    input:
        **ACCURACY_TABLES,
        style=place_of("src/thirdbody/figures/paper.mplstyle"),
        modules=import_closure("workflow/scripts/render_accuracy.py"),
    output:
        multiext("<results>/figures/accuracy", svg=".svg", pdf=".pdf", csv=".csv", md=".md"),
        png=report("<results>/figures/accuracy.png", subcategory="Figures", **IN_REPORT),
        targets="<results>/accuracy/targets.csv",
    log:
        "<logs>/render_accuracy.log",
    benchmark:
        "<logs>/render_accuracy.tsv"
    conda:
        "../envs/thirdbody.yaml"
    message:
        "Drawing errors against times; comparing with targets"
    script:
        "../scripts/render_accuracy.py"


rule accuracy:
    input:
        *ACCURACY_TABLES.values(),
        "<results>/accuracy/targets.csv",
        multiext("<results>/figures/accuracy", ".svg", ".pdf", ".png", ".csv", ".md"),
    message:
        "Errors, extremes, times and targets are there"
