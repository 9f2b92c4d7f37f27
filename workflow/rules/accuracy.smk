# Accuracy: `snakemake -c2 accuracy`, not part of the default run: errors, extremes and what follows
# from them and from the times of timing.smk.

ACCURACY = settings["accuracy"]
LIBRARY = sorted(
    str(path.relative_to(HOME))
    for folder in ("src", "benchmarks")
    for path in HOME.glob(f"{folder}/**/*.py")
)


rule measure_errors:
    input:
        points=project_file("tests/golden/accuracy_points.csv"),
        plain=project_file("verification/plain_model.py"),
        modules=LIBRARY,
    output:
        errors="<results>/accuracy/errors.csv",
    log:
        "<logs>/measure_errors.log",
    benchmark:
        "<logs>/measure_errors.tsv"
    conda:
        "../envs/thirdbody.yaml"
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
        extremes=project_file("tests/golden/extremes.csv"),
        modules=LIBRARY,
    output:
        verdicts="<results>/accuracy/extremes.csv",
    log:
        "<logs>/judge_extremes.log",
    benchmark:
        "<logs>/judge_extremes.tsv"
    conda:
        "../envs/thirdbody.yaml"
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
        oracle=project_file("tests/oracle/contact.c"),
        modules=LIBRARY,
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
        modules=LIBRARY,
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
    message:
        "Gathering errors and times"
    script:
        "../scripts/gather_accuracy.py"


rule render_accuracy:
    input:
        errors="<results>/accuracy/errors.csv",
        times="<results>/accuracy/times.csv",
        style=STYLE,
        modules=LIBRARY,
    output:
        multiext("<results>/figures/accuracy", svg=".svg", pdf=".pdf", csv=".csv", md=".md"),
        png=report(
            "<results>/figures/accuracy.png",
            caption="../report/product.rst",
            category="Accuracy",
            labels={"figure": "accuracy"},
        ),
    log:
        "<logs>/render_accuracy.log",
    benchmark:
        "<logs>/render_accuracy.tsv"
    conda:
        "../envs/thirdbody.yaml"
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


rule time_classes:
    input:
        plain=project_file("verification/plain_model.py"),
        modules=LIBRARY,
    output:
        times="<results>/accuracy/times.csv",
    log:
        "<logs>/time_classes.log",
    benchmark:
        "<logs>/time_classes.tsv"
    conda:
        "../envs/thirdbody.yaml"
    resources:
        quiet=100,
        runtime=30,
    params:
        budget=ACCURACY,
        parameters=settings["parameters"],
    message:
        "Timing every class of points"
    script:
        "../scripts/time_classes.py"


rule time_sweeps:
    input:
        modules=LIBRARY,
    output:
        omissions="<results>/accuracy/omissions.csv",
        scaling="<results>/accuracy/scaling.csv",
        surfaces="<results>/accuracy/surfaces.csv",
    log:
        "<logs>/time_sweeps.log",
    benchmark:
        "<logs>/time_sweeps.tsv"
    conda:
        "../envs/thirdbody.yaml"
    resources:
        quiet=100,
        runtime=30,
    params:
        budget=ACCURACY,
        parameters=settings["parameters"],
    message:
        "Timing omissions, sizes, surfaces, processes and threads"
    script:
        "../scripts/time_sweeps.py"


rule time_starts:
    input:
        modules=LIBRARY,
    output:
        table="<results>/accuracy/starts.csv",
    log:
        "<logs>/time_starts.log",
    benchmark:
        "<logs>/time_starts.tsv"
    conda:
        "../envs/thirdbody.yaml"
    resources:
        quiet=100,
        runtime=30,
    params:
        settings=ACCURACY["starts"],
    message:
        "Timing processes from their start to their answer"
    script:
        "../scripts/time_starts.py"


rule time_streaming:
    input:
        modules=LIBRARY,
    output:
        table="<results>/accuracy/streaming.csv",
    log:
        "<logs>/time_streaming.log",
    benchmark:
        "<logs>/time_streaming.tsv"
    conda:
        "../envs/thirdbody.yaml"
    resources:
        quiet=100,
        runtime=30,
    params:
        settings=ACCURACY["streaming"],
        parameters=settings["parameters"],
    message:
        "Timing a grid that is streamed to a file"
    script:
        "../scripts/time_streaming.py"
