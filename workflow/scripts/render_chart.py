"""Draw a design chart from the atlas; nothing is solved here."""

import matplotlib.style

from thirdbody.atlas.catalogue import open_atlas
from thirdbody.atlas.charts import CHARTS, chart_panels
from thirdbody.figures.captions import caption
from thirdbody.figures.charts import plot
from thirdbody.figures.drawing import save
from thirdbody.job_log import logged


def render(chart, catalogue, charts, style, stem):
    """Draw ``chart`` in the ``style`` of a file, as ``stem``.svg, .pdf, .png, .csv, .md."""
    with open_atlas(catalogue) as atlas:
        panels = chart_panels(atlas, chart, charts)
    with matplotlib.style.context(style, after_reset=True):
        save(plot(CHARTS[chart], panels), stem, caption(chart))
    print(f"{chart}: {len(panels)} panels drawn")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        render(
            snakemake.wildcards.chart,
            snakemake.input.catalogue,
            snakemake.params.charts,
            snakemake.input.style,
            snakemake.output.png.removesuffix(".png"),
        )
