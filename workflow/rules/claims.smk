# The verdicts drawn.


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
