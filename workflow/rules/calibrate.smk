# Calibration: `snakemake -c2 calibrate`, not part of the default run.  Each search for the
# unprinted inputs is a job that stores its evaluations; folds are sampled, and results summarised.
# The summary goes to config/calibrated/, which is kept in git and read by the default run.
from chenhorng.calibration.searches import Searches

CALIBRATION = settings["calibration"]
SEEDS = CALIBRATION["seeds"]
FOLDS = range(len(CALIBRATION["folds"]))
SEARCHES = Searches(CALIBRATION)
OF_INTERPRETATION = "<results>/calibration/{{interpretation}}"


wildcard_constraints:
    seed="[0-9]+",
    fold="[0-9]+",
    along="[a-z_]+",


rule scatter_inputs:
    output:
        scattered="<results>/calibration/{interpretation}/scattered.csv",
    log:
        "<logs>/scatter_inputs/{interpretation}.log",
    resources:
        runtime=30,
    params:
        *sources_of("scatter_inputs.py"),
        *SOFTWARE,
        CLAIMS_TEXT,
        claims=CLAIMS,
        settings=lambda wildcards: SEARCHES.settings_of(wildcards.interpretation),
        parameters=settings["uncalibrated"],
    message:
        "Scatter inputs of {wildcards.interpretation}"
    script:
        "../scripts/scatter_inputs.py"


rule search_inputs:
    input:
        start=lambda wildcards: SEARCHES.starts(wildcards.interpretation),
    output:
        evaluations="<results>/calibration/{interpretation}/seed{seed}.csv",
    log:
        "<logs>/search_inputs/{interpretation}_{seed}.log",
    resources:
        runtime=30,
    params:
        *sources_of("search_inputs.py"),
        *SOFTWARE,
        CLAIMS_TEXT,
        claims=CLAIMS,
        settings=lambda wildcards: SEARCHES.settings_of(wildcards.interpretation),
        parameters=settings["uncalibrated"],
        seeds=lambda wildcards: [int(wildcards.seed)],
        fold=None,
    message:
        "Search inputs of {wildcards.interpretation}, seed {wildcards.seed}"
    script:
        "../scripts/search_inputs.py"


use rule search_inputs as search_fold with:
    input:
        start=lambda wildcards: SEARCHES.starts_of_fold(wildcards.interpretation, wildcards.fold),
    output:
        evaluations="<results>/calibration/{interpretation}/fold{fold}.csv",
    log:
        "<logs>/search_fold/{interpretation}_{fold}.log",
    params:
        seeds=SEEDS,
        fold=lambda wildcards: int(wildcards.fold),
    message:
        "Search inputs of {wildcards.interpretation} without fold {wildcards.fold}"


rule sample_fold:
    input:
        evaluations="<results>/calibration/{interpretation}/fold{fold}.csv",
    output:
        samples="<results>/calibration/{interpretation}/fold{fold}_samples.csv",
    log:
        "<logs>/sample_fold/{interpretation}_{fold}.log",
    resources:
        runtime=30,
    params:
        *sources_of("sample_fold.py"),
        *SOFTWARE,
        CLAIMS_TEXT,
        claims=CLAIMS,
        settings=lambda wildcards: SEARCHES.settings_of(wildcards.interpretation),
        parameters=settings["uncalibrated"],
    message:
        "Sample inputs of {wildcards.interpretation} without fold {wildcards.fold}"
    script:
        "../scripts/sample_fold.py"


rule profile_inputs:
    input:
        evaluations=lambda wildcards: SEARCHES.found(wildcards.interpretation)[0],
    output:
        profile="<results>/calibration/{interpretation}/profile_{along}.csv",
    log:
        "<logs>/profile_inputs/{interpretation}_{along}.log",
    resources:
        runtime=60,
    params:
        *sources_of("profile_inputs.py"),
        *SOFTWARE,
        CLAIMS_TEXT,
        claims=CLAIMS,
        settings=lambda wildcards: SEARCHES.settings_of(wildcards.interpretation),
        parameters=settings["uncalibrated"],
        levels=lambda wildcards: SEARCHES.levels(wildcards.interpretation, wildcards.along),
    message:
        "Profile of {wildcards.interpretation} along {wildcards.along}"
    script:
        "../scripts/profile_inputs.py"


rule summarise_inputs:
    input:
        evaluations=lambda wildcards: SEARCHES.found(wildcards.interpretation),
        folds=expand(f"{OF_INTERPRETATION}/fold{{fold}}.csv", fold=FOLDS),
    output:
        calibrated="<results>/calibration/{interpretation}.yaml",
    log:
        "<logs>/summarise_inputs/{interpretation}.log",
    params:
        *sources_of("summarise_inputs.py"),
        *SOFTWARE,
        CLAIMS_TEXT,
        claims=CLAIMS,
        settings=lambda wildcards: SEARCHES.settings_of(wildcards.interpretation),
    message:
        "Summarise {wildcards.interpretation}"
    script:
        "../scripts/summarise_inputs.py"


SUMMARISED = expand(
    "<results>/calibration/{interpretation}.yaml", interpretation=CALIBRATION["interpretations"]
)
SAMPLES = [
    f"<results>/calibration/{CALIBRATION['ensemble']['of']}/fold{fold}_samples.csv"
    for fold in FOLDS
]
PROFILES = [
    f"<results>/calibration/{each['of']}/profile_{each['along']}.csv"
    for each in CALIBRATION["profiles"]
]


rule choose_default:
    input:
        calibrated=SUMMARISED,
        samples=SAMPLES,
    output:
        chosen="<results>/calibration/chosen.json",
        ranking="<results>/calibration/ranking.csv",
    log:
        "<logs>/choose_default.log",
    params:
        *sources_of("choose_default.py"),
        *SOFTWARE,
        CLAIMS_TEXT,
        claims=CLAIMS,
        settings=CALIBRATION,
        parameters=settings["uncalibrated"],
    message:
        "Choose the default"
    script:
        "../scripts/choose_default.py"


# replaces the files of config/calibrated/ and, in the repository, src/thirdbody/calibrated.yaml
rule calibrate:
    input:
        calibrated=SUMMARISED,
        chosen="<results>/calibration/chosen.json",
        ranking="<results>/calibration/ranking.csv",
        profiles=PROFILES,
    output:
        adopted="<results>/calibration/adopted.txt",
    log:
        "<logs>/calibrate.log",
    localrule: True
    params:
        *sources_of("adopt_calibration.py"),
        kept=CALIBRATION["kept"],
        default=settings["calibrated"],
        base=settings["uncalibrated"],
    message:
        "Copy the calibrated inputs to config/calibrated"
    script:
        "../scripts/adopt_calibration.py"
