# Accuracy: `snakemake -c2 accuracy`, not part of the default run: errors, extremes and what follows
# from them and from the times of timing.smk.
import sys

from thirdbody.configuration.schema import read_valid

try:
    ACCURACY = read_valid(settings["accuracy"], "accuracy")
except ValueError as error:
    sys.exit(f"{error}")


rule measure_errors:
    input:
        points=place_of("tests/golden/accuracy_points.csv"),
        plain=place_of("verification/plain_model.py"),
        modules=import_closure("workflow/scripts/measure_errors.py"),
    output:
        errors="<results>/accuracy/errors.csv",
    log:
        "<logs>/measure_errors.log",
    benchmark:
        "<logs>/measure_errors.tsv"
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    resources:
        runtime=30,
    params:
        rtol=ACCURACY["rtol"],
    message:
        "Measuring errors against multiple precision"
    script:
        "../scripts/measure_errors.py"


rule judge_extremes:
    input:
        extremes=place_of("tests/golden/extremes.csv"),
        modules=import_closure("workflow/scripts/judge_extremes.py"),
    output:
        verdicts="<results>/accuracy/extremes.csv",
    log:
        "<logs>/judge_extremes.log",
    benchmark:
        "<logs>/judge_extremes.tsv"
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    resources:
        runtime=30,
    params:
        rtol=ACCURACY["rtol"],
    message:
        "Judging every extreme"
    script:
        "../scripts/judge_extremes.py"


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
    threads: 1
    resources:
        runtime=60,
    params:
        settings=ACCURACY["oracle"],
    message:
        "Comparing all readings with extended precision"
    script:
        "../scripts/compare_oracle.py"


rule gather_accuracy:
    input:
        errors="<results>/accuracy/errors.csv",
        extremes="<results>/accuracy/extremes.csv",
        oracle="<results>/accuracy/oracle.csv",
        times="<results>/accuracy/times.csv",
        omissions="<results>/accuracy/omissions.csv",
        scaling="<results>/accuracy/scaling.csv",
        surfaces="<results>/accuracy/surfaces.csv",
        starts="<results>/accuracy/starts.csv",
        streaming="<results>/accuracy/streaming.csv",
        modules=import_closure("workflow/scripts/gather_accuracy.py"),
    output:
        dataset="<results>/accuracy/accuracy.nc",
        bars="<results>/accuracy/bars.csv",
        text="<results>/accuracy/bars.md",
    log:
        "<logs>/gather_accuracy.log",
    benchmark:
        "<logs>/gather_accuracy.tsv"
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    message:
        "Gathering errors and times"
    script:
        "../scripts/gather_accuracy.py"


rule render_accuracy:
    input:
        errors="<results>/accuracy/errors.csv",
        times="<results>/accuracy/times.csv",
        style=place_of("src/thirdbody/figures/paper.mplstyle"),
        modules=import_closure("workflow/scripts/render_accuracy.py"),
    output:
        multiext("<results>/figures/accuracy", svg=".svg", pdf=".pdf", csv=".csv", md=".md"),
        png=report("<results>/figures/accuracy.png", subcategory="Figures", **IN_REPORT),
    log:
        "<logs>/render_accuracy.log",
    benchmark:
        "<logs>/render_accuracy.tsv"
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    message:
        "Drawing errors against times"
    script:
        "../scripts/render_accuracy.py"


rule accuracy:
    input:
        "<results>/accuracy/errors.csv",
        "<results>/accuracy/extremes.csv",
        "<results>/accuracy/oracle.csv",
        "<results>/accuracy/times.csv",
        "<results>/accuracy/omissions.csv",
        "<results>/accuracy/scaling.csv",
        "<results>/accuracy/surfaces.csv",
        "<results>/accuracy/starts.csv",
        "<results>/accuracy/streaming.csv",
        "<results>/accuracy/bars.csv",
        "<results>/accuracy/bars.md",
        "<results>/accuracy/accuracy.nc",
        multiext("<results>/figures/accuracy", ".svg", ".pdf", ".png", ".csv", ".md"),
    message:
        "All that measures accuracy is made"
