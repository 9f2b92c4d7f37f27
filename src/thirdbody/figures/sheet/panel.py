"""Panels: axes with a letter, the names of what they show, and a frame that is cheap to draw.

matplotlib's own axes make several artists of every tick, which is most of the time that a figure
of curves takes; here the ticks of a side are two lines of markers and their labels plain text.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from string import ascii_uppercase

import numpy as np
from matplotlib import rcParams
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.markers import TICKDOWN, TICKRIGHT, TICKUP
from matplotlib.patches import PathPatch
from matplotlib.text import Text
from matplotlib.transforms import Affine2D
from numpy.typing import NDArray

from thirdbody.figures.scales import NEWTONS, SCALES, Scale
from thirdbody.figures.sheet.symbols import Symbol, outline

FURNITURE = "_furniture"  # label of artists that carry no data
TITLE_RISE = 4.0  # of titles above the axes, points
NEWTONS_RISE = 12.0  # what the ticks in newtons take of that room besides, points
POINTS_PER_INCH = 72.0
COLUMNS = 2
KEY_INCHES = 0.9  # strip below the panels that holds the key if they leave no cell free
# side of a panel: axis, place along the other axis, ticks inwards, how their labels stand
SIDES = {
    "bottom": ("x", 0.0, TICKUP, {"ha": "center", "va": "top"}),
    "top": ("x", 1.0, TICKDOWN, {"ha": "center", "va": "bottom"}),
    "left": ("y", 0.0, TICKRIGHT, {"ha": "right", "va": "center"}),
}


class NamedOutlines(PolyCollection):
    """Polygons with a name each, in one artist: cheaper than an artist for each."""

    def __init__(self, outlines: Sequence[NDArray], names: Sequence[str], **style):
        super().__init__(outlines, **style)
        self.names = names


class NamedBars(LineCollection):
    """Straight lines with a name each, in one artist: cheaper than an artist for each."""

    def __init__(self, bars: Sequence[Sequence[tuple]], names: Sequence[str], **style):
        super().__init__(bars, **style)
        self.names = names


class NamedPoints(Line2D):
    """Markers of one look with a name each, in one artist: cheaper than an artist for each."""

    def __init__(self, points: Sequence[tuple], names: Sequence[str], **style):
        super().__init__(*np.transpose(points), **{"linestyle": "none"} | style)
        self.names = names


class Panel(Axes):
    """Axes that show one variable against another under a letter.

    Parameters
    ----------
    figure : Figure
        The sheet; the panel still has to be added to it.
    box : tuple of float
        Left, bottom, width and height as shares of the sheet.
    letter : str
        Letter of the panel.
    x_name, y_name : str
        What its axes show, as the file of the drawn data names it.
    """

    def __init__(
        self,
        figure: Figure,
        box: tuple[float, float, float, float],
        letter: str,
        x_name: str,
        y_name: str,
    ):
        super().__init__(figure, box)
        self.letter, self.x_name, self.y_name, self.heading = letter, x_name, y_name, ""
        for part in (self.xaxis, self.yaxis, *self.spines.values()):
            part.set_visible(False)
        self.patch.set(edgecolor=rcParams["axes.edgecolor"], linewidth=rcParams["axes.linewidth"])

    def write(
        self,
        x: float,
        y: float,
        text: str,
        x_points: float = 0.0,
        y_points: float = 0.0,
        **style,
    ) -> Text:
        """Text at ``x``, ``y`` as fractions of the axes, moved by so many points."""
        width, height = self.bbox.size / self.figure.dpi * POINTS_PER_INCH
        style = {"transform": self.transAxes, "fontsize": rcParams["axes.titlesize"]} | style
        return self.text(x + x_points / width, y + y_points / height, text, **style)

    def add_title(self, title: str) -> None:
        """The letter of the panel and ``title`` beside it."""
        self.heading = title
        newtons = NEWTONS_RISE * (self.x_name == "load")
        above = {"y_points": TITLE_RISE + newtons, "va": "bottom"}
        self.write(0.0, 1.0, f"({self.letter})", color="black", **above)
        self.write(0.0, 1.0, title, x_points=20, **above)

    def add_outlines(self, outlines: Sequence[NDArray], names: Sequence[str], **style) -> None:
        """Polygons, arrays of shape (n, 2) in the units of the axes, with a name and a style each."""
        self.add_collection(NamedOutlines(outlines, names, **style), autolim=False)
        self.update_datalim(np.concatenate(outlines))

    def add_bars(
        self, bars: Sequence[Sequence[tuple]], names: Sequence[str], colour, **style
    ) -> None:
        """Straight lines from point to point in the units of the axes, with a name each."""
        self.add_collection(NamedBars(bars, names, colors=[colour], **style), autolim=False)
        self.update_datalim(np.concatenate(bars))

    def in_points(self, line: Line2D) -> NDArray[np.float64]:
        """Where ``line`` runs on the sheet once the panel has its frame, shape (n, 2), in points."""
        pixels = self.transData.transform(line.get_xydata())
        return pixels / self.figure.dpi * POINTS_PER_INCH

    def frame(self, newtons_per_load: float | None) -> None:
        """Scales, limits, ticks and labels for what has been drawn: call it last.

        Both variables must stand in ``SCALES``.  An axis of loads has its counterpart in newtons at
        the upper edge.

        Parameters
        ----------
        newtons_per_load : float or None
            F_t/F_t* [N]; None where it is not known, and the upper edge is left bare.
        """
        x, y = SCALES[self.x_name], SCALES[self.y_name]
        self._set_limits(x, y)
        self._draw_limit_lines(y)
        self._draw_ticks("bottom", *x.ticks(*self.get_xlim()))
        self._draw_ticks("left", *y.ticks(*self.get_ylim()))
        if x.name == "load" and newtons_per_load is not None:
            low, high = self.get_xlim()
            major, labels, minor = NEWTONS.ticks(low * newtons_per_load, high * newtons_per_load)
            self._draw_ticks("top", major / newtons_per_load, labels, minor / newtons_per_load)
        self._write_symbol(x.symbol, 0.5, 0.0, y_points=-22)
        self._write_symbol(y.symbol, 0.0, 0.5, x_points=-33, angle=90)

    def _write_symbol(self, symbol: Symbol, x, y, x_points=0.0, y_points=0.0, angle=0.0):
        """``symbol`` centred at ``x``, ``y`` as fractions of the axes, moved by so many points."""
        path = outline(symbol, rcParams["axes.labelsize"])
        middle = path.get_extents().get_points().mean(axis=0)
        place = (self.bbox.min + self.bbox.size * (x, y)) / self.figure.dpi * POINTS_PER_INCH
        points = Affine2D().translate(*-middle).rotate_deg(angle)
        points.translate(*(place + (x_points, y_points))).scale(1.0 / POINTS_PER_INCH)
        patch = PathPatch(path, facecolor=rcParams["axes.labelcolor"], linewidth=0)
        patch.set(transform=points + self.figure.dpi_scale_trans, clip_on=False)
        self.add_artist(patch)

    def _set_limits(self, x, y):
        (left, bottom), (right, top) = self.dataLim.get_points()
        left_positive, bottom_positive = self.dataLim.minpos
        self.set_xlim(x.ends(left_positive if x.logarithmic else left, right))
        self.set_ylim(y.ends(bottom_positive if y.logarithmic else bottom, top))
        self.set_xscale("log" if x.logarithmic else "linear")
        self.set_yscale("log" if y.logarithmic else "linear")

    def _draw_limit_lines(self, scale: Scale):
        """Thin lines at the limits of modes and regimes, which are named outside the right edge."""
        low, high = self.get_ylim()
        edges = np.clip((low, *scale.limits, high), low, high)
        line = {key: rcParams[f"grid.{key}"] for key in ("color", "linewidth", "linestyle")}
        for limit in scale.limits:
            if low < limit < high:
                self.axhline(limit, label=FURNITURE, zorder=1, **line)
                self._write_outside(limit, f"{limit / scale.unit:g}")
        for zone, bottom, top in zip(scale.zones, edges, edges[1:], strict=False):
            if bottom < top:
                self._write_outside(0.5 * (bottom + top), zone, rotation=270 * (len(zone) > 4))

    def _write_outside(self, y, text, **style):
        style |= {"fontsize": 0.8 * rcParams["ytick.labelsize"], "color": rcParams["text.color"]}
        self.text(1.012, y, text, transform=self.get_yaxis_transform(), va="center", **style)

    def _draw_ticks(self, side, major, labels, minor):
        axis, edge, marker, style = SIDES[side]
        transform = getattr(self, f"get_{axis}axis_transform")()
        for places, kind in ((major, "major"), (minor, "minor")):
            ends = np.full(len(places), edge)
            self.add_artist(
                Line2D(
                    *((places, ends) if axis == "x" else (ends, places)),
                    transform=transform,
                    linestyle="none",
                    marker=marker,
                    markersize=rcParams[f"{axis}tick.{kind}.size"],
                    markeredgewidth=rcParams["xtick.major.width"],
                    color=rcParams["axes.edgecolor"],
                    label=FURNITURE,
                )
            )
        width, height = self.bbox.size / self.figure.dpi * POINTS_PER_INCH
        pad = rcParams[f"{axis}tick.major.pad"] * (2.0 * edge - 1.0)  # outwards
        style |= {"fontsize": rcParams[f"{axis}tick.labelsize"], "transform": transform}
        for place, label in zip(major, labels, strict=True):
            if axis == "x":
                self.text(place, edge + pad / height, label, **style)
            else:
                self.text(edge + pad / width, place, label, **style)


def panel_figure(
    contents: Sequence[tuple[str, str]], edges: Mapping[str, float] | None = None
) -> Figure:
    """A sheet of empty panels, two abreast.

    The key takes the cell that an odd number of panels leaves free, or a strip below them.

    Parameters
    ----------
    contents : sequence of (str, str)
        ``x_name`` and ``y_name`` of each panel, in order.
    edges : Mapping, optional
        ``left``, ``right``, ``bottom`` and ``top`` of the axes as shares of a panel's cell, by
        default those of the style.
    """
    rows = math.ceil(len(contents) / COLUMNS)
    cell_width, cell_height = rcParams["figure.figsize"]
    strip = 0.0 if len(contents) % COLUMNS else KEY_INCHES
    height = rows * cell_height + strip
    figure = Figure(figsize=(COLUMNS * cell_width, height))
    sides = ("left", "right", "bottom", "top")
    edges = edges or {side: rcParams[f"figure.subplot.{side}"] for side in sides}
    for index, (x_name, y_name) in enumerate(contents):
        row, column = divmod(index, COLUMNS)
        box = (
            (column + edges["left"]) / COLUMNS,
            (strip + (rows - 1 - row + edges["bottom"]) * cell_height) / height,
            (edges["right"] - edges["left"]) / COLUMNS,
            (edges["top"] - edges["bottom"]) * cell_height / height,
        )
        figure.add_axes(Panel(figure, box, ascii_uppercase[index], x_name, y_name))
    return figure
