"""Draw one figure from its dataset; nothing is solved here."""

import json

import matplotlib.style

from chenhorng.figures.captions import caption, inputs_sentence
from chenhorng.figures.curve_figures import plot
from chenhorng.figures.findings import headline
from chenhorng.figures.products import save, write_wide
from chenhorng.job_log import job
from chenhorng.tables import TABLES, read_csv
from thirdbody.netcdf import read_plain
from thirdbody.plotting.marks import read_turning_points

with job(snakemake) as output:
    figure = snakemake.wildcards.scene
    windows = snakemake.input.windows
    ensemble_range = snakemake.input.ensemble_range
    data = read_plain(snakemake.input.dataset)
    points = read_turning_points(snakemake.input.turning_points)
    rows = read_csv(snakemake.input.printed, TABLES["printed"])
    numbers = [row for row in rows if row["figure"] == figure]
    ends = read_csv(windows, TABLES["tpca_windows"]) if windows else ()
    ranges = read_plain(ensemble_range) if ensemble_range else None
    notes = [inputs_sentence(data)]
    if ranges:
        notes.append(f"The ensemble has {len(json.loads(ranges.attrs['ensemble']))} members.")
    with matplotlib.style.context(snakemake.input.style, after_reset=True):
        drawing = plot(figure, data, points, ranges, numbers, ends)
        save(
            drawing,
            output.png.with_suffix(""),
            caption(figure, drawing.panels, data.attrs["title"], notes, headline(figure, data)),
        )
    write_wide(drawing.panels, output.wide)
    print(f"{figure}: drawn")
