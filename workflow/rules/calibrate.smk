# Calibration: `snakemake -c2 calibrate`, not part of the default run. The results of the searches are sampled and
# summarised. The summary goes to config/calibrated/, which is kept in git and read by the default run.


rule sample_inputs:
    input:
        evaluations=lambda wildcards: searches_of(wildcards.interpretation),
    output:
        samples="<results>/calibration/{interpretation}/seed{seed}_samples.csv",
    log:
        "<logs>/sample_inputs/{interpretation}_{seed}.log",
    conda:
        "../envs/thirdbody.yaml"
    resources:
        runtime=30,
    params:
        claims=configured("claims"),
        settings=settings_of,
        parameters=settings["uncalibrated"],
        sources=sources_of("sample_inputs.py", config=["claims"]),
    message:
        "Sampling the inputs of {wildcards.interpretation} from seed {wildcards.seed}"
    script:
        "../scripts/sample_inputs.py"


rule summarise_inputs:
    input:
        evaluations=lambda wildcards: searches_of(wildcards.interpretation),
        samples=branch(
            is_cross_validated, then=expand(f"{FOUND}/seed{{seed}}_samples.csv", seed=SEEDS)
        ),
        folds=branch(is_cross_validated, then=expand(f"{FOUND}/fold{{fold}}.csv", fold=FOLDS)),
    output:
        calibrated="<results>/calibration/{interpretation}.yaml",
    log:
        "<logs>/summarise_inputs/{interpretation}.log",
    conda:
        "../envs/thirdbody.yaml"
    params:
        settings=settings_of,
        sources=sources_of("summarise_inputs.py"),
    message:
        "Summarising the calibration of {wildcards.interpretation}"
    script:
        "../scripts/summarise_inputs.py"


SUMMARISED = expand(
    "<results>/calibration/{interpretation}.yaml", interpretation=CALIBRATION["interpretations"]
)


rule choose_default:
    input:
        calibrated=SUMMARISED,
    output:
        chosen="<results>/calibration/chosen.json",
        ranking="<results>/calibration/ranking.csv",
    log:
        "<logs>/choose_default.log",
    conda:
        "../envs/thirdbody.yaml"
    params:
        claims=configured("claims"),
        settings=CALIBRATION,
        parameters=settings["uncalibrated"],
        sources=sources_of("choose_default.py", config=["claims"]),
    message:
        "Choosing the default and the ensemble of those equal to it"
    script:
        "../scripts/choose_default.py"


rule calibrate:
    input:
        calibrated=SUMMARISED,
        chosen="<results>/calibration/chosen.json",
        ranking="<results>/calibration/ranking.csv",
    output:
        adopted="<results>/calibration/adopted.txt",
    log:
        "<logs>/calibrate.log",
    localrule: True
    conda:
        "../envs/thirdbody.yaml"
    params:
        kept=CALIBRATION["kept"],
        sources=sources_of("adopt_calibration.py"),
    message:
        "Copying the calibrated inputs to config/calibrated"
    script:
        "../scripts/adopt_calibration.py"
