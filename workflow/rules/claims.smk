# The verdicts drawn, and the question whether the printed particle term can meet them together.

MAIN_READINGS = [
    f"config/calibrated/{sizes}_{plane}_{term}.yaml"
    for plane in ("offset", "plane")
    for sizes in ("uncentred", "centred", "gap_convolved")
    for term in ("full", "free")
]


rule render_claims:
    input:
        claims="results/claims/claims.csv",
        style="src/thirdbody/figures/paper.mplstyle",
        modules=import_closure("workflow/scripts/render_claims.py"),
    output:
        multiext("results/figures/claims", svg=".svg", pdf=".pdf", csv=".csv", md=".md"),
        png=report("results/figures/claims.png", caption="../report/figure.rst", category="Figures"),
    log:
        "logs/render_claims.log",
    benchmark:
        "logs/render_claims.tsv"
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    message:
        "Drawing the verdicts"
    script:
        "../scripts/render_claims.py"


rule judge_conflict:
    input:
        claims="config/claims.yaml",
        schemas=[
            "config/claims.schema.yaml",
            "config/conditions.schema.yaml",
            "config/calibrated.schema.yaml",
            "config/inputs.schema.yaml",
            "config/inputs.yaml",
        ],
        calibrated=MAIN_READINGS,
        modules=import_closure("workflow/scripts/judge_conflict.py"),
    output:
        table="results/claims/conflict.csv",
    log:
        "logs/judge_conflict.log",
    benchmark:
        "logs/judge_conflict.tsv"
    priority: 1
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    params:
        newtons=CALIBRATION["newtons"],
        parameters=settings["uncalibrated"],
    message:
        "Judging Figures 4, 6 and 11 under the printed and a free particle term"
    script:
        "../scripts/judge_conflict.py"


rule render_conflict:
    input:
        conflict="results/claims/conflict.csv",
        style="src/thirdbody/figures/paper.mplstyle",
        modules=import_closure("workflow/scripts/render_conflict.py"),
    output:
        multiext("results/figures/conflict", svg=".svg", pdf=".pdf", csv=".csv", md=".md"),
        png=report(
            "results/figures/conflict.png", caption="../report/figure.rst", category="Figures"
        ),
    log:
        "logs/render_conflict.log",
    benchmark:
        "logs/render_conflict.tsv"
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    message:
        "Drawing whether Figures 4, 6 and 11 can be met together"
    script:
        "../scripts/render_conflict.py"
