"""Draw a design chart from the atlas; nothing is solved here."""

import matplotlib.style

from thirdbody.atlas.catalogue import CHARTS, chart_panels, open_atlas
from thirdbody.figures.captions import caption
from thirdbody.figures.charts import plot
from thirdbody.figures.drawing import save
from thirdbody.job_log import logged

with logged(snakemake.log[0]):
    chart = snakemake.wildcards.chart
    with open_atlas(snakemake.input.catalogue) as atlas:
        panels = chart_panels(atlas, chart, snakemake.params.charts)
    with matplotlib.style.context(snakemake.input.style, after_reset=True):
        save(plot(CHARTS[chart], panels), snakemake.output.png.removesuffix(".png"), caption(chart))
    print(f"{chart}: {len(panels)} panels drawn")
