"""Draw one figure from its dataset; nothing is solved here."""

import json

import matplotlib.style

from chenhorng.figures.captions import caption, inputs_sentence
from chenhorng.figures.curve_figures import plot, read_inputs
from chenhorng.figures.findings import headline
from chenhorng.figures.products import save, write_wide
from chenhorng.job_log import job

with job(snakemake) as output:
    figure = snakemake.wildcards.scene
    given = read_inputs(figure, snakemake.input)
    data, ranges = given["data"], given["ensemble_range"]
    notes = [inputs_sentence(data)]
    if ranges:
        notes.append(f"The ensemble has {len(json.loads(ranges.attrs['ensemble']))} members.")
    said = headline(figure, data, given["windows"], given["verdicts"])
    with matplotlib.style.context(snakemake.input.style, after_reset=True):
        drawing = plot(figure, **given)
        words = caption(figure, drawing.panels, data.attrs["title"], notes, said)
        save(drawing, output.png.with_suffix(""), words)
    write_wide(drawing.panels, output.wide)
    print(f"{figure}: drawn")
