"""Panels: axes with a letter, the names of what they show, and a frame that is cheap to draw.

matplotlib's own axes make several artists of every tick, which is most of the time that a figure
of curves takes; here the ticks of a side are two lines of markers and their labels plain text.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from string import ascii_uppercase

import numpy as np
from matplotlib import rcParams
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.markers import TICKRIGHT, TICKUP
from matplotlib.patches import PathPatch
from matplotlib.ticker import MaxNLocator
from matplotlib.transforms import Affine2D

from thirdbody.figures.sheet.symbols import Symbol, outline
from thirdbody.model.regimes import BOUNDARY_LIMIT, FULL_FILM_LIMIT, PARTICLE_LIMIT, SURFACE_LIMIT

FURNITURE = "_furniture"  # label of artists that carry no data
POINTS_PER_INCH = 72.0
COLUMNS = 2
KEY_INCHES = 0.75  # strip below the panels that holds the key if they leave no cell free
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


@dataclass(frozen=True)
class Quantity:
    """How a variable of the datasets appears on an axis.

    ``unit`` is what the tick labels count in; a ``share`` runs from 0 to 1 where its curves do;
    ``limits`` divide it into ``zones``, both from below.
    """

    name: str
    symbol: Symbol
    logarithmic: bool = False
    unit: float = 1.0
    share: bool = False
    limits: tuple[float, ...] = ()
    zones: tuple[str, ...] = ()


QUANTITIES = {
    "load": Quantity("Dimensionless normal load", Symbol("F", "t", starred=True), logarithmic=True),
    "total_contact_area": Quantity(
        "Real contact area", Symbol("A", "t", starred=True), logarithmic=True
    ),
    "particle_contact_area_ratio": Quantity(
        "Contact area ratio of particles",
        Symbol("A", "sa,t", starred=True),
        share=True,
        limits=(SURFACE_LIMIT, PARTICLE_LIMIT),
        zones=("s-s", "hybrid", "p-s"),
    ),
    "solid_load_fraction": Quantity(
        "Load percentage of solid",
        Symbol("L", "s", unit="%"),
        unit=0.01,
        share=True,
        limits=(FULL_FILM_LIMIT, BOUNDARY_LIMIT),
        zones=("F.L.", "M.L.", "B.L."),
    ),
    "film_thickness": Quantity("Film thickness", Symbol("H", "c", unit="10⁻⁴"), unit=1e-4),
}


class NamedOutlines(PolyCollection):
    """Polygons with a name each, in one artist: cheaper than an artist for each."""

    def __init__(self, outlines, names, **style):
        super().__init__(outlines, **style)
        self.names = names


class NamedPoints(Line2D):
    """Markers of one look with a name each, in one artist: cheaper than an artist for each."""

    def __init__(self, points, names, **style):
        super().__init__(*np.transpose(points), linestyle="none", **style)
        self.names = names


class Panel(Axes):
    """Axes that show the variable ``y_name`` against ``x_name`` under a ``letter``."""

    def __init__(self, figure, box, letter, x_name, y_name):
        super().__init__(figure, box)
        self.letter, self.x_name, self.y_name = letter, x_name, y_name
        for part in (self.xaxis, self.yaxis, *self.spines.values()):
            part.set_visible(False)
        self.patch.set(edgecolor=rcParams["axes.edgecolor"], linewidth=rcParams["axes.linewidth"])

    def write(self, x, y, text, x_points=0.0, y_points=0.0, **style):
        """Text at ``x``, ``y`` as fractions of the axes, moved by so many points."""
        width, height = self.bbox.size / self.figure.dpi * POINTS_PER_INCH
        style = {"transform": self.transAxes, "fontsize": rcParams["axes.titlesize"]} | style
        return self.text(x + x_points / width, y + y_points / height, text, **style)

    def add_title(self, title):
        """The letter of the panel and ``title`` beside it."""
        above = {"y_points": 4, "va": "bottom"}
        self.write(0.0, 1.0, f"({self.letter})", fontweight="bold", **above)
        self.write(0.0, 1.0, title, x_points=20, **above)

    def add_outlines(self, outlines, names, **style):
        """Polygons (n, 2) in the units of the axes, with a name and a style each."""
        self.add_collection(NamedOutlines(outlines, names, **style), autolim=False)
        self.update_datalim(np.concatenate(outlines))

    def frame(self):
        """Scales, limits, ticks and labels for what has been drawn: call it last."""
        x, y = QUANTITIES[self.x_name], QUANTITIES[self.y_name]
        self._set_limits(x, y)
        self._draw_limit_lines(y)
        for side, quantity in (("x", x), ("y", y)):
            low, high = getattr(self, f"get_{side}lim")()
            ticks = _decades(low, high) if quantity.logarithmic else _steps(low, high, quantity)
            self._draw_ticks(side, *ticks)
        self._write_symbol(x.symbol, 0.5, 0.0, y_points=-22)
        self._write_symbol(y.symbol, 0.0, 0.5, x_points=-33, angle=90)

    def _write_symbol(self, symbol, x, y, x_points=0.0, y_points=0.0, angle=0.0):
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
        self.set_xlim(_limits(left_positive if x.logarithmic else left, right, x))
        self.set_ylim(_limits(bottom_positive if y.logarithmic else bottom, top, y))
        self.set_xscale("log" if x.logarithmic else "linear")
        self.set_yscale("log" if y.logarithmic else "linear")

    def _draw_limit_lines(self, quantity):
        """Thin lines at the limits of modes and regimes, which are named outside the right edge."""
        low, high = self.get_ylim()
        edges = np.clip((low, *quantity.limits, high), low, high)
        line = {key: rcParams[f"grid.{key}"] for key in ("color", "linewidth", "linestyle")}
        for limit in quantity.limits:
            if low < limit < high:
                self.axhline(limit, label=FURNITURE, zorder=1, **line)
                self._write_outside(limit, f"{limit / quantity.unit:g}")
        for zone, bottom, top in zip(quantity.zones, edges, edges[1:], strict=False):
            if bottom < top:
                self._write_outside(0.5 * (bottom + top), zone, rotation=270 * (len(zone) > 4))

    def _write_outside(self, y, text, **style):
        style |= {"fontsize": 0.8 * rcParams["ytick.labelsize"], "color": rcParams["text.color"]}
        self.text(1.012, y, text, transform=self.get_yaxis_transform(), va="center", **style)

    def _draw_ticks(self, side, major, labels, minor):
        transform = getattr(self, f"get_{side}axis_transform")()
        for places, kind in ((major, "major"), (minor, "minor")):
            ends = np.zeros(len(places))
            self.add_artist(
                Line2D(
                    *((places, ends) if side == "x" else (ends, places)),
                    transform=transform,
                    linestyle="none",
                    marker=TICKUP if side == "x" else TICKRIGHT,
                    markersize=rcParams[f"{side}tick.{kind}.size"],
                    markeredgewidth=rcParams["xtick.major.width"],
                    color=rcParams["axes.edgecolor"],
                    label=FURNITURE,
                )
            )
        width, height = self.bbox.size / self.figure.dpi * POINTS_PER_INCH
        pad = rcParams[f"{side}tick.major.pad"]
        style = {"fontsize": rcParams[f"{side}tick.labelsize"], "transform": transform}
        for place, label in zip(major, labels, strict=True):
            if side == "x":
                self.text(place, -pad / height, label, ha="center", va="top", **style)
            else:
                self.text(-pad / width, place, label, ha="right", va="center", **style)


def panel_figure(contents, edges=None) -> Figure:
    """A figure of panels; ``contents`` gives x_name and y_name of each, in order.

    ``edges`` of the axes are shares of the panel's cell, by default those of the style.
    Panels stand two abreast; the key takes the cell that an odd number leaves free, or a strip
    below them.
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


def power_text(value) -> str:
    """``value`` as 5×10¹⁰ or 10¹¹."""
    mantissa, exponent = f"{value:.3e}".split("e")
    power = "10" + str(int(exponent)).translate(SUPERSCRIPTS)
    return power if float(mantissa) == 1.0 else f"{float(mantissa):g}×{power}"


def _limits(low, high, quantity):
    """Ends of the axis around data from ``low`` to ``high``."""
    if quantity.logarithmic:
        margin = (high / low) ** 0.02
        return low / margin, high * margin
    if quantity.share:
        top = 1.08 * high if 0.0 < high < 0.5 else 1.0
        return -0.06 * top, 1.08 * top
    margin = 0.04 * (high - low)
    return low - margin, high + margin


def _decades(low, high):
    """Ticks of a logarithmic axis: places and labels of the major ones, places of the minor."""
    first, last = math.ceil(math.log10(low)), math.floor(math.log10(high))
    major = 10.0 ** np.arange(first, last + 1)
    minor = np.outer(10.0 ** np.arange(first - 1, last + 1), np.arange(2, 10)).ravel()
    minor = minor[(minor > low) & (minor < high)]
    return major, [power_text(place) for place in major], minor


def _steps(low, high, quantity):
    """Ticks of a linear axis, labelled in the unit of the quantity."""
    places = MaxNLocator(6, steps=[1, 2, 5, 10]).tick_values(low, high)
    major = places[(places >= low) & (places <= high)]
    middle = 0.5 * (places[1:] + places[:-1])
    minor = middle[(middle > low) & (middle < high)]
    return major, [f"{place / quantity.unit:.6g}" for place in major], minor
