"""The one place that saves: three formats and the data drawn, with the same bytes every time."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from os import PathLike
from pathlib import Path

# the canvases that ``savefig`` takes for the formats below
import matplotlib.backends.backend_agg
import matplotlib.backends.backend_pdf
import matplotlib.backends.backend_svg  # noqa: F401
import numpy as np
from fontTools import subset
from matplotlib.figure import Figure
from numpy.typing import NDArray

from thirdbody.data.files import whole
from thirdbody.data.tables import DRAWN_POINTS
from thirdbody.figures.sheet.panel import NamedBars, NamedOutlines, NamedPoints, Panel

# what each format is saved with: no date or version, and PNG compressed where it costs little
OPTIONS = {
    "svg": {"metadata": {"Date": None}},
    "pdf": {"metadata": {"CreationDate": None}},
    "png": {"metadata": {"Software": None}, "pil_kwargs": {"compress_level": 1}},
}
# Tables that place the letters of a font.  In a drawing each letter has its place: matplotlib would
# cut them down to the letters used, which takes a third of the time of a figure, and never read them.
PLACING = ["GDEF", "GPOS", "GSUB", "MATH", "kern"]
SUFFIXES = tuple(f".{kind}" for kind in (*OPTIONS, "csv", "md"))


def save(figure: Figure, stem: str | PathLike, caption: str) -> None:
    """Write a figure in three formats, the data that it shows, and what stands below it.

    Parameters
    ----------
    figure : Figure
        A sheet whose axes are all ``Panel``.
    stem : path
        Path without its ending: ``.svg``, ``.pdf``, ``.png``, ``.csv`` and ``.md`` appear together.
    caption : str
        Text of the ``.md``.

    Raises
    ------
    OSError
        If there is no room or no right to write.
    """
    with (
        _fonts_without_placing(),
        whole(*(f"{stem}{suffix}" for suffix in SUFFIXES)) as (*drawings, data, text),
    ):
        for drawing, (kind, options) in zip(drawings, OPTIONS.items(), strict=True):
            figure.savefig(drawing, format=kind, **options)
        write_drawn_data(figure, data)
        Path(text).write_text(caption, encoding="utf-8")


@contextmanager
def _fonts_without_placing() -> Iterator[None]:
    """Have matplotlib cut down fonts that never had the tables ``PLACING``."""
    load = subset.load_font

    def load_font(*given, **options):
        font = load(*given, **options)
        for table in {*PLACING} & {*font.keys()}:
            del font[table]
        return font

    subset.load_font = load_font
    try:
        yield
    finally:
        subset.load_font = load


def write_drawn_data(figure: Figure, path: str | PathLike) -> None:
    """Write every drawn point as a row of ``DRAWN_POINTS``, in SI, with ten significant digits."""
    with open(path, "w", encoding="utf-8", newline="") as stream:
        stream.write(",".join(column.name for column in DRAWN_POINTS) + "\n")
        for panel in figure.axes:
            for label, points in drawn_points(panel):
                names = (panel.letter, label, panel.x_name, panel.y_name)
                letter, curve, x_name, y_name = map(_quoted, names)
                # all points of a curve in one step: one by one, numbers take long to write
                row = f"{letter},{curve},{x_name},%.10g,{y_name},%.10g\n"
                stream.write(row * len(points) % tuple(points.ravel().tolist()))


def _quoted(text: str) -> str:
    """``text`` as a field of a CSV file, within a format for numbers."""
    if any(letter in text for letter in ',"\n'):
        text = '"' + text.replace('"', '""') + '"'
    return text.replace("%", "%%")


def drawn_points(panel: Panel) -> Iterator[tuple[str, NDArray[np.float64]]]:
    """What a panel shows.

    Yields
    ------
    str, ndarray of shape (n, 2)
        Label and points of each artist that stands for data: lines, unless their label starts
        with an underscore, and what has names.
    """
    for line in panel.lines:
        if isinstance(line, NamedPoints):
            for name, point in zip(line.names, line.get_xydata(), strict=True):
                yield name, _known(point[np.newaxis])
        elif not line.get_label().startswith("_"):
            yield line.get_label(), _known(line.get_xydata())
    for outlines in panel.collections:
        if isinstance(outlines, NamedBars | NamedOutlines):
            for name, path in zip(outlines.names, outlines.get_paths(), strict=True):
                yield name, _known(path.vertices)


def _known(points):
    return points[np.isfinite(points).all(axis=1)]
