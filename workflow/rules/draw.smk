# Drawing: figures with their data, tables to read, the explorer, the index page, and the sums of
# all products.  Nothing is solved here.

PRINTED = "<results>/extracted/printed/all.csv"  # the numbers of the paper
VERDICTS = "<results>/extracted/verdicts/all.csv"
WINDOWS = "<results>/extracted/tpca_windows/all.csv"
OF_SCENES = ["tpca_loads", "transitions"]  # tables that gather a part of each figure
BESIDE_PRINTED = ["tpca_loads", "tpca_windows", "transitions"]
STYLE = project_file("src/thirdbody/plotting/paper.mplstyle")


rule render_figure:
    input:
        dataset="<results>/datasets/{scene}.nc",
        turning_points="<results>/extracted/tpca_loads/{scene}.csv",
        printed=PRINTED,
        verdicts=lambda wildcards: VERDICTS if wildcards.scene in SCENES else [],
        windows=lambda wildcards: WINDOWS if wildcards.scene in ("fig09", "fig10") else [],
        ensemble_range=branch(settings["bands"], then="<results>/bands/{scene}.nc", otherwise=[]),
        style=STYLE,
    output:
        **figure_files("{scene}", "Figures"),
        wide="<results>/figures/{scene}_wide.csv",
    log:
        "<logs>/render_figure/{scene}.log",
    params:
        *sources_of("render_figure.py"),
    message:
        "Draw {wildcards.scene}"
    script:
        "../scripts/render_figure.py"


FIGURES_OF_PANELS = [of[:-1] for of in PANELS.values()]


# the panels that show the findings of the paper, as wide as a column
rule render_panels:
    input:
        datasets=expand("<results>/datasets/{figure}.nc", figure=FIGURES_OF_PANELS),
        turning_points=expand(
            "<results>/extracted/tpca_loads/{figure}.csv", figure=FIGURES_OF_PANELS
        ),
        printed=PRINTED,
        ensemble_ranges=(
            expand("<results>/bands/{figure}.nc", figure=FIGURES_OF_PANELS)
            if settings["bands"]
            else []
        ),
        style=STYLE,
    output:
        **{
            f"{panel}_{kind}": f"<results>/figures/{panel}.{kind}"
            for panel in PANELS
            for kind in PICTURES
        },
    log:
        "<logs>/render_panels.log",
    params:
        *sources_of("render_panels.py"),
        panels=PANELS,
    message:
        "Draw the panels of the findings"
    script:
        "../scripts/render_panels.py"


rule draw_schematic:
    input:
        style=STYLE,
    output:
        **figure_files("{schematic}", "Figures"),
    log:
        "<logs>/draw_schematic/{schematic}.log",
    params:
        *sources_of("draw_schematic.py"),
        *SOFTWARE,
        panels=lookup(dpath="{schematic}", within=settings["schematics"]),
        parameters=settings["parameters"],
    message:
        "Draw {wildcards.schematic}"
    script:
        "../scripts/draw_schematic.py"


rule render_claims:
    input:
        data="<results>/claims/claims.csv",
        style=STYLE,
    output:
        **figure_files("claims", "Statements"),
    log:
        "<logs>/render_claims.log",
    params:
        *sources_of("render_claims.py"),
    message:
        "Draw the verdicts"
    script:
        "../scripts/render_claims.py"


rule render_sensitivity:
    input:
        data="<results>/tables/sensitivity.csv",
        style=STYLE,
    output:
        **figure_files("sensitivity", "Statements"),
    log:
        "<logs>/render_sensitivity.log",
    params:
        *sources_of("render_sensitivity.py"),
        INPUTS_TEXT,
        entries=INPUTS,
    message:
        "Draw the sensitivities"
    script:
        "../scripts/render_sensitivity.py"


rule render_profiles:
    input:
        data="<results>/tables/profiles.csv",
        style=STYLE,
    output:
        **figure_files("profiles", "Statements"),
    log:
        "<logs>/render_profiles.log",
    params:
        *sources_of("render_profiles.py"),
        acceptance=settings["calibration"]["acceptance"],
    message:
        "Draw the profiles of the objective"
    script:
        "../scripts/render_profiles.py"


rule write_table:
    input:
        parts=lambda wildcards: (
            ["<results>/claims/held_out.csv"]
            if wildcards.table == "held_out"
            else expand(
                "<results>/extracted/{table}/{part}.csv",
                table=wildcards.table,
                part=SCENES if wildcards.table in OF_SCENES else "all",
            )
        ),
        printed=lambda wildcards: PRINTED if wildcards.table in BESIDE_PRINTED else [],
        template=project_file("src/chenhorng/sheets.html"),
    output:
        csv="<results>/tables/{table}.csv",
        tex="<results>/tables/{table}.tex",
        html=report(
            "<results>/tables/{table}.html",
            caption="../report/product.rst",
            category="Tables",
            labels={"table": "{table}"},
        ),
    log:
        "<logs>/write_table/{table}.log",
    wildcard_constraints:
        table="|".join(TABLES),
    params:
        *sources_of("write_table.py"),
        parameters=settings["parameters"],
    message:
        "Write the table {wildcards.table}"
    script:
        "../scripts/write_table.py"


# the same tables for your own scene: mine_tpca_loads, mine_transitions
use rule write_table as write_scene_table with:
    input:
        parts=["<results>/extracted/{table}/{scene}.csv"],
        printed=[],
        template=project_file("src/chenhorng/sheets.html"),
    output:
        csv="<results>/tables/{scene}_{table}.csv",
        tex="<results>/tables/{scene}_{table}.tex",
        html="<results>/tables/{scene}_{table}.html",
    log:
        "<logs>/write_scene_table/{scene}_{table}.log",
    wildcard_constraints:
        table="|".join(OF_SCENES),


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
        INPUTS_TEXT,
        PAPER_TABLES_TEXT,
        entries=INPUTS,
        tables=PAPER_TABLES,
        parameters=settings["parameters"],
        unknowns=settings["calibration"]["unknowns"],
        ensemble=settings["ensemble"],
    message:
        "Build the explorer"
    script:
        "../scripts/build_explorer.py"


# measured by `snakemake -c2 accuracy`, and kept in the repository alone
PRECISION = [name for name in ["docs/work_precision.png"] if (HOME / name).is_file()]


rule write_index:
    input:
        figures=expand("<results>/figures/{figure}.json", figure=FIGURES),
        pictures=expand("<results>/figures/{figure}.png", figure=FIGURES),
        tables=expand("<results>/tables/{table}.html", table=TABLES),
        departures="<results>/tables/departures.csv",
        limits="<results>/tables/limits.csv",
        panels=expand("<results>/figures/{panel}.svg", panel=PANELS),
        verdicts="<results>/claims/claims.json",
        explorer="<results>/explorer/index.html",
        datasets=expand("<results>/datasets/{figure}.nc", figure=SCENES),
        precision=[project_file(name) for name in PRECISION],
        page_template=project_file("workflow/templates/index.html"),
        captions_template=project_file("workflow/templates/captions.md"),
    output:
        page="<results>/index.html",
        captions="<results>/captions.md",
    log:
        "<logs>/write_index.log",
    params:
        *sources_of("write_index.py"),
        findings=settings["findings"],
        scenes=SCENES,
    message:
        "Write the index page"
    script:
        "../scripts/write_index.py"


rule write_sums:
    input:
        [product for product in rules.all.input if not product.endswith("SHA256SUMS")],
    output:
        sums="<results>/SHA256SUMS",
    log:
        "<logs>/write_sums.log",
    params:
        *sources_of("write_sums.py"),
    message:
        "Write the sums of all products"
    script:
        "../scripts/write_sums.py"
