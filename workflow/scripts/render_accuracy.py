"""Draw errors against times; nothing is measured here."""

from thirdbody.run.job import logged

import matplotlib.style

from thirdbody.data.tables import TABLES, read_csv
from thirdbody.figures.accuracy import plot
from thirdbody.figures.captions import caption
from thirdbody.figures.drawing import save


def render(errors, times, style, stem):
    """Draw both tables in the ``style`` of a file, as ``stem``.svg, .pdf, .png, .csv, .md."""
    tables = read_csv(errors, TABLES["errors"]), read_csv(times, TABLES["times"])
    with matplotlib.style.context(style, after_reset=True):
        save(plot(*tables), stem, caption("accuracy"))
    print(f"{len(tables[1])} points drawn")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        render(
            snakemake.input.errors,
            snakemake.input.times,
            snakemake.input.style,
            snakemake.output.png.removesuffix(".png"),
        )
