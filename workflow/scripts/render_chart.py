"""Draw a design chart from the atlas; nothing is solved here."""

from pathlib import Path

import matplotlib.style

from thirdbody.paper.atlas.catalogue import CHARTS, chart_panels, open_atlas
from thirdbody.paper.figures.captions import caption
from thirdbody.paper.figures.charts import plot
from thirdbody.paper.figures.files import save
from thirdbody.paper.job_log import job

with job(snakemake) as output:
    chart = snakemake.wildcards.chart
    with open_atlas(Path(snakemake.input.chunks[0]).parent) as atlas:
        panels = chart_panels(atlas, chart, snakemake.params.charts)
    with matplotlib.style.context(snakemake.input.style, after_reset=True):
        save(plot(CHARTS[chart], panels), output.png.with_suffix(""), caption(chart))
    print(f"{chart}: {len(panels)} panels drawn")
