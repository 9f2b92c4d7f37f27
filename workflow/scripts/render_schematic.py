"""Draw one schematic: the interface at given conditions, solved here and true to scale."""

import gc

import matplotlib.style

from thirdbody.data.files import logged
from thirdbody.figures.registry import SCHEMATICS
from thirdbody.figures.saving import save
from thirdbody.model.parameters import Parameters


def render(figure, parameters, panels, style, stem):
    """Draw ``figure`` in the ``style`` of a file, as ``stem``.svg, .pdf, .png and .csv."""
    with matplotlib.style.context(style, after_reset=True):
        save(SCHEMATICS[figure](Parameters(**parameters), panels), stem)
    print(f"{figure}: drawn")


if __name__ == "__main__":
    gc.freeze()  # what the imports made stays: looking for garbage in it takes long
    with logged(snakemake.log[0]):
        render(
            snakemake.wildcards.figure,
            snakemake.params.parameters,
            snakemake.params.panels,
            snakemake.input.style,
            snakemake.output.png.removesuffix(".png"),
        )
