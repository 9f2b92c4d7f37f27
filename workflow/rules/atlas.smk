# The atlas: `snakemake -c2 atlas`, not part of the default run.  A job solves some of the roughnesses
# for all inputs; everything else is read from its file.  An interruption loses only the running chunks.

ATLAS = settings["atlas"]


wildcard_constraints:
    chart="|".join(CHARTS),


scattergather:
    atlas=ATLAS["chunks"],


rule solve_chunk:
    output:
        chunk="<results>/atlas/chunks/{scatteritem}.nc",
    log:
        "<logs>/solve_chunk/{scatteritem}.log",
    benchmark:
        "<logs>/solve_chunk/{scatteritem}.tsv"
    resources:
        runtime=30,
    params:
        *sources_of("solve_chunk.py"),
        *SOFTWARE,
        axes=ATLAS["axes"],
        variables=ATLAS["variables"],
        rtol=ATLAS["rtol"],
        parameters=settings["parameters"],
        ensemble=settings["ensemble"],
        version=lambda wildcards: version_of("atlas"),
    script:
        "../scripts/solve_chunk.py"


rule extract_chart:
    input:
        chunks=gather.atlas("<results>/atlas/chunks/{scatteritem}.nc"),
    output:
        rows="<results>/extracted/{chart}/all.csv",
    log:
        "<logs>/extract_chart/{chart}.log",
    params:
        *sources_of("extract_chart.py"),
        *SOFTWARE,
        charts=ATLAS["charts"],
    script:
        "../scripts/extract_chart.py"


rule render_chart:
    input:
        chunks=gather.atlas("<results>/atlas/chunks/{scatteritem}.nc"),
        style=STYLE,
    output:
        **figure_files("{chart}", "Atlas"),
    log:
        "<logs>/render_chart/{chart}.log",
    params:
        *sources_of("render_chart.py"),
        charts=ATLAS["charts"],
    script:
        "../scripts/render_chart.py"


rule atlas:
    input:
        expand("<results>/figures/{chart}.{kind}", chart=CHARTS, kind=FIGURE_KINDS),
        expand("<results>/tables/{chart}.{kind}", chart=CHARTS, kind=TABLE_KINDS),
