"""Draw one figure from its dataset; nothing is solved here."""

import matplotlib.style

from thirdbody.data.files import atomic_write
from thirdbody.data.netcdf import read_plain
from thirdbody.data.tables import TABLES, read_csv
from thirdbody.figures.captions import caption
from thirdbody.figures.drawing import save, write_wide
from thirdbody.figures.marks import read_turning_points
from thirdbody.figures.printed import read_printed
from thirdbody.figures.registry import curve_figure
from thirdbody.job_log import logged


def render(figure, dataset, turning_points, printed, windows, style, stem, wide, ensemble_range):
    """Draw ``figure`` in the ``style`` of a file, as ``stem``.svg, .pdf, .png, .csv and .md, and its curves as the
    table ``wide``.

    ``printed`` is the file of the numbers that the paper prints, ``windows`` that of the windows
    of the turning point, and ``ensemble_range`` that of the range around the curves; the last two
    may be empty for none.
    """
    data = read_plain(dataset)
    points = read_turning_points(turning_points)
    numbers = read_printed(printed, figure)
    ends = read_csv(windows, TABLES["tpca_windows"]) if windows else ()
    ranges = read_plain(ensemble_range) if ensemble_range else None
    with matplotlib.style.context(style, after_reset=True):
        drawing = curve_figure(figure, data).plot(data, points, ranges, numbers, ends)
        save(drawing, stem, caption(figure, drawing.panels, data.attrs["title"]))
    with atomic_write(wide) as part:
        write_wide(drawing.panels, part)
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
            snakemake.output.wide,
            snakemake.input.band,
        )
