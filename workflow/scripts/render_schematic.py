"""Draw one schematic, to scale, from its sections; nothing is solved here."""

import matplotlib.style

from thirdbody.core.parameters import Parameters
from thirdbody.netcdf import read_plain
from thirdbody.notes import sizes_note
from chenhorng.figures.captions import caption
from chenhorng.figures.files import save
from chenhorng.figures.schematics import SCHEMATICS
from chenhorng.figures.sections import VARIABLES, condition_of, panels_of
from chenhorng.job_log import job

with job(snakemake) as output:
    figure = snakemake.wildcards.schematic
    sections = read_plain(snakemake.input.sections, VARIABLES)
    inputs = Parameters(**snakemake.params.parameters)
    given = [condition_of(section) for section in panels_of(sections)]
    layers = sorted({(each.particle_diameter, each.roughness) for each in given})
    notes = [f"{sizes_note(*layer, inputs)}." for layer in layers if layer[0] > 0.0]
    with matplotlib.style.context(snakemake.input.style, after_reset=True):
        save(
            SCHEMATICS[figure](sections),
            output.png.with_suffix(""),
            caption(figure, notes=notes),
        )
    print(f"{figure}: drawn")
