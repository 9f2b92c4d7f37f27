"""Extract the table of a design chart from the atlas; nothing is solved here."""

from pathlib import Path

from thirdbody.paper.atlas.catalogue import chart_panels, chart_rows, open_atlas
from thirdbody.paper.job_log import job
from thirdbody.paper.tables import TABLES, write_csv

with job(snakemake) as output:
    chart = snakemake.wildcards.chart
    charts = snakemake.params.charts
    with open_atlas(Path(snakemake.input.chunks[0]).parent) as atlas:
        rows = chart_rows(chart_panels(atlas, chart, charts), charts["load_N"])
        write_csv(output.rows, rows, TABLES[chart])
