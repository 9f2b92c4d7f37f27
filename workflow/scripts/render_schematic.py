"""Draw one schematic, true to scale, from its sections; nothing is solved here."""

import matplotlib.style

from thirdbody.figures.captions import caption
from thirdbody.figures.drawing import save
from thirdbody.figures.schematics import SCHEMATICS
from thirdbody.figures.sections import read_sections
from thirdbody.job_log import logged

with logged(snakemake.log[0]):
    figure = snakemake.wildcards.schematic
    with matplotlib.style.context(snakemake.input.style, after_reset=True):
        save(
            SCHEMATICS[figure](read_sections(snakemake.input.sections)),
            snakemake.output.png.removesuffix(".png"),
            caption(figure),
        )
    print(f"{figure}: drawn")
