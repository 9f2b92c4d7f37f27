# The atlas: `snakemake -c2 atlas`, not part of the default run.  A job solves some of the roughnesses
# for all inputs, once; all else is taken from its file.  An interruption loses the chunks under way.
import sys

from thirdbody.configuration.schema import read_valid

try:
    ATLAS = read_valid(settings["atlas"], "atlas")
except ValueError as error:
    sys.exit(f"{error}")
CHARTS = ["largest_particle", "least_viscosity"]


scattergather:
    atlas=ATLAS["chunks"],


rule solve_chunk:
    input:
        modules=import_closure("workflow/scripts/solve_chunk.py"),
    output:
        chunk="<results>/atlas/chunks/{scatteritem}.nc",
        cost="<results>/atlas/cost/{scatteritem}.csv",
    log:
        "<logs>/solve_chunk/{scatteritem}.log",
    benchmark:
        "<logs>/solve_chunk/{scatteritem}.tsv"
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    resources:
        runtime=30,
    params:
        axes=ATLAS["axes"],
        variables=ATLAS["variables"],
        rtol=ATLAS["rtol"],
        parameters=settings["parameters"],
        ensemble=settings["ensemble"],
    message:
        "Solving chunk {wildcards.scatteritem} of the atlas"
    script:
        "../scripts/solve_chunk.py"


rule catalogue_atlas:
    input:
        chunks=gather.atlas("<results>/atlas/chunks/{scatteritem}.nc"),
        cost=gather.atlas("<results>/atlas/cost/{scatteritem}.csv"),
        modules=import_closure("workflow/scripts/catalogue_atlas.py"),
    output:
        catalogue="<results>/atlas/catalogue.json",
        cost="<results>/atlas/cost.csv",
    log:
        "<logs>/catalogue_atlas.log",
    benchmark:
        "<logs>/catalogue_atlas.tsv"
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    message:
        "Cataloguing the atlas"
    script:
        "../scripts/catalogue_atlas.py"


rule extract_chart:
    input:
        catalogue="<results>/atlas/catalogue.json",
        chunks=gather.atlas("<results>/atlas/chunks/{scatteritem}.nc"),
        modules=import_closure("workflow/scripts/extract_chart.py"),
    output:
        rows="<results>/extracted/{chart}/all.csv",
    log:
        "<logs>/extract_chart/{chart}.log",
    benchmark:
        "<logs>/extract_chart/{chart}.tsv"
    wildcard_constraints:
        chart="|".join(CHARTS),
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    params:
        charts=ATLAS["charts"],
    message:
        "Reading {wildcards.chart} off the atlas"
    script:
        "../scripts/extract_chart.py"


rule render_chart:
    input:
        catalogue="<results>/atlas/catalogue.json",
        chunks=gather.atlas("<results>/atlas/chunks/{scatteritem}.nc"),
        style=place_of("src/thirdbody/figures/paper.mplstyle"),
        modules=import_closure("workflow/scripts/render_chart.py"),
    output:
        multiext("<results>/figures/{chart}", svg=".svg", pdf=".pdf", csv=".csv", md=".md"),
        png=report("<results>/figures/{chart}.png", subcategory="Figures", **IN_REPORT),
    log:
        "<logs>/render_chart/{chart}.log",
    benchmark:
        "<logs>/render_chart/{chart}.tsv"
    wildcard_constraints:
        chart="|".join(CHARTS),
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    params:
        charts=ATLAS["charts"],
    message:
        "Drawing {wildcards.chart}"
    script:
        "../scripts/render_chart.py"


use rule write_table as write_chart_table with:
    input:
        parts=["<results>/extracted/{table}/all.csv"],
        printed=[],
        modules=import_closure("workflow/scripts/write_table.py"),
    log:
        "<logs>/write_chart_table/{table}.log",
    benchmark:
        "<logs>/write_chart_table/{table}.tsv"
    wildcard_constraints:
        table="|".join(CHARTS),


rule atlas:
    input:
        "<results>/atlas/catalogue.json",
        "<results>/atlas/cost.csv",
        expand(
            "<results>/figures/{chart}{kind}",
            chart=CHARTS,
            kind=[".svg", ".pdf", ".png", ".csv", ".md"],
        ),
        expand(
            "<results>/tables/{chart}{kind}",
            chart=CHARTS,
            kind=[".csv", ".json", ".md", ".html", ".tex"],
        ),
    message:
        "All of the atlas is made"
