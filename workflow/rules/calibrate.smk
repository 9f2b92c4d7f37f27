# Calibration: `snakemake -c2 calibrate`, not part of the default run.  Each search for the
# unprinted inputs is a job that stores its evaluations; their results are sampled and summarised.
# The summary goes to config/calibrated/, which is kept in git and read by the default run.
CALIBRATION = settings["calibration"]
SEEDS = CALIBRATION["seeds"]
FOLDS = range(len(CALIBRATION["folds"]))
SEARCHED_WIDELY = [
    name for name, entry in CALIBRATION["interpretations"].items() if "nearby" not in entry
]


def settings_of(wildcards):
    """The settings for one interpretation, independent of the others."""
    names = [wildcards.interpretation, *nearby(wildcards)]
    return {
        **CALIBRATION,
        "interpretations": {name: CALIBRATION["interpretations"][name] for name in names},
    }


def nearby(wildcards):
    """The interpretation from whose best inputs that of a job is searched, if there is one."""
    entry = CALIBRATION["interpretations"][wildcards.interpretation]
    return [entry["nearby"]] if "nearby" in entry else []


def start_of(wildcards):
    """The files with the inputs from which a search starts."""
    for name in nearby(wildcards):
        if "fold" in wildcards.keys():
            return [f"<results>/calibration/{name}/fold{wildcards.fold}.csv"]
        return searches_of(name)
    return [f"<results>/calibration/{wildcards.interpretation}/scattered.csv"]


def searches_of(name):
    """The files of the searches over all statements of an interpretation."""
    seeds = SEEDS if name in shortlisted() else SEEDS[:1]
    return [f"<results>/calibration/{name}/seed{seed}.csv" for seed in seeds]


def shortlisted():
    chosen = checkpoints.shortlist.get().output.chosen
    return json.loads(Path(chosen).read_text(encoding="utf-8"))


def is_cross_validated(wildcards):
    """Whether an interpretation, or that from which its searches start, is on the shortlist."""
    name = wildcards.interpretation
    while "nearby" in CALIBRATION["interpretations"][name]:
        name = CALIBRATION["interpretations"][name]["nearby"]
    return name in shortlisted()


OF_INTERPRETATION = "<results>/calibration/{{interpretation}}"


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
        CLAIMS_TEXT,
        claims=CLAIMS,
        settings=settings_of,
        parameters=settings["uncalibrated"],
    message:
        "Scatter inputs of {wildcards.interpretation}"
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
        CLAIMS_TEXT,
        claims=CLAIMS,
        settings=settings_of,
        parameters=settings["uncalibrated"],
        seeds=lambda wildcards: [int(wildcards.seed)],
        fold=None,
    message:
        "Search inputs of {wildcards.interpretation}, seed {wildcards.seed}"
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
    message:
        "Search inputs of {wildcards.interpretation} without fold {wildcards.fold}"


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
    message:
        "Choose the shortlist"
    script:
        "../scripts/choose_shortlist.py"


rule sample_inputs:
    input:
        evaluations=lambda wildcards: searches_of(wildcards.interpretation),
    output:
        samples="<results>/calibration/{interpretation}/seed{seed}_samples.csv",
    log:
        "<logs>/sample_inputs/{interpretation}_{seed}.log",
    resources:
        runtime=30,
    params:
        *sources_of("sample_inputs.py"),
        *SOFTWARE,
        CLAIMS_TEXT,
        claims=CLAIMS,
        settings=settings_of,
        parameters=settings["uncalibrated"],
    message:
        "Sample inputs of {wildcards.interpretation}, seed {wildcards.seed}"
    script:
        "../scripts/sample_inputs.py"


rule summarise_inputs:
    input:
        evaluations=lambda wildcards: searches_of(wildcards.interpretation),
        samples=branch(
            is_cross_validated,
            then=expand(f"{OF_INTERPRETATION}/seed{{seed}}_samples.csv", seed=SEEDS),
        ),
        folds=branch(
            is_cross_validated, then=expand(f"{OF_INTERPRETATION}/fold{{fold}}.csv", fold=FOLDS)
        ),
    output:
        calibrated="<results>/calibration/{interpretation}.yaml",
    log:
        "<logs>/summarise_inputs/{interpretation}.log",
    params:
        *sources_of("summarise_inputs.py"),
        *SOFTWARE,
        CLAIMS_TEXT,
        claims=CLAIMS,
        settings=settings_of,
    message:
        "Summarise {wildcards.interpretation}"
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


# replaces the files of config/calibrated/
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
    params:
        *sources_of("adopt_calibration.py"),
        kept=CALIBRATION["kept"],
        default=settings["calibrated"],
        base=settings["uncalibrated"],
    message:
        "Copy the calibrated inputs to config/calibrated"
    script:
        "../scripts/adopt_calibration.py"
