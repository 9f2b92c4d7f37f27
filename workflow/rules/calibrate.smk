# Calibration: `snakemake -c2 calibrate`, not part of the default run. Each search is a job, and keeps its
# evaluations, so that an interruption loses nothing. The result goes to config/calibrated/, which is kept in
# git and read by the default run.
import json

CALIBRATION = settings["calibration"]
SEEDS = CALIBRATION["seeds"]
FOLDS = range(len(CALIBRATION["folds"]))
FEW_UNKNOWNS = [
    name
    for name in CALIBRATION["readings"]
    if number_of_unknowns(CALIBRATION, name) <= CALIBRATION["shortlist"]["unknowns"]
]
SEARCHED = "<results>/calibration/{{reading}}/seed{seed}.csv"


def searches_of(wildcards):
    """The searches of an interpretation: of the shortlist from all seeds, else from the first."""
    return expand(SEARCHED, seed=SEEDS if is_shortlisted(wildcards) else SEEDS[:1])


def samples_of(wildcards):
    """The samples of an interpretation of the shortlist."""
    samples = "<results>/calibration/{{reading}}/seed{seed}_samples.csv"
    return expand(samples, seed=SEEDS) if is_shortlisted(wildcards) else []


def folds_of(wildcards):
    """The cross-validation of an interpretation of the shortlist."""
    folds = "<results>/calibration/{{reading}}/fold{fold}.csv"
    return expand(folds, fold=FOLDS) if is_shortlisted(wildcards) else []


def is_shortlisted(wildcards):
    chosen = checkpoints.shortlist.get().output.chosen
    return wildcards.reading in json.loads(Path(chosen).read_text(encoding="utf-8"))


wildcard_constraints:
    seed="[0-9]+",
    fold="[0-9]+",


rule scatter_inputs:
    input:
        claims=f"{CONFIG}/claims.yaml",
    output:
        scattered="<results>/calibration/{reading}/scattered.csv",
    log:
        "<logs>/scatter_inputs/{reading}.log",
    benchmark:
        "<logs>/scatter_inputs/{reading}.tsv"
    conda:
        "../envs/thirdbody.yaml"
    resources:
        runtime=30,
    params:
        settings=lambda wildcards: with_one_reading(CALIBRATION, wildcards.reading),
        parameters=settings["uncalibrated"],
        sources=sources_of("scatter_inputs.py"),
    message:
        "Judging scattered inputs of {wildcards.reading}"
    script:
        "../scripts/scatter_inputs.py"


rule search_inputs:
    input:
        claims=f"{CONFIG}/claims.yaml",
        scattered="<results>/calibration/{reading}/scattered.csv",
    output:
        evaluations="<results>/calibration/{reading}/seed{seed}.csv",
    log:
        "<logs>/search_inputs/{reading}_{seed}.log",
    benchmark:
        "<logs>/search_inputs/{reading}_{seed}.tsv"
    conda:
        "../envs/thirdbody.yaml"
    resources:
        runtime=30,
    params:
        settings=lambda wildcards: with_one_reading(CALIBRATION, wildcards.reading),
        parameters=settings["uncalibrated"],
        seeds=lambda wildcards: [int(wildcards.seed)],
        fold=None,
        sources=sources_of("search_inputs.py"),
    message:
        "Searching the inputs of {wildcards.reading} from seed {wildcards.seed}"
    script:
        "../scripts/search_inputs.py"


use rule search_inputs as search_fold with:
    output:
        evaluations="<results>/calibration/{reading}/fold{fold}.csv",
    log:
        "<logs>/search_fold/{reading}_{fold}.log",
    benchmark:
        "<logs>/search_fold/{reading}_{fold}.tsv"
    params:
        settings=lambda wildcards: with_one_reading(CALIBRATION, wildcards.reading),
        parameters=settings["uncalibrated"],
        seeds=SEEDS,
        fold=lambda wildcards: int(wildcards.fold),
        sources=sources_of("search_inputs.py"),
    message:
        "Searching the inputs of {wildcards.reading} without the figures of fold {wildcards.fold}"


checkpoint shortlist:
    input:
        evaluations=expand(
            "<results>/calibration/{reading}/seed{seed}.csv",
            reading=FEW_UNKNOWNS,
            seed=SEEDS[0],
        ),
    output:
        chosen="<results>/calibration/shortlist.json",
    log:
        "<logs>/shortlist.log",
    localrule: True
    conda:
        "../envs/thirdbody.yaml"
    params:
        within=CALIBRATION["shortlist"]["within"],
        most=CALIBRATION["shortlist"]["most"],
        sources=sources_of("choose_shortlist.py"),
    message:
        "Choosing the interpretations that are searched from all seeds and cross-validated"
    script:
        "../scripts/choose_shortlist.py"


rule sample_inputs:
    input:
        evaluations=expand(SEARCHED, seed=SEEDS),
        claims=f"{CONFIG}/claims.yaml",
    output:
        samples="<results>/calibration/{reading}/seed{seed}_samples.csv",
    log:
        "<logs>/sample_inputs/{reading}_{seed}.log",
    benchmark:
        "<logs>/sample_inputs/{reading}_{seed}.tsv"
    conda:
        "../envs/thirdbody.yaml"
    resources:
        runtime=30,
    params:
        settings=lambda wildcards: with_one_reading(CALIBRATION, wildcards.reading),
        parameters=settings["uncalibrated"],
        sources=sources_of("sample_inputs.py"),
    message:
        "Sampling the inputs of {wildcards.reading} from seed {wildcards.seed}"
    script:
        "../scripts/sample_inputs.py"


rule summarise_inputs:
    input:
        evaluations=searches_of,
        samples=samples_of,
        folds=folds_of,
        claims=f"{CONFIG}/claims.yaml",
    output:
        calibrated="<results>/calibration/{reading}.yaml",
    log:
        "<logs>/summarise_inputs/{reading}.log",
    conda:
        "../envs/thirdbody.yaml"
    params:
        settings=lambda wildcards: with_one_reading(CALIBRATION, wildcards.reading),
        parameters=settings["uncalibrated"],
        sources=sources_of("summarise_inputs.py"),
    message:
        "Summarising the calibration of {wildcards.reading}"
    script:
        "../scripts/summarise_inputs.py"
