"""Draw one schematic, true to scale, from its sections; nothing is solved here."""

import gc

import matplotlib.style

from thirdbody.data.files import logged
from thirdbody.data.schematic import read_sections
from thirdbody.figures.registry import SCHEMATICS
from thirdbody.figures.sheet.saving import save


def render(figure, sections, style, stem):
    """Draw ``figure`` in the ``style`` of a file, as ``stem``.svg, .pdf, .png and .csv."""
    with matplotlib.style.context(style, after_reset=True):
        save(SCHEMATICS[figure](read_sections(sections)), stem)
    print(f"{figure}: drawn")


if __name__ == "__main__":
    gc.freeze()  # what the imports made stays: looking for garbage in it takes long
    with logged(snakemake.log[0]):
        render(
            snakemake.wildcards.figure,
            snakemake.input.sections,
            snakemake.input.style,
            snakemake.output.png.removesuffix(".png"),
        )
