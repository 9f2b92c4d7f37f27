# Judgement: the verdict on every statement of the paper under the calibrated inputs.

CALIBRATED = sorted(str(path) for path in Path(CONFIG, "calibrated").glob("*.yaml"))


rule judge_claims:
    input:
        claims=f"{CONFIG}/claims.yaml",
        schemas=[
            place_of("config/claims.schema.yaml"),
            place_of("config/conditions.schema.yaml"),
            place_of("config/calibrated.schema.yaml"),
            place_of("config/inputs.schema.yaml"),
            f"{CONFIG}/inputs.yaml",
        ],
        default=settings["calibrated"],
        calibrated=CALIBRATED,
        modules=import_closure("workflow/scripts/judge_claims.py"),
    output:
        table="<results>/claims/claims.csv",
        text="<results>/claims/claims.md",
        page=report(
            "<results>/claims/claims.html",
            caption="../report/claims.rst",
            category=part_of_report,
            subcategory="Tables",
            labels={"title": "The paper's statements and their verdicts"},
        ),
        data="<results>/claims/claims.json",
    log:
        "<logs>/judge_claims.log",
    benchmark:
        "<logs>/judge_claims.tsv"
    priority: 1
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    params:
        settings=CALIBRATION,
        parameters=settings["uncalibrated"],
        laid_over=settings["inputs"],
    message:
        "Judging every statement of the paper"
    script:
        "../scripts/judge_claims.py"
