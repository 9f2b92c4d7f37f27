# The explorer: a web page that shows the figures and evaluates the equations.


rule build_explorer:
    input:
        points=expand("<results>/figures/{figure}.csv", figure=SCENES),
        captions=expand("<results>/figures/{figure}.md", figure=SCENES),
        claims=f"{CONFIG}/claims.yaml",
        inputs=f"{CONFIG}/inputs.yaml",
        tables=f"{CONFIG}/paper_tables.yaml",
        verdicts="<results>/claims/claims.json",
        calibrated=CALIBRATED,
        page=[
            project_file(path)
            for folder in ("page", "vendor")
            for path in sorted(PACKAGE.glob(f"explorer/{folder}/*.*"))
        ],
    output:
        page=report(
            "<results>/explorer/index.html",
            caption="../report/explorer.rst",
            category="Explorer",
            labels={"page": "explorer"},
        ),
    log:
        "<logs>/build_explorer.log",
    conda:
        "../envs/thirdbody.yaml"
    params:
        parameters=settings["parameters"],
        calibration=settings["calibration"],
        ensemble=settings["ensemble"],
        sources=sources_of("build_explorer.py"),
    message:
        "Building the explorer"
    script:
        "../scripts/build_explorer.py"
