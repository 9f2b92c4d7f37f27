"""Draw one panel of a figure, as wide as a column; nothing is solved here."""

import matplotlib.style

from chenhorng.figures.captions import caption
from chenhorng.figures.curve_figures import plot, read_inputs
from chenhorng.figures.products import save_pictures
from chenhorng.job_log import job

with job(snakemake) as output:
    figure, panel = snakemake.params.figure, snakemake.params.panel
    with matplotlib.style.context(snakemake.input.style, after_reset=True):
        drawing = plot(figure, **read_inputs(figure, snakemake.input), panel=panel)
        save_pictures(drawing, output.png.with_suffix(""), caption(figure, drawing.panels))
    print(f"{snakemake.wildcards.panel}: drawn")
