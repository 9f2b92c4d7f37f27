"""How curves look: colours, dashes and markers that tell them apart, in grey too."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import matplotlib
import numpy as np
from matplotlib import rcParams
from matplotlib.colors import to_rgb
from numpy.typing import NDArray

from thirdbody.data.conditions import Condition
from thirdbody.figures.naming import value_text

MARKERS = "osv^DX<>PphHd8"
LIGHTEST = 0.87  # of the colour map: beyond it lines fade on white
TINT = 0.22  # share of the colour, the rest is white
TWO_BODY_GREY = "0.55"  # where black is taken by dry contact
# Dry curves lie on the lubricated ones, which show in the gaps of their heavier dashes.
DRY = {"linestyle": (0, (2.4, 1.8)), "linewidth": 1.7, "zorder": 2.3}
DRY_TWO_BODY = {"linestyle": (0, (1.0, 1.3)), "linewidth": 1.7, "zorder": 2.2}


class Styles:
    """Line styles of a family of curves that differ in one parameter.

    Parameters
    ----------
    conditions : sequence of Condition
        Those of all curves of the figure.
    parameter : str
        Attribute of ``Condition`` in which they differ.

    Notes
    -----
    The colours of an ordered parameter grow lighter with it, and each has its marker.  Two-body
    contact is black or grey.  Beside lubricated contact, dry contact is dashed, or dotted without
    particles, and bare of the markers of its lubricated counterpart.
    """

    def __init__(self, conditions: Sequence[Condition], parameter: str):
        self.parameter = parameter
        media = {condition.is_dry for condition in conditions}
        self.compares_media = parameter != "viscosity" and len(media) == 2
        self.all_dry = media == {True}
        self.levels = sorted({getattr(each, parameter) for each in conditions} - {0.0})
        shades = np.linspace(0.0, LIGHTEST, len(self.levels))
        self.colours = matplotlib.colormaps[rcParams["image.cmap"]](shades).tolist()

    def of(self, condition: Condition) -> dict:
        """Line properties of the curve at ``condition``."""
        style = {"linestyle": "-"}
        if condition.is_dry and not self.all_dry:
            style = dict(DRY)
        level = getattr(condition, self.parameter)
        if level == 0.0:
            if condition.is_two_body and self.parameter == "viscosity":
                return DRY_TWO_BODY | {"color": TWO_BODY_GREY}
            return style | {"color": "black"}
        index = self.levels.index(level)
        style["color"] = self.colours[index]
        if not (self.compares_media and condition.is_dry):
            style["marker"] = MARKERS[index % len(MARKERS)]
        return style

    def tint(self, condition: Condition) -> NDArray[np.float64]:
        """Light variant of the colour of the curve at ``condition``: red, green, blue."""
        return 1.0 - TINT * (1.0 - np.array(to_rgb(self.of(condition)["color"])))

    def are_rivals(self, one: Condition, other: Condition) -> bool:
        """Whether their curves need telling apart by markers: not dry from lubricated contact."""
        if self.compares_media:
            return one.is_dry == other.is_dry
        return True

    def stagger(self, condition: Condition) -> float:
        """Place of its markers between 0 and 1: those of two levels never meet."""
        index = self.levels.index(getattr(condition, self.parameter))
        return (index + 0.5) / len(self.levels)

    def key(
        self, conditions: Sequence[Condition], marked: Collection[Condition]
    ) -> list[tuple[str, dict]]:
        """Text and line properties of each entry of the key.

        Parameters
        ----------
        conditions : sequence of Condition
            Those of the curves.
        marked : collection of Condition
            Those of the curves that show their markers somewhere.
        """
        entries = {}
        for each in sorted(conditions, key=lambda condition: condition not in marked):
            if not (self.compares_media and each.is_dry):
                bare = {} if each in marked else {"marker": "none"}
                entries.setdefault(self._text(each), self.of(each) | bare)
        entries = {text: entries[text] for text in map(self._text, conditions) if text in entries}
        if self.compares_media:
            for each in sorted(conditions, key=lambda condition: -condition.viscosity):
                text = "dry" if each.is_dry else f"{value_text('viscosity', each.viscosity)} cSt"
                look = self.of(each) | {"color": "black", "marker": "none"}
                entries[text] = look
        return list(entries.items())

    def _text(self, condition):
        level = getattr(condition, self.parameter)
        if self.parameter == "viscosity" and condition.is_dry:
            return "dry, two-body" if condition.is_two_body else "dry"
        if level == 0.0:
            return "none (two-body)"
        return value_text(self.parameter, level)
