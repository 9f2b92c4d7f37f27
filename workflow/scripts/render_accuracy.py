"""Draw errors against times, and compare what was measured with the targets; nothing is measured here."""

import matplotlib.style

from benchmarks.targets import target_rows
from thirdbody.data.files import atomic_write
from thirdbody.data.tables import TABLES, read_csv, write_csv
from thirdbody.figures.accuracy import plot
from thirdbody.figures.captions import caption
from thirdbody.figures.drawing import save
from thirdbody.job_log import logged

MEASURED = "errors", "extremes", "oracle", "times", "uses"

with logged(snakemake.log[0]):
    tables = {name: read_csv(snakemake.input[name], TABLES[name]) for name in MEASURED}
    rows = target_rows(tables)
    with atomic_write(snakemake.output.targets) as part:
        write_csv(part, rows, TABLES["targets"])
    with matplotlib.style.context(snakemake.input.style, after_reset=True):
        save(
            plot(tables["errors"], tables["times"]),
            snakemake.output.png.removesuffix(".png"),
            caption("accuracy"),
        )
    print(f"{sum(row['verdict'] == 'reached' for row in rows)} of {len(rows)} targets are reached")
