"""Draw the panels of the findings, each as wide as a column; nothing is solved here."""

from itertools import zip_longest
from types import SimpleNamespace

import matplotlib.style

from chenhorng.figures.captions import caption
from chenhorng.figures.curve_figures import plot, read_inputs
from chenhorng.figures.products import save_pictures
from chenhorng.job_log import job

with job(snakemake) as output:
    made = snakemake.input
    files = zip_longest(made.datasets, made.turning_points, made.ensemble_ranges)
    for (name, of), (dataset, points, ranges) in zip(snakemake.params.panels.items(), files):
        figure, panel = of[:-1], of[-1]
        given = SimpleNamespace(
            dataset=dataset,
            turning_points=points,
            ensemble_range=ranges,
            printed=made.printed,
            windows=None,
            verdicts=None,
        )
        with matplotlib.style.context(made.style, after_reset=True):
            drawing = plot(figure, **read_inputs(figure, given), panel=panel)
            stem = getattr(output, f"{name}_png").with_suffix("")
            save_pictures(drawing, stem, caption(figure, drawing.panels))
        print(f"{name}: drawn")
