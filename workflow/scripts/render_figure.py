"""Draw one figure from its dataset; nothing is solved here."""

import matplotlib.style

from thirdbody.data.netcdf import read_dataset
from thirdbody.data.tables import TABLES, read_csv
from thirdbody.figures.captions import caption_text
from thirdbody.figures.marks import read_turning_points
from thirdbody.figures.printed import read_printed
from thirdbody.figures.registry import curve_figure
from thirdbody.figures.sheet.saving import save
from thirdbody.job_log import logged


def render(figure, dataset, turning_points, printed, windows, style, stem, band):
    """Draw ``figure`` in the ``style`` of a file, as ``stem``.svg, .pdf, .png, .csv and .md.

    ``printed`` is the file of the numbers that the paper prints, ``windows`` that of the windows
    of the turning point, and ``band`` that of the envelope around the curves; the last two may be
    empty for none.
    """
    data = read_dataset(dataset)
    points = read_turning_points(turning_points)
    numbers = read_printed(printed, figure)
    ends = read_csv(windows, TABLES["tpca_windows"]) if windows else ()
    envelope = read_dataset(band) if band else None
    with matplotlib.style.context(style, after_reset=True):
        drawn = curve_figure(figure, data).plot(data, points, envelope, numbers, ends)
        save(drawn, stem, caption_text(figure, drawn, data))
    print(f"{figure}: drawn")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        render(
            snakemake.wildcards.figure,
            snakemake.input.dataset,
            snakemake.input.turning_points,
            snakemake.input.printed,
            snakemake.input.windows,
            snakemake.input.style,
            snakemake.output.png.removesuffix(".png"),
            snakemake.input.band,
        )
