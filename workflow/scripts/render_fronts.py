"""Draw what it costs the other statements that one of them holds; nothing is solved here."""

from thirdbody.run.job import logged

from pathlib import Path

import matplotlib.style

from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.figures.captions import caption_text
from thirdbody.figures.fronts import plot
from thirdbody.figures.drawing import save


def render(default, calibrated, style, stem):
    """Draw the fronts of all ``calibrated`` readings, that of the file whose stem is ``default`` first."""
    files = sorted(calibrated, key=lambda path: Path(path).stem != default)
    readings = [read_yaml(path) for path in files]
    with matplotlib.style.context(style, after_reset=True):
        drawn = plot(readings)
        save(drawn, stem, caption_text("fronts", drawn))
    print(f"{len(readings)} readings drawn")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        render(
            snakemake.params.default,
            snakemake.input.calibrated,
            snakemake.input.style,
            snakemake.output.png.removesuffix(".png"),
        )
