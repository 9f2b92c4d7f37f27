# The searches of the calibration: each is a job and stores its evaluations, so that an interruption loses
# nothing.


wildcard_constraints:
    seed="[0-9]+",
    fold="[0-9]+",


rule scatter_inputs:
    output:
        scattered="<results>/calibration/{interpretation}/scattered.csv",
    log:
        "<logs>/scatter_inputs/{interpretation}.log",
    conda:
        "../envs/thirdbody.yaml"
    resources:
        runtime=30,
    params:
        claims=configured("claims"),
        settings=settings_of,
        parameters=settings["uncalibrated"],
        sources=sources_of("scatter_inputs.py", config=["claims"]),
    message:
        "Evaluating scattered inputs of {wildcards.interpretation}"
    script:
        "../scripts/scatter_inputs.py"


rule search_inputs:
    input:
        start=start_of,
    output:
        evaluations="<results>/calibration/{interpretation}/seed{seed}.csv",
    log:
        "<logs>/search_inputs/{interpretation}_{seed}.log",
    conda:
        "../envs/thirdbody.yaml"
    resources:
        runtime=30,
    params:
        claims=configured("claims"),
        settings=settings_of,
        parameters=settings["uncalibrated"],
        seeds=lambda wildcards: [int(wildcards.seed)],
        fold=None,
        sources=sources_of("search_inputs.py", config=["claims"]),
    message:
        "Searching the inputs of {wildcards.interpretation} from seed {wildcards.seed}"
    script:
        "../scripts/search_inputs.py"


use rule search_inputs as search_fold with:
    output:
        evaluations="<results>/calibration/{interpretation}/fold{fold}.csv",
    log:
        "<logs>/search_fold/{interpretation}_{fold}.log",
    params:
        settings=settings_of,
        parameters=settings["uncalibrated"],
        seeds=SEEDS,
        claims=configured("claims"),
        fold=lambda wildcards: int(wildcards.fold),
        sources=sources_of("search_inputs.py", config=["claims"]),
    message:
        "Searching the inputs of {wildcards.interpretation} without the figures of fold {wildcards.fold}"


checkpoint shortlist:
    input:
        evaluations=expand(
            "<results>/calibration/{interpretation}/seed{seed}.csv",
            interpretation=SEARCHED_WIDELY,
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
