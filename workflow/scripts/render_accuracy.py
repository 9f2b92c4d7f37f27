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


def render(paths, style, stem, targets):
    """Draw the tables at ``paths`` as ``stem``.svg, .pdf, .png, .csv, .md, and write the ``targets``."""
    tables = {name: read_csv(path, TABLES[name]) for name, path in paths.items()}
    rows = target_rows(tables)
    with atomic_write(targets) as part:
        write_csv(part, rows, TABLES["targets"])
    with matplotlib.style.context(style, after_reset=True):
        save(plot(tables["errors"], tables["times"]), stem, caption("accuracy"))
    print(f"{sum(row['verdict'] == 'reached' for row in rows)} of {len(rows)} targets are reached")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        render(
            {name: snakemake.input[name] for name in MEASURED},
            snakemake.input.style,
            snakemake.output.png.removesuffix(".png"),
            snakemake.output.targets,
        )
