"""Draw what it costs the other statements that one of them holds; nothing is solved here."""

from pathlib import Path

import matplotlib.style

from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.figures.captions import caption
from thirdbody.figures.drawing import save
from thirdbody.figures.fronts import plot
from thirdbody.job_log import logged


def render(default, calibrated, style, stem):
    """Draw the fronts of all ``calibrated`` interpretations, that of the file whose stem is ``default`` first."""
    files = sorted(calibrated, key=lambda path: Path(path).stem != default)
    contents = [read_yaml(path) for path in files]
    interpretations = [content for content in contents if content["fronts"]]
    with matplotlib.style.context(style, after_reset=True):
        save(plot(interpretations), stem, caption("fronts"))
    print(f"{len(interpretations)} interpretations drawn")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        render(
            snakemake.params.default,
            snakemake.input.calibrated,
            snakemake.input.style,
            snakemake.output.png.removesuffix(".png"),
        )
