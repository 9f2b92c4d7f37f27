"""Read the rows of a design chart's table off the atlas; nothing is solved here."""

from thirdbody.atlas.catalogue import open_atlas
from thirdbody.atlas.charts import chart_panels, chart_rows
from thirdbody.data.files import atomic_write
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged


def extract(chart, catalogue, charts, place):
    """Write the rows of ``chart`` at the loads that the settings ``charts`` name."""
    with open_atlas(catalogue) as atlas:
        rows = chart_rows(chart_panels(atlas, chart, charts), charts["load_N"])
        with atomic_write(place) as part:
            write_csv(part, rows, TABLES[chart])


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        extract(
            snakemake.wildcards.chart,
            snakemake.input.catalogue,
            snakemake.params.charts,
            snakemake.output.rows,
        )
