"""Draw the sensitivities of results to unpublished inputs; nothing is solved here."""

import matplotlib.style

from thirdbody.data.tables import TABLES, read_csv
from thirdbody.figures.captions import caption
from thirdbody.figures.drawing import save
from thirdbody.figures.sensitivity import plot
from thirdbody.job_log import logged

with logged(snakemake.log[0]):
    rows = read_csv(snakemake.input.table, TABLES["sensitivity"])
    with matplotlib.style.context(snakemake.input.style, after_reset=True):
        save(plot(rows), snakemake.output.png.removesuffix(".png"), caption("sensitivity"))
    print(f"{len(rows)} rows drawn")
