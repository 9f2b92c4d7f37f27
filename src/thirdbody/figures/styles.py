"""How curves look: colours, dashes and markers that tell them apart, in grey too."""

from __future__ import annotations

import matplotlib
import numpy as np
from matplotlib import rcParams
from matplotlib.colors import to_rgb

from thirdbody.data.scene import CENTISTOKES
from thirdbody.figures.conditions import PARAMETERS
from thirdbody.figures.panel import power_text

MARKERS = "osv^DX<>PphHd8"
MARKERS_PER_CURVE = 7
LIGHTEST = 0.87  # of the colour map: beyond it lines fade on white
TINT = 0.22  # share of the colour, the rest is white
TWO_BODY_GREY = "0.55"  # where black is taken by dry contact


class Styles:
    """Line styles of a family of curves that differ in ``parameter``.

    The colours of an ordered parameter grow lighter with it, and each has its marker.  Two-body
    contact is black or grey.  Dry contact is dashed, and bare of markers beside its lubricated
    counterpart.
    """

    def __init__(self, curves, parameter):
        self.parameter = parameter
        self.compares_media = parameter != "viscosity" and len({c.is_dry for c in curves}) == 2
        self.levels = sorted({getattr(c, parameter) for c in curves} - {0.0})
        shades = np.linspace(0.0, LIGHTEST, len(self.levels))
        self.colours = matplotlib.colormaps[rcParams["image.cmap"]](shades).tolist()

    def of(self, curve) -> dict:
        """Line properties of ``curve``."""
        style = {"linestyle": "--" if curve.is_dry else "-"}
        level = getattr(curve, self.parameter)
        if level == 0.0:
            two_bodies_beside = curve.is_two_body and self.parameter == "viscosity"
            return style | {"color": TWO_BODY_GREY if two_bodies_beside else "black"}
        index = self.levels.index(level)
        style["color"] = self.colours[index]
        if not (self.compares_media and curve.is_dry):
            style["marker"] = MARKERS[index % len(MARKERS)]
        return style

    def tint(self, curve):
        """Light variant of the colour of ``curve``."""
        return 1.0 - TINT * (1.0 - np.array(to_rgb(self.of(curve)["color"])))

    def markers_on(self, curve, count):
        """Where on ``count`` points the markers stand, so that those of two curves never meet."""
        level = getattr(curve, self.parameter)
        index = self.levels.index(level) if level in self.levels else 0
        step = max(count // MARKERS_PER_CURVE, 1)
        return int(step * (index + 0.5) / max(len(self.levels), 1)), step

    def key(self, curves):
        """Text and style of each entry of the key."""
        entries = {}
        for curve in curves:
            if not (self.compares_media and curve.is_dry):
                entries.setdefault(self._text(curve), self.of(curve))
        if self.compares_media:
            for curve in sorted(curves, key=lambda c: -c.viscosity):
                text = "dry" if curve.is_dry else f"{curve.viscosity / CENTISTOKES:g} cSt"
                entries[text] = {"color": "black", "linestyle": self.of(curve)["linestyle"]}
        return list(entries.items())

    def _text(self, curve):
        level = getattr(curve, self.parameter)
        if self.parameter == "viscosity" and curve.is_dry:
            return "dry, two-body" if curve.is_two_body else "dry"
        if level == 0.0:
            return "none (two-body)"
        if self.parameter == "particle_density":
            return power_text(level)
        return f"{level / PARAMETERS[self.parameter][1]:.10g}"
