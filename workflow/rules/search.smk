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
    resources:
        runtime=30,
    params:
        *sources_of("scatter_inputs.py"),
        *SOFTWARE,
        settings_text(CLAIMS, list),
        claims=CLAIMS,
        settings=settings_of,
        parameters=settings["uncalibrated"],
    script:
        "../scripts/scatter_inputs.py"


rule search_inputs:
    input:
        start=start_of,
    output:
        evaluations="<results>/calibration/{interpretation}/seed{seed}.csv",
    log:
        "<logs>/search_inputs/{interpretation}_{seed}.log",
    resources:
        runtime=30,
    params:
        *sources_of("search_inputs.py"),
        *SOFTWARE,
        settings_text(CLAIMS, list),
        claims=CLAIMS,
        settings=settings_of,
        parameters=settings["uncalibrated"],
        seeds=lambda wildcards: [int(wildcards.seed)],
        fold=None,
    script:
        "../scripts/search_inputs.py"


use rule search_inputs as search_fold with:
    output:
        evaluations="<results>/calibration/{interpretation}/fold{fold}.csv",
    log:
        "<logs>/search_fold/{interpretation}_{fold}.log",
    params:
        seeds=SEEDS,
        fold=lambda wildcards: int(wildcards.fold),


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
    params:
        *sources_of("choose_shortlist.py"),
        within=CALIBRATION["shortlist"]["within"],
        most=CALIBRATION["shortlist"]["most"],
    script:
        "../scripts/choose_shortlist.py"
