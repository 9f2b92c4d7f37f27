"""Draw the verdicts on the paper's statements; nothing is judged here."""

import matplotlib.style

from thirdbody.data.tables import TABLES, read_csv
from thirdbody.figures.captions import caption
from thirdbody.figures.claims import plot
from thirdbody.figures.drawing import save
from thirdbody.job_log import logged


def render(claims, style, stem):
    """Draw the rows of ``claims`` in the ``style`` of a file, as ``stem``.svg, .pdf, .png, .csv, .md."""
    rows = read_csv(claims, TABLES["claims"])
    with matplotlib.style.context(style, after_reset=True):
        save(plot(rows), stem, caption("claims"))
    print(f"{len(rows)} statements drawn")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        render(
            snakemake.input.claims,
            snakemake.input.style,
            snakemake.output.png.removesuffix(".png"),
        )
