# Rendering: figures with the data drawn, tables in five formats.  Nothing is solved here: what is
# drawn was computed by the rules of datasets.smk.

from thirdbody.run.report import label_in_report, part_of_report

CURVE_FIGURES = sorted(name for name in settings["scenes"] if name.startswith("fig"))
WINDOW_FIGURES = ["fig09", "fig10"]  # those that show where turning points occur
BESIDE_PRINTED = ["tpca_loads", "tpca_windows", "transitions"]  # the paper's numbers
TABLE_PARTS = {
    "tpca_loads": CURVE_FIGURES,
    "transitions": CURVE_FIGURES,
    "tpca_windows": ["all"],
    "table1": ["all"],
    "table2": ["all"],
    "sensitivity": ["elasticities", "sobol_indices"],
}
IN_REPORT = {
    "caption": "../report/product.rst",
    "category": part_of_report,
    "labels": label_in_report,
}


rule render_figure:
    input:
        dataset="<results>/datasets/{figure}.nc",
        turning_points="<results>/extracted/tpca_loads/{figure}.csv",
        printed="<results>/extracted/printed/all.csv",
        windows=lambda wildcards: (
            "<results>/extracted/tpca_windows/all.csv"
            if wildcards.figure in WINDOW_FIGURES
            else []
        ),
        band=branch(settings["bands"], then="<results>/bands/{figure}.nc", otherwise=[]),
        style=place_of("src/thirdbody/figures/paper.mplstyle"),
        modules=import_closure("workflow/scripts/render_figure.py"),
    output:
        multiext("<results>/figures/{figure}", svg=".svg", pdf=".pdf", csv=".csv", md=".md"),
        png=report("<results>/figures/{figure}.png", subcategory="Figures", **IN_REPORT),
    log:
        "<logs>/render_figure/{figure}.log",
    benchmark:
        "<logs>/render_figure/{figure}.tsv"
    wildcard_constraints:
        figure="|".join(settings["scenes"]),
    priority: 1
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    message:
        "Drawing {wildcards.figure}"
    script:
        "../scripts/render_figure.py"


rule render_schematic:
    input:
        sections="<results>/schematics/{figure}.nc",
        style=place_of("src/thirdbody/figures/paper.mplstyle"),
        modules=import_closure("workflow/scripts/render_schematic.py"),
    output:
        multiext("<results>/figures/{figure}", svg=".svg", pdf=".pdf", csv=".csv", md=".md"),
        png=report("<results>/figures/{figure}.png", subcategory="Figures", **IN_REPORT),
    log:
        "<logs>/render_schematic/{figure}.log",
    benchmark:
        "<logs>/render_schematic/{figure}.tsv"
    wildcard_constraints:
        figure="|".join(settings["schematics"]),
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    message:
        "Drawing {wildcards.figure}"
    script:
        "../scripts/render_schematic.py"


rule write_table:
    input:
        parts=lambda wildcards: expand(
            "<results>/extracted/{table}/{part}.csv",
            table=wildcards.table,
            part=TABLE_PARTS[wildcards.table],
        ),
        printed=lambda wildcards: (
            "<results>/extracted/printed/all.csv" if wildcards.table in BESIDE_PRINTED else []
        ),
        modules=import_closure("workflow/scripts/write_table.py"),
    output:
        multiext("<results>/tables/{table}", csv=".csv", json=".json", md=".md", tex=".tex"),
        html=report("<results>/tables/{table}.html", subcategory="Tables", **IN_REPORT),
    log:
        "<logs>/write_table/{table}.log",
    benchmark:
        "<logs>/write_table/{table}.tsv"
    wildcard_constraints:
        table="|".join(TABLE_PARTS),
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    params:
        parameters=settings["parameters"],
    message:
        "Writing table {wildcards.table}"
    script:
        "../scripts/write_table.py"


# the same tables for a scene of one's own: mine_tpca_loads, mine_transitions
use rule write_table as write_scene_table with:
    input:
        parts=["<results>/extracted/{table}/{figure}.csv"],
        printed=[],
        modules=import_closure("workflow/scripts/write_table.py"),
    output:
        multiext(
            "<results>/tables/{figure}_{table}",
            csv=".csv",
            json=".json",
            md=".md",
            html=".html",
            tex=".tex",
        ),
    log:
        "<logs>/write_scene_table/{figure}_{table}.log",
    benchmark:
        "<logs>/write_scene_table/{figure}_{table}.tsv"
    wildcard_constraints:
        figure="(?!fig)[a-z][a-z0-9_]*",
        table="tpca_loads|transitions",
    message:
        "Writing table {wildcards.table} of {wildcards.figure}"


rule write_solver_cost:
    input:
        parts=expand("<results>/accuracy/solver_cost/{figure}.csv", figure=CURVE_FIGURES),
        modules=import_closure("workflow/scripts/write_solver_cost.py"),
    output:
        table="<results>/accuracy/solver_cost.csv",
    log:
        "<logs>/write_solver_cost.log",
    benchmark:
        "<logs>/write_solver_cost.tsv"
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    message:
        "Gathering what solving cost"
    script:
        "../scripts/write_solver_cost.py"
