"""Draw what it costs the other statements that one of them holds; nothing is solved here."""

from pathlib import Path

import matplotlib.style

from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.figures.captions import caption
from thirdbody.figures.drawing import save
from thirdbody.figures.fronts import plot
from thirdbody.job_log import logged

with logged(snakemake.log[0]):
    files = sorted(
        snakemake.input.calibrated, key=lambda path: Path(path).stem != snakemake.params.default
    )
    contents = [read_yaml(path) for path in files]
    interpretations = [content for content in contents if content["fronts"]]
    with matplotlib.style.context(snakemake.input.style, after_reset=True):
        save(plot(interpretations), snakemake.output.png.removesuffix(".png"), caption("fronts"))
    print(f"{len(interpretations)} interpretations drawn")
