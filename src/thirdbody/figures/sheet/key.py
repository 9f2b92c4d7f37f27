"""The key of a figure: which line stands for what.

It is set here and not by matplotlib's legend, whose boxes take longer to arrange than the lines
of a panel take to draw.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from matplotlib import rcParams
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.transforms import Affine2D

from thirdbody.figures.sheet.panel import COLUMNS, KEY_INCHES, POINTS_PER_INCH

COLUMNS_BELOW = 7  # of curves in a strip below the panels
ROWS_BESIDE = 9  # in the free cell beside the last panel
LETTER_WIDTH = 0.6  # mean over the size of type
Entry = tuple[str, dict]  # text and properties of the line beside it


def draw_key(
    figure: Figure,
    title: str,
    conditions: str,
    curves: Sequence[Entry],
    marks: Sequence[Entry] = (),
) -> None:
    """Explain the lines of ``figure`` where its panels leave room.

    Parameters
    ----------
    figure : Figure
        One of ``panel_figure``.
    title : str
        What the curves differ in.
    conditions : str
        What they share; empty for nothing.
    curves, marks : sequence of (str, dict)
        Text and properties of the line of each entry, in order down the columns.
    """
    width, height = figure.get_size_inches() * POINTS_PER_INCH
    texts = [text for text in (title, conditions) if text]
    panels = len(figure.axes)
    if panels % COLUMNS:
        centre = 0.75 * width, 0.5 * height / math.ceil(panels / COLUMNS)
        entries, separator, lines = [*curves, *marks], "\n", len(texts)
        rows = math.ceil(len(entries) / math.ceil(len(entries) / ROWS_BESIDE))
        blocks = [_columns(entries, rows)]
    else:
        centre = 0.5 * width, 0.5 * KEY_INCHES * POINTS_PER_INCH
        separator, lines = ";  ", 1
        blocks = [_columns(curves, math.ceil(len(curves) / COLUMNS_BELOW)), *_rows(marks, width)]
    line = rcParams["legend.fontsize"] * (1.0 + rcParams["legend.labelspacing"])
    heights = [max(map(len, columns)) for columns in blocks]
    top = centre[1] + 0.5 * line * (sum(heights) + lines)
    points = Affine2D().scale(1.0 / POINTS_PER_INCH) + figure.dpi_scale_trans
    style = {"ha": "center", "va": "top", "fontsize": rcParams["legend.title_fontsize"]}
    figure.text(centre[0], top, separator.join(texts), transform=points, **style)
    place = top - line * (lines + 0.5)
    for columns, height in zip(blocks, heights, strict=True):
        _draw_columns(figure, columns, (centre[0], place), line, points)
        place -= line * height


def _columns(entries, rows):
    return [entries[first : first + rows] for first in range(0, len(entries), rows)]


def _rows(entries, width):
    """Rows of ``entries``, columns of one entry each, none wider than ``width``."""
    rows: list[list] = []
    space = _sizes()[2]
    for entry in entries:
        taken = sum(_width(column) + space for column in rows[-1]) if rows else width
        if taken + _width([entry]) > width:
            rows.append([])
        rows[-1].append([entry])
    return rows


def _sizes():
    """Of a handle, between it and its text, and between columns, in points."""
    names = ("handlelength", "handletextpad", "columnspacing")
    return [rcParams["legend.fontsize"] * rcParams[f"legend.{name}"] for name in names]


def _width(column):
    handle, pad, _ = _sizes()
    letters = max(len(text) for text, _ in column)
    return handle + pad + LETTER_WIDTH * rcParams["legend.fontsize"] * letters


def _draw_columns(figure, columns, start, line, points):
    """Columns of entries, centred about the x and down from the y of ``start``."""
    size = rcParams["legend.fontsize"]
    handle, pad, space = _sizes()
    widths = [_width(column) for column in columns]
    x = start[0] - 0.5 * (sum(widths) + space * (len(columns) - 1))
    style = {"va": "center_baseline", "fontsize": size, "transform": points}
    for column, width in zip(columns, widths, strict=True):
        for row, (text, look) in enumerate(column):
            y = start[1] - row * line
            ends = [x, x + 0.5 * handle, x + handle]
            figure.add_artist(Line2D(ends, [y] * 3, markevery=[1], transform=points, **look))
            figure.text(x + handle + pad, y, text, **style)
        x += width + space
