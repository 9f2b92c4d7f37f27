# Rendering: figures with their data, and tables in five formats.  Nothing is solved here.

TABLE_PARTS = {
    "tpca_loads": SCENES,
    "transitions": SCENES,
    "sensitivity": ["elasticities", "sobol_indices"],
}
BESIDE_PRINTED = ["tpca_loads", "tpca_windows", "transitions"]
PRINTED = "<results>/extracted/printed/all.csv"  # the numbers of the paper
WINDOWS = "<results>/extracted/tpca_windows/all.csv"


rule render_figure:
    input:
        dataset="<results>/datasets/{scene}.nc",
        turning_points="<results>/extracted/tpca_loads/{scene}.csv",
        printed=PRINTED,
        windows=lambda wildcards: WINDOWS if wildcards.scene in ("fig09", "fig10") else [],
        band=branch(settings["bands"], then="<results>/bands/{scene}.nc", otherwise=[]),
        style=STYLE,
    output:
        **figure_files("{scene}", "Figures"),
        wide="<results>/figures/{scene}_wide.csv",
    log:
        "<logs>/render_figure/{scene}.log",
    conda:
        "../envs/thirdbody.yaml"
    params:
        sources=sources_of("render_figure.py"),
    message:
        "Drawing {wildcards.scene}"
    script:
        "../scripts/render_figure.py"


rule render_schematic:
    input:
        sections="<results>/schematics/{schematic}.nc",
        style=STYLE,
    output:
        **figure_files("{schematic}", "Figures"),
    log:
        "<logs>/render_schematic/{schematic}.log",
    priority: SMALL
    conda:
        "../envs/thirdbody.yaml"
    params:
        parameters=settings["parameters"],
        sources=sources_of("render_schematic.py"),
    message:
        "Drawing {wildcards.schematic}"
    script:
        "../scripts/render_schematic.py"


rule write_table:
    input:
        parts=lambda wildcards: expand(
            "<results>/extracted/{table}/{part}.csv",
            table=wildcards.table,
            part=TABLE_PARTS.get(wildcards.table, "all"),
        ),
        printed=lambda wildcards: PRINTED if wildcards.table in BESIDE_PRINTED else [],
    output:
        multiext("<results>/tables/{table}", csv=".csv", json=".json", md=".md", tex=".tex"),
        html=report(
            "<results>/tables/{table}.html",
            caption="../report/product.rst",
            category="Tables",
            labels={"table": "{table}"},
        ),
    log:
        "<logs>/write_table/{table}.log",
    wildcard_constraints:
        table="|".join([*TABLES, *CHARTS]),
    priority: SMALL
    conda:
        "../envs/thirdbody.yaml"
    params:
        parameters=settings["parameters"],
        sources=sources_of("write_table.py"),
    message:
        "Writing table {wildcards.table}"
    script:
        "../scripts/write_table.py"


# the same tables for your own scene: mine_tpca_loads, mine_transitions
use rule write_table as write_scene_table with:
    input:
        parts=["<results>/extracted/{table}/{scene}.csv"],
        printed=[],
    output:
        multiext("<results>/tables/{scene}_{table}", csv=".csv", json=".json", md=".md", tex=".tex"),
        html="<results>/tables/{scene}_{table}.html",
    log:
        "<logs>/write_scene_table/{scene}_{table}.log",
    wildcard_constraints:
        table="tpca_loads|transitions",
    message:
        "Writing table {wildcards.table} of {wildcards.scene}"
