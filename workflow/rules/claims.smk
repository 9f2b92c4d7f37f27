# The verdicts drawn, and what it costs the other statements that a chief one holds.


rule render_claims:
    input:
        claims="<results>/claims/claims.csv",
        style=place_of("src/thirdbody/figures/paper.mplstyle"),
        modules=import_closure("workflow/scripts/render_claims.py"),
    output:
        multiext("<results>/figures/claims", svg=".svg", pdf=".pdf", csv=".csv", md=".md"),
        png=report("<results>/figures/claims.png", subcategory="Figures", **IN_REPORT),
    log:
        "<logs>/render_claims.log",
    benchmark:
        "<logs>/render_claims.tsv"
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    message:
        "Drawing the verdicts"
    script:
        "../scripts/render_claims.py"


rule render_fronts:
    input:
        calibrated=CALIBRATED,
        style=place_of("src/thirdbody/figures/paper.mplstyle"),
        modules=import_closure("workflow/scripts/render_fronts.py"),
    output:
        multiext("<results>/figures/fronts", svg=".svg", pdf=".pdf", csv=".csv", md=".md"),
        png=report("<results>/figures/fronts.png", subcategory="Figures", **IN_REPORT),
    log:
        "<logs>/render_fronts.log",
    benchmark:
        "<logs>/render_fronts.tsv"
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    params:
        default=Path(settings["calibrated"]).stem,
    message:
        "Drawing what each chief statement costs the others"
    script:
        "../scripts/render_fronts.py"
