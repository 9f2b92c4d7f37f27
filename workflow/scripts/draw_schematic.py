"""Solve the interfaces of one schematic, and draw sections through them, to scale."""

import matplotlib.style

from chenhorng.figures.captions import caption
from chenhorng.figures.products import save
from chenhorng.figures.schematics import SCHEMATICS
from chenhorng.figures.sections import sections, state_of
from chenhorng.job_log import job
from thirdbody.core.parameters import Parameters
from thirdbody.core.solve import DEFAULT_RTOL, solve_points
from thirdbody.curves import Condition
from thirdbody.notes import sizes_note
from thirdbody.variables import VARIABLES

with job(snakemake) as output:
    figure, inputs = snakemake.wildcards.schematic, Parameters(**snakemake.params.parameters)
    conditions = [*map(Condition.of, snakemake.params.panels)]
    states = []
    for condition, panel in zip(conditions, snakemake.params.panels, strict=True):
        point = {"load": panel["load_N"] / inputs.newtons_per_load, **condition._asdict()}
        solved = solve_points(point, inputs, DEFAULT_RTOL, VARIABLES)
        states.append(state_of(condition, panel["load_N"], solved))
    layers = sorted({(each.particle_diameter, each.roughness) for each in conditions})
    texts = [sizes_note(*layer, inputs) for layer in layers if layer[0] > 0.0]
    notes = [f"{text[0].upper()}{text[1:]}." for text in texts]
    with matplotlib.style.context(snakemake.input.style, after_reset=True):
        drawing = SCHEMATICS[figure](sections(figure, states, inputs))
        save(drawing, output.png.with_suffix(""), caption(figure, notes=notes))
    print(f"{figure}: drawn")
