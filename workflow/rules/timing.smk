# Times of the library, for `snakemake -c2 accuracy`.  What is timed runs alone: it takes all of the
# resource `quiet`, of which workflow/profiles/default gives every other job a share.


rule time_classes:
    input:
        plain=place_of("verification/plain_model.py"),
        modules=import_closure("workflow/scripts/time_classes.py"),
    output:
        times="<results>/accuracy/times.csv",
    log:
        "<logs>/time_classes.log",
    benchmark:
        "<logs>/time_classes.tsv"
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
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
        modules=import_closure("workflow/scripts/time_sweeps.py"),
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
    threads: 1
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
        modules=import_closure("workflow/scripts/time_starts.py"),
    output:
        table="<results>/accuracy/starts.csv",
    log:
        "<logs>/time_starts.log",
    benchmark:
        "<logs>/time_starts.tsv"
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
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
        modules=import_closure("workflow/scripts/time_streaming.py"),
    output:
        table="<results>/accuracy/streaming.csv",
    log:
        "<logs>/time_streaming.log",
    benchmark:
        "<logs>/time_streaming.tsv"
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
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
