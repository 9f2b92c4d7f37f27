"""How curves look: colours, dashes and markers that tell them apart, in grey too."""

from __future__ import annotations

from collections.abc import Sequence

import matplotlib
import numpy as np
from matplotlib import rcParams
from matplotlib.colors import to_rgb
from numpy.typing import NDArray

from thirdbody.data.conditions import Condition
from thirdbody.figures.sheet.naming import value_text

MARKERS = "osv^DX<>PphHd8"
MARKERS_PER_CURVE = 7
LIGHTEST = 0.87  # of the colour map: beyond it lines fade on white
TINT = 0.22  # share of the colour, the rest is white
TWO_BODY_GREY = "0.55"  # where black is taken by dry contact


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
    contact is black or grey.  Dry contact is dashed, and bare of markers beside its lubricated
    counterpart.
    """

    def __init__(self, conditions: Sequence[Condition], parameter: str):
        self.parameter = parameter
        media = {condition.is_dry for condition in conditions}
        self.compares_media = parameter != "viscosity" and len(media) == 2
        self.levels = sorted({getattr(each, parameter) for each in conditions} - {0.0})
        shades = np.linspace(0.0, LIGHTEST, len(self.levels))
        self.colours = matplotlib.colormaps[rcParams["image.cmap"]](shades).tolist()

    def of(self, condition: Condition) -> dict:
        """Line properties of the curve at ``condition``."""
        style = {"linestyle": "--" if condition.is_dry else "-"}
        level = getattr(condition, self.parameter)
        if level == 0.0:
            two_bodies_beside = condition.is_two_body and self.parameter == "viscosity"
            return style | {"color": TWO_BODY_GREY if two_bodies_beside else "black"}
        index = self.levels.index(level)
        style["color"] = self.colours[index]
        if not (self.compares_media and condition.is_dry):
            style["marker"] = MARKERS[index % len(MARKERS)]
        return style

    def tint(self, condition: Condition) -> NDArray[np.float64]:
        """Light variant of the colour of the curve at ``condition``: red, green, blue."""
        return 1.0 - TINT * (1.0 - np.array(to_rgb(self.of(condition)["color"])))

    def markers_on(self, condition: Condition, count: int) -> tuple[int, int]:
        """First and step of the markers among ``count`` points: those of two curves never meet."""
        level = getattr(condition, self.parameter)
        index = self.levels.index(level) if level in self.levels else 0
        step = max(count // MARKERS_PER_CURVE, 1)
        return int(step * (index + 0.5) / max(len(self.levels), 1)), step

    def key(self, conditions: Sequence[Condition]) -> list[tuple[str, dict]]:
        """Text and line properties of each entry of the key."""
        entries = {}
        for each in conditions:
            if not (self.compares_media and each.is_dry):
                entries.setdefault(self._text(each), self.of(each))
        if self.compares_media:
            for each in sorted(conditions, key=lambda condition: -condition.viscosity):
                text = "dry" if each.is_dry else f"{value_text('viscosity', each.viscosity)} cSt"
                entries[text] = {"color": "black", "linestyle": self.of(each)["linestyle"]}
        return list(entries.items())

    def _text(self, condition):
        level = getattr(condition, self.parameter)
        if self.parameter == "viscosity" and condition.is_dry:
            return "dry, two-body" if condition.is_two_body else "dry"
        if level == 0.0:
            return "none (two-body)"
        return value_text(self.parameter, level)
