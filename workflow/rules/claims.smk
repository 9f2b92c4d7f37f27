# The verdict on every statement of the paper, and what carries the agreement.

CALIBRATED = sorted(str(path) for path in Path(CONFIG, "calibrated").glob("*.yaml"))
CALIBRATED_SUM = digest([*CALIBRATED, settings["calibrated"]])


rule judge_claims:
    input:
        templates=[project_file(f"src/thirdbody/study/claims.{kind}.j2") for kind in ("md", "html")],
    output:
        table="<results>/claims/claims.csv",
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
    conda:
        "../envs/thirdbody.yaml"
    params:
        claims=configured("claims"),
        default=settings["calibrated"],
        calibrated=CALIBRATED,
        settings=settings["calibration"],
        parameters=settings["uncalibrated"],
        laid_over=settings["inputs"],
        calibrated_sum=CALIBRATED_SUM,
        sources=sources_of("judge_claims.py", config=["claims", "inputs"]),
    message:
        "Evaluating every statement of the paper"
    script:
        "../scripts/judge_claims.py"


# printed numbers beside computed ones, and the verdicts with departures from the print taken back
rule judge_departures:
    output:
        deviations="<results>/extracted/deviations/all.csv",
        departures="<results>/extracted/departures/all.csv",
        verdicts="<results>/extracted/departures/verdicts.json",
    log:
        "<logs>/judge_departures.log",
    conda:
        "../envs/thirdbody.yaml"
    params:
        claims=configured("claims"),
        settings=settings["calibration"],
        parameters=settings["parameters"],
        sources=sources_of("judge_departures.py", config=["claims"]),
    message:
        "Evaluating the statements with departures from the print taken back"
    script:
        "../scripts/judge_departures.py"


# summary figures, and the data of each
SUMMARIES = {
    "claims": "<results>/claims/claims.csv",
    "sensitivity": "<results>/tables/sensitivity.csv",
}


rule render_summary:
    input:
        data=lambda wildcards: SUMMARIES[wildcards.summary],
        style=STYLE,
    output:
        **figure_files("{summary}", "Statements"),
    log:
        "<logs>/render_summary/{summary}.log",
    wildcard_constraints:
        summary="|".join(SUMMARIES),
    priority: SMALL
    conda:
        "../envs/thirdbody.yaml"
    params:
        sources=lambda wildcards: sources_of(
            "render_summary.py", f"thirdbody.figures.{wildcards.summary}"
        ),
    message:
        "Drawing {wildcards.summary}"
    script:
        "../scripts/render_summary.py"
