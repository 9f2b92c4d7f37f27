"""How curves look: colours, dashes and markers that differ in grey too."""

from __future__ import annotations

from collections.abc import Sequence

import matplotlib
import numpy as np
from matplotlib import rcParams
from matplotlib.colors import to_rgb
from matplotlib.lines import Line2D

from thirdbody.data.conditions import Condition
from thirdbody.figures.drawing import CURVE, Series
from thirdbody.figures.naming import value_text

MARKERS = "osD^vPX"  # every second one is hollow: levels next to each other look different
DARKEST, LIGHTEST = 0.05, 0.87  # of the colour map: two-body contact is black, lines fade on white
GREY = "0.5"
BLUE = "#0072B2"  # of the one curve of an interface, or of the model
MARKERS_PER_CURVE = 5
# Dry curves lie on the lubricated ones, which show in the gaps of their heavier dashes.
DRY = {"linestyle": (0, (2.4, 1.8)), "linewidth": 1.7, "zorder": 2.3}
DRY_TWO_BODY = {"linestyle": (0, (1.0, 1.3)), "linewidth": 1.7, "zorder": 2.2, "color": GREY}
TINT = 0.13  # of the colour in a range, the rest is white


def level_styles(count: int) -> list[dict]:
    """Line properties of ``count`` ordered levels: the colour grows lighter, each has its marker."""
    colours = matplotlib.colormaps[rcParams["image.cmap"]](np.linspace(DARKEST, LIGHTEST, count))
    return [
        {"color": colour, "marker": MARKERS[index % len(MARKERS)], "linestyle": "-"}
        | {"markerfacecolor": "white" if index % 2 else colour, "markeredgecolor": colour}
        for index, colour in enumerate(map(tuple, colours.tolist()))
    ]


def band_style(colour) -> dict:
    """Properties of the area of a range: opaque with an edge, as many may lie on one another."""
    tint = 1.0 - TINT * (1.0 - np.array(to_rgb(colour)))
    return {"facecolor": tint, "edgecolor": (colour, 0.6), "linewidth": 0.5, "zorder": 1.5}


class Styles:
    """Line styles of curves at ``conditions`` that differ in one ``parameter``.

    Each level of the parameter has a colour and a marker.  Two-body contact is black or grey.  Beside
    lubricated contact, dry contact is dashed, or dotted without particles, and has no markers.
    """

    def __init__(self, conditions: Sequence[Condition], parameter: str):
        self.conditions, self.parameter = conditions, parameter
        media = {condition.is_dry for condition in conditions}
        self.compares_media = parameter != "viscosity" and len(media) == 2
        self.all_dry = media == {True}
        levels = sorted({getattr(each, parameter) for each in conditions} - {0.0})
        self.levels = dict(zip(levels, level_styles(len(levels)), strict=True))

    def of(self, condition: Condition) -> dict:
        """Line properties of the curve at ``condition``."""
        dashed = condition.is_dry and not self.all_dry
        level = getattr(condition, self.parameter)
        if level == 0.0:
            if condition.is_two_body and self.parameter == "viscosity":
                return DRY_TWO_BODY
            return {"color": "black"} | (DRY if dashed else {})
        return self.levels[level] | (DRY | {"marker": "none"} if dashed else {})

    def of_series(self, series: Series) -> dict:
        """Line properties of the curve of a series, with a few markers at other points than the
        next level."""
        if series.condition is None:
            return {}
        style = self.of(series.condition)
        if series.kind == CURVE and "marker" in style:
            level = list(self.levels).index(getattr(series.condition, self.parameter))
            step = max(series.x.size // MARKERS_PER_CURVE, 1)
            style = style | {"markevery": (int(step * (level + 0.5) / len(self.levels)), step)}
        return style

    def key(self) -> list[Line2D]:
        """Entries of the key: the levels, then dry and lubricated contact where both are drawn."""
        entries = {
            self._text(each): self.of(each)
            for each in self.conditions
            if not (self.compares_media and each.is_dry)
        }
        if self.compares_media:
            for each in sorted(self.conditions, key=lambda condition: -condition.viscosity):
                text = "dry" if each.is_dry else f"{value_text('viscosity', each.viscosity)} cSt"
                entries[text] = (DRY if each.is_dry else {}) | {"color": GREY}
        return [Line2D([], [], label=text, **look) for text, look in entries.items()]

    def _text(self, condition):
        level = getattr(condition, self.parameter)
        if self.parameter == "viscosity" and condition.is_dry:
            return "dry, two-body" if condition.is_two_body else "dry"
        return "none (two-body)" if level == 0.0 else value_text(self.parameter, level)
