"""Draw a figure from the table of its name, or the fronts in calibrated files; nothing is solved here."""

from importlib import import_module
from pathlib import Path

import matplotlib.style

from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.data.tables import TABLES, read_csv
from thirdbody.figures.captions import caption
from thirdbody.figures.drawing import save
from thirdbody.job_log import logged

with logged(snakemake.log[0]):
    figure = snakemake.wildcards.summary
    if figure == "fronts":
        calibrated = snakemake.params.calibrated
        files = sorted(calibrated, key=lambda path: Path(path).stem != snakemake.params.default)
        fronts = [content for content in map(read_yaml, files) if content["fronts"]]
        claims = read_yaml(snakemake.params.claims, list)
        drawn = [fronts, {claim["id"]: claim["statement"] for claim in claims}]
    else:
        drawn = [read_csv(snakemake.input.data, TABLES[figure])]
    plot = import_module(f"thirdbody.figures.{figure}").plot
    with matplotlib.style.context(snakemake.input.style, after_reset=True):
        save(plot(*drawn), snakemake.output.png.removesuffix(".png"), caption(figure))
    print(f"{figure}: {len(drawn[0])} rows or files drawn")
