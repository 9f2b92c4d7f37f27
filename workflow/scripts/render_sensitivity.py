"""Draw the sensitivity of results to the unprinted inputs; nothing is solved here."""

import matplotlib.style

from chenhorng.figures.captions import caption
from chenhorng.figures.products import save
from chenhorng.figures.sensitivity import plot
from chenhorng.job_log import job
from chenhorng.tables import TABLES, read_csv
from thirdbody.files import read_yaml

with job(snakemake) as output:
    rows = read_csv(snakemake.input.data, TABLES["sensitivity"])
    entries = read_yaml(snakemake.params.entries)
    symbols = {name: entry["symbol"] for name, entry in entries.items()}
    with matplotlib.style.context(snakemake.input.style, after_reset=True):
        save(plot(rows, symbols), output.png.with_suffix(""), caption("sensitivity"))
    print(f"{len(rows)} rows drawn")
