"""Draw a figure from the table of its name; nothing is solved here."""

from importlib import import_module

import matplotlib.style

from thirdbody.data.tables import TABLES, read_csv
from thirdbody.figures.captions import caption
from thirdbody.figures.drawing import save
from thirdbody.job_log import logged

with logged(snakemake.log[0]):
    figure = snakemake.wildcards.summary
    rows = read_csv(snakemake.input.data, TABLES[figure])
    plot = import_module(f"thirdbody.figures.{figure}").plot
    with matplotlib.style.context(snakemake.input.style, after_reset=True):
        save(plot(rows), snakemake.output.png.removesuffix(".png"), caption(figure))
    print(f"{figure}: {len(rows)} rows drawn")
