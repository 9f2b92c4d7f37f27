# The verdict on every statement of the paper, what carries the agreement, and what the ranges are worth.

PROFILES_TABLE = f"{CONFIG}/calibrated/profiles.csv"


rule judge_claims:
    input:
        templates=[
            project_file(f"src/chenhorng/claims/claims.{name}.j2")
            for name in ("md", "html", "macros")
        ],
    output:
        table="<results>/claims/claims.csv",
        coverage="<results>/extracted/coverage/all.csv",
        text="<results>/claims/claims.md",
        page=report(
            "<results>/claims/claims.html",
            caption="../report/claims.rst",
            category="Statements",
            labels={"table": "claims"},
        ),
        data="<results>/claims/claims.json",
    log:
        "<logs>/judge_claims.log",
    params:
        *sources_of("judge_claims.py"),
        *SOFTWARE,
        *CALIBRATED_TEXTS,
        CLAIMS_TEXT,
        claims=CLAIMS,
        default=settings["calibrated"],
        calibrated=CALIBRATED,
        settings=settings["calibration"],
        base=settings["uncalibrated"],
        parameters=settings["parameters"],
        ensemble=settings["ensemble"],
    message:
        "Judge the statements of the paper"
    script:
        "../scripts/judge_claims.py"


# statements of other papers, in config/held_out.yaml, which no search has seen; and statements of one's
# own, in config/NAME.yaml: snakemake -c2 results/claims/NAME.csv
rule judge_own_claims:
    output:
        table="<results>/claims/{name}.csv",
    log:
        "<logs>/judge_own_claims/{name}.log",
    wildcard_constraints:
        name="(?!claims\\b)\\w+",
    params:
        *sources_of("judge_own_claims.py"),
        *SOFTWARE,
        lambda wildcards: settings_text(f"{CONFIG}/{wildcards.name}.yaml", list),
        claims=f"{CONFIG}/{{name}}.yaml",
        newtons=settings["calibration"]["newtons"],
        parameters=settings["parameters"],
    message:
        "Judge the statements of {wildcards.name}"
    script:
        "../scripts/judge_own_claims.py"


# printed numbers beside computed ones, and the verdicts with departures from the print taken back
rule judge_departures:
    output:
        deviations="<results>/extracted/deviations/all.csv",
        departures="<results>/extracted/departures/all.csv",
        verdicts="<results>/extracted/departures/verdicts.json",
    log:
        "<logs>/judge_departures.log",
    params:
        *sources_of("judge_departures.py"),
        *SOFTWARE,
        CLAIMS_TEXT,
        claims=CLAIMS,
        settings=settings["calibration"],
        parameters=settings["parameters"],
    message:
        "Judge the statements without each departure from the print"
    script:
        "../scripts/judge_departures.py"


# how often the ranges are right about what their members have not seen
rule score_ranges:
    input:
        profiles=PROFILES_TABLE,
    output:
        coverage="<results>/extracted/coverage_of_sets/all.csv",
    log:
        "<logs>/score_ranges.log",
    params:
        *sources_of("score_ranges.py"),
        *SOFTWARE,
        *CALIBRATED_TEXTS,
        default=settings["calibrated"],
        conditions=settings["calibration"]["coverage"],
    message:
        "Score the ranges of the ensemble"
    script:
        "../scripts/score_ranges.py"


rule gather_profiles:
    input:
        profiles=PROFILES_TABLE,
    output:
        table="<results>/extracted/profiles/all.csv",
    log:
        "<logs>/gather_profiles.log",
    params:
        *sources_of("gather_profiles.py"),
    message:
        "Gather the profiles of the calibration"
    script:
        "../scripts/gather_profiles.py"


# apart from the pages of verdicts and from other sets of inputs: figures have the verdicts
rule judge_default:
    output:
        table="<results>/extracted/verdicts/all.csv",
    log:
        "<logs>/judge_default.log",
    params:
        *sources_of("judge_default.py"),
        *SOFTWARE,
        CLAIMS_TEXT,
        claims=CLAIMS,
        newtons=settings["calibration"]["newtons"],
        parameters=settings["parameters"],
    message:
        "Judge the statements with the default inputs alone"
    script:
        "../scripts/judge_default.py"


rule gather_printed:
    output:
        table="<results>/extracted/printed/all.csv",
    log:
        "<logs>/gather_printed.log",
    params:
        *sources_of("gather_printed.py"),
        CLAIMS_TEXT,
        claims=CLAIMS,
    message:
        "Gather the numbers that the paper prints"
    script:
        "../scripts/gather_printed.py"


# what follows from the digits of printed numbers, and what surfaces cannot be
rule judge_digits:
    input:
        ranking=f"{CONFIG}/calibrated/ranking.csv",
    output:
        apparent_area="<results>/extracted/apparent_area/all.csv",
        limits="<results>/extracted/limits/all.csv",
    log:
        "<logs>/judge_digits.log",
    params:
        *sources_of("judge_digits.py"),
        *SOFTWARE,
        PAPER_TABLES_TEXT,
        DIGITS_TEXT,
        tables=PAPER_TABLES,
        digits=DIGITS,
        interpretations=settings["calibration"]["interpretations"],
        parameters=settings["parameters"],
    message:
        "Judge the digits of printed numbers, and what surfaces cannot be"
    script:
        "../scripts/judge_digits.py"
