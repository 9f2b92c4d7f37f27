"""Draw the verdicts on the paper's statements; nothing is judged here."""

import matplotlib.style

from thirdbody.data.tables import TABLES, read_csv
from thirdbody.figures.captions import caption
from thirdbody.figures.claims import plot
from thirdbody.figures.drawing import save
from thirdbody.job_log import logged

with logged(snakemake.log[0]):
    rows = read_csv(snakemake.input.claims, TABLES["claims"])
    with matplotlib.style.context(snakemake.input.style, after_reset=True):
        save(plot(rows), snakemake.output.png.removesuffix(".png"), caption("claims"))
    print(f"{len(rows)} statements drawn")
