# The verdict on every statement of the paper, and what the headline numbers that are missed would cost.

CALIBRATED = sorted(str(path) for path in Path(CONFIG, "calibrated").glob("*.yaml"))


rule judge_claims:
    input:
        claims=f"{CONFIG}/claims.yaml",
        inputs=f"{CONFIG}/inputs.yaml",
        default=settings["calibrated"],
        calibrated=CALIBRATED,
        earlier=f"{CONFIG}/earlier_predictions.yaml",
        templates=[project_file(f"src/thirdbody/study/claims.{kind}.j2") for kind in ("md", "html")],
        modules=modules_of("judge_claims.py"),
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
        settings=settings["calibration"],
        parameters=settings["uncalibrated"],
        laid_over=settings["inputs"],
    message:
        "Judging every statement of the paper"
    script:
        "../scripts/judge_claims.py"


rule render_claims:
    input:
        claims="<results>/claims/claims.csv",
        style=STYLE,
        modules=modules_of("render_claims.py"),
    output:
        multiext("<results>/figures/claims", svg=".svg", pdf=".pdf", csv=".csv", md=".md"),
        png=report(
            "<results>/figures/claims.png",
            caption="../report/product.rst",
            category="Statements",
            labels={"figure": "claims"},
        ),
    log:
        "<logs>/render_claims.log",
    conda:
        "../envs/thirdbody.yaml"
    message:
        "Drawing the verdicts"
    script:
        "../scripts/render_claims.py"


rule render_fronts:
    input:
        calibrated=CALIBRATED,
        style=STYLE,
        modules=modules_of("render_fronts.py"),
    output:
        multiext("<results>/figures/fronts", svg=".svg", pdf=".pdf", csv=".csv", md=".md"),
        png=report(
            "<results>/figures/fronts.png",
            caption="../report/product.rst",
            category="Statements",
            labels={"figure": "fronts"},
        ),
    log:
        "<logs>/render_fronts.log",
    conda:
        "../envs/thirdbody.yaml"
    params:
        default=Path(settings["calibrated"]).stem,
    message:
        "Drawing what each headline number costs the other statements"
    script:
        "../scripts/render_fronts.py"
