"""Draw one schematic, true to scale, from its sections; nothing is solved here."""

import matplotlib.style

from thirdbody.figures.captions import caption
from thirdbody.figures.drawing import save
from thirdbody.figures.schematics import SCHEMATICS
from thirdbody.figures.sections import read_sections
from thirdbody.job_log import logged


def render(figure, sections, style, stem):
    """Draw ``figure`` in the ``style`` of a file, as ``stem``.svg, .pdf, .png, .csv and .md."""
    with matplotlib.style.context(style, after_reset=True):
        save(SCHEMATICS[figure](read_sections(sections)), stem, caption(figure))
    print(f"{figure}: drawn")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        render(
            snakemake.wildcards.figure,
            snakemake.input.sections,
            snakemake.input.style,
            snakemake.output.png.removesuffix(".png"),
        )
