"""Draw the sensitivities of results to unpublished inputs; nothing is solved here."""

import matplotlib.style

from thirdbody.data.tables import TABLES, read_csv
from thirdbody.figures.captions import caption
from thirdbody.figures.drawing import save
from thirdbody.figures.sensitivity import plot
from thirdbody.job_log import logged


def render(table, style, stem):
    """Draw the rows of ``table`` in the ``style`` of a file, as ``stem``.svg, .pdf, .png, .csv, .md."""
    rows = read_csv(table, TABLES["sensitivity"])
    with matplotlib.style.context(style, after_reset=True):
        save(plot(rows), stem, caption("sensitivity"))
    print(f"{len(rows)} rows drawn")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        render(
            snakemake.input.table,
            snakemake.input.style,
            snakemake.output.png.removesuffix(".png"),
        )
