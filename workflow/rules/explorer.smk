# The explorer: a web page that shows the figures and evaluates the equations.


rule build_explorer:
    input:
        figures=expand("<results>/figures/{figure}.json", figure=SCENES),
        verdicts="<results>/claims/claims.json",
        departures="<results>/extracted/departures/verdicts.json",
        page=[
            project_file(path)
            for folder in ("web", "vendor")
            for path in sorted(PACKAGES.glob(f"chenhorng/page/{folder}/*.*"))
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
    params:
        *sources_of("build_explorer.py"),
        settings_text(INPUTS),
        settings_text(PAPER_TABLES),
        entries=INPUTS,
        tables=PAPER_TABLES,
        parameters=settings["parameters"],
        unknowns=settings["calibration"]["unknowns"],
        ensemble=settings["ensemble"],
    message:
        "Build the explorer"
    script:
        "../scripts/build_explorer.py"
