# Calibration: `snakemake -c2 calibrate`, not part of the default run.  One search a reading and
# seed, so that an interruption loses no finished search; then samples, which begin at what all
# searches of the reading have found.  The result is copied to config/calibrated/, which is kept in
# git and read by the default run.

CALIBRATION = settings["calibration"]


rule search_reading:
    input:
        claims=f"{CONFIG}/claims.yaml",
    output:
        evaluations="<results>/calibration/{reading}/seed{seed}.csv",
        fronts="<results>/calibration/{reading}/seed{seed}_fronts.json",
    log:
        "<logs>/search_reading/{reading}_{seed}.log",
    benchmark:
        "<logs>/search_reading/{reading}_{seed}.tsv"
    wildcard_constraints:
        seed="[0-9]+",
    conda:
        "../envs/thirdbody.yaml"
    resources:
        runtime=30,
    params:
        settings=lambda wildcards: with_one_reading(CALIBRATION, wildcards.reading),
        parameters=settings["uncalibrated"],
        sources=sources_of("search_reading.py"),
    message:
        "Searching the inputs of {wildcards.reading} from seed {wildcards.seed}"
    script:
        "../scripts/search_reading.py"


rule sample_reading:
    input:
        evaluations=expand(
            "<results>/calibration/{{reading}}/seed{seed}.csv", seed=CALIBRATION["seeds"]
        ),
        claims=f"{CONFIG}/claims.yaml",
    output:
        samples="<results>/calibration/{reading}/seed{seed}_samples.csv",
    log:
        "<logs>/sample_reading/{reading}_{seed}.log",
    benchmark:
        "<logs>/sample_reading/{reading}_{seed}.tsv"
    wildcard_constraints:
        seed="[0-9]+",
    conda:
        "../envs/thirdbody.yaml"
    resources:
        runtime=90,
    params:
        settings=lambda wildcards: with_one_reading(CALIBRATION, wildcards.reading),
        parameters=settings["uncalibrated"],
        sources=sources_of("sample_reading.py"),
    message:
        "Sampling the inputs of {wildcards.reading} from seed {wildcards.seed}"
    script:
        "../scripts/sample_reading.py"


rule summarise_reading:
    input:
        evaluations=expand(
            "<results>/calibration/{{reading}}/seed{seed}.csv", seed=CALIBRATION["seeds"]
        ),
        samples=expand(
            "<results>/calibration/{{reading}}/seed{seed}_samples.csv", seed=CALIBRATION["seeds"]
        ),
        fronts=expand(
            "<results>/calibration/{{reading}}/seed{seed}_fronts.json", seed=CALIBRATION["seeds"]
        ),
        claims=f"{CONFIG}/claims.yaml",
    output:
        calibrated="<results>/calibration/{reading}.yaml",
    log:
        "<logs>/summarise_reading/{reading}.log",
    benchmark:
        "<logs>/summarise_reading/{reading}.tsv"
    conda:
        "../envs/thirdbody.yaml"
    resources:
        runtime=30,
    params:
        settings=lambda wildcards: with_one_reading(CALIBRATION, wildcards.reading),
        parameters=settings["uncalibrated"],
        sources=sources_of("summarise_reading.py"),
    message:
        "Summarising the calibration of {wildcards.reading}"
    script:
        "../scripts/summarise_reading.py"


rule calibrate:
    input:
        calibrated=expand("<results>/calibration/{reading}.yaml", reading=CALIBRATION["readings"]),
    output:
        adopted="<results>/calibration/adopted.txt",
    log:
        "<logs>/calibrate.log",
    benchmark:
        "<logs>/calibrate.tsv"
    localrule: True
    conda:
        "../envs/thirdbody.yaml"
    params:
        sources=sources_of("adopt_calibration.py"),
    message:
        "Copying the calibrated inputs to config/calibrated"
    script:
        "../scripts/adopt_calibration.py"
