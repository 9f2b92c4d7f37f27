"""Draw the profiles of the objective; nothing is solved here."""

import matplotlib.style

from chenhorng.figures.captions import caption
from chenhorng.figures.products import save
from chenhorng.figures.profiles import plot
from chenhorng.job_log import job
from chenhorng.tables import TABLES, read_csv

with job(snakemake) as output:
    rows = read_csv(snakemake.input.data, TABLES["profiles"])
    with matplotlib.style.context(snakemake.input.style, after_reset=True):
        drawing = plot(rows, snakemake.params.acceptance)
        save(drawing, output.png.with_suffix(""), caption("profiles"))
    print(f"{len(rows)} rows drawn")
