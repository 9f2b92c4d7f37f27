"""Draw the verdicts on all statements; nothing is solved here."""

import matplotlib.style

from chenhorng.claims.words import counts_sentence
from chenhorng.figures.captions import caption
from chenhorng.figures.claims import plot
from chenhorng.figures.products import save
from chenhorng.job_log import job
from chenhorng.tables import TABLES, read_csv

with job(snakemake) as output:
    rows = read_csv(snakemake.input.data, TABLES["claims"])
    with matplotlib.style.context(snakemake.input.style, after_reset=True):
        words = caption("claims", headline=[counts_sentence(rows)])
        save(plot(rows), output.png.with_suffix(""), words)
    print(f"{len(rows)} rows drawn")
