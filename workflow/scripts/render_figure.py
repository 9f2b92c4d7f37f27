"""Draw one figure from its dataset; nothing is solved here."""

import json

import matplotlib.style

from chenhorng.figures.captions import caption, inputs_sentence
from chenhorng.figures.curve_figures import plot, read_inputs
from chenhorng.figures.products import save, write_wide
from chenhorng.job_log import job

with job(snakemake) as output:
    figure = snakemake.wildcards.scene
    given = read_inputs(figure, snakemake.input)
    data, ranges = given["data"], given["ensemble_range"]
    area = json.loads(data.attrs["model_parameters"])["A_n"]
    notes = [inputs_sentence(data)]
    notes += [f"Newtons are for A_n = {1e6 * area:.3g} mm², which the paper does not print."]
    if ranges:
        notes.append(f"The ensemble has {len(json.loads(ranges.attrs['ensemble']))} members.")
    with matplotlib.style.context(snakemake.input.style, after_reset=True):
        drawing = plot(figure, **given)
        save(
            drawing,
            output.png.with_suffix(""),
            caption(figure, drawing.panels, data.attrs["title"], notes),
        )
    write_wide(drawing.panels, output.wide)
    print(f"{figure}: drawn")
