# Judgement: the verdict on every statement of the paper under the calibrated inputs.

CALIBRATED = sorted(str(path) for path in Path("config/calibrated").glob("*.yaml"))


rule judge_claims:
    input:
        claims="config/claims.yaml",
        schemas=[
            "config/claims.schema.yaml",
            "config/conditions.schema.yaml",
            "config/calibrated.schema.yaml",
            "config/inputs.schema.yaml",
            "config/inputs.yaml",
        ],
        default=settings["calibrated"],
        calibrated=CALIBRATED,
        modules=import_closure("workflow/scripts/judge_claims.py"),
    output:
        table="results/claims/claims.csv",
        text="results/claims/claims.md",
        data="results/claims/verdicts.json",
    log:
        "logs/judge_claims.log",
    benchmark:
        "logs/judge_claims.tsv"
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
