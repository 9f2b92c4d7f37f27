"""Draw the sensitivity of results to the unprinted inputs; nothing is solved here."""

import matplotlib.style

from thirdbody.data.tables import TABLES, read_csv
from thirdbody.figures.captions import caption
from thirdbody.figures.drawing import save
from thirdbody.figures.sensitivity import plot
from thirdbody.job_log import job

with job(snakemake) as output:
    rows = read_csv(snakemake.input.data, TABLES["sensitivity"])
    with matplotlib.style.context(snakemake.input.style, after_reset=True):
        save(plot(rows), output.png.with_suffix(""), caption("sensitivity"))
    print(f"{len(rows)} rows drawn")
