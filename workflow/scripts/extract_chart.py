"""Extract the table of a design chart from the atlas; nothing is solved here."""

from thirdbody.atlas.catalogue import chart_panels, chart_rows, open_atlas
from thirdbody.data.files import atomic_write
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged

with logged(snakemake.log[0]):
    chart = snakemake.wildcards.chart
    charts = snakemake.params.charts
    with open_atlas(snakemake.input.catalogue) as atlas:
        rows = chart_rows(chart_panels(atlas, chart, charts), charts["load_N"])
        with atomic_write(snakemake.output.rows) as part:
            write_csv(part, rows, TABLES[chart])
