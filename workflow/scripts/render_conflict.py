"""Draw whether Figures 4, 6 and 11 can be met together; nothing is judged here."""

import gc

import matplotlib.style

from thirdbody.data.files import logged
from thirdbody.data.tables import TABLES, read_csv
from thirdbody.figures.captions import caption_text
from thirdbody.figures.conflict import plot
from thirdbody.figures.sheet.saving import save


def render(conflict, style, stem):
    """Draw the rows of ``conflict`` in the ``style`` of a file, as ``stem``.svg, .pdf, ..."""
    rows = read_csv(conflict, TABLES["conflict"])
    with matplotlib.style.context(style, after_reset=True):
        drawn = plot(rows)
        save(drawn, stem, caption_text("conflict", drawn))
    print(f"{len(rows)} scores drawn")


if __name__ == "__main__":
    gc.freeze()  # what the imports made stays: looking for garbage in it takes long
    with logged(snakemake.log[0]):
        render(
            snakemake.input.conflict,
            snakemake.input.style,
            snakemake.output.png.removesuffix(".png"),
        )
