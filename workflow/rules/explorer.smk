# The explorer: one page for a browser that shows the figures and evaluates the equations.  It waits
# for every figure: rules that it needs have priority, so that others run beside it at the end.

EXPLORER = sorted(
    str(path)
    for folder in ("page", "vendor")  # beside them lies bytecode, which comes and goes
    for path in Path(place_of(f"src/thirdbody/explorer/{folder}")).glob("*.*")
)


rule build_explorer:
    input:
        points=expand("<results>/figures/{figure}.csv", figure=CURVE_FIGURES),
        captions=expand("<results>/figures/{figure}.md", figure=CURVE_FIGURES),
        claims=f"{CONFIG}/claims.yaml",
        schemas=[
            place_of("config/claims.schema.yaml"),
            place_of("config/conditions.schema.yaml"),
            place_of("config/inputs.schema.yaml"),
            f"{CONFIG}/inputs.yaml",
        ],
        tables=f"{CONFIG}/paper_tables.yaml",
        verdicts="<results>/claims/claims.json",
        calibrated=CALIBRATED,
        page=EXPLORER,
        modules=import_closure("workflow/scripts/build_explorer.py"),
    output:
        page=report(
            "<results>/explorer/index.html",
            caption="../report/explorer.rst",
            category=part_of_report,
            labels={"title": "The explorer: figures, statements and the model itself"},
        ),
    log:
        "<logs>/build_explorer.log",
    benchmark:
        "<logs>/build_explorer.tsv"
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    params:
        parameters=settings["parameters"],
        calibration=CALIBRATION,
    message:
        "Building the explorer"
    script:
        "../scripts/build_explorer.py"
