"""Figures of curves: the combinations that a dataset shows, drawn into panels."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from thirdbody.figures.marks import mark_entries, mark_turning_points, turning_points_of
from thirdbody.figures.sheet.key import draw_key
from thirdbody.figures.sheet.naming import parameter_title, shared_notes
from thirdbody.figures.sheet.panel import Panel, panel_figure
from thirdbody.figures.sheet.scales import SCALES
from thirdbody.figures.sheet.styles import Styles
from thirdbody.figures.shown import Curve, shown_curves

BAND_STEP = 2  # every second load is fine enough for the edge of a band
# of the key: the text, and a line about as wide as a band
BAND_ENTRY = (
    "calibrated ensemble",
    {"color": "0.82", "linewidth": 6.0, "solid_capstyle": "butt"},
)


@dataclass(frozen=True)
class Content:
    """What a panel shows.

    Attributes
    ----------
    y, x : str
        Variables against each other; one of ``SCALES``.
    surface : int, optional
        Curves of one surface alone: 0 for the smoothest of the dataset, -1 for the roughest.
    locus : bool
        Whether the turning points of the curves are joined.
    """

    y: str
    x: str = "load"
    surface: int | None = None
    locus: bool = False


@dataclass(frozen=True)
class CurveFigure:
    """A figure of curves: a row of the registry.

    Attributes
    ----------
    parameter : str
        What its curves are told apart by: an attribute of ``Condition``.
    contents : tuple of Content
        Its panels, in order.
    each_surface : bool
        Whether the panels stand once for each roughness of the dataset.
    """

    parameter: str
    contents: tuple[Content, ...]
    each_surface: bool = False

    def plot(
        self,
        data: xr.Dataset,
        turning_points: Sequence[Mapping] = (),
        band: xr.Dataset | None = None,
    ) -> Figure:
        """Draw it.

        Parameters
        ----------
        data : xarray.Dataset
            One of ``read_dataset``.
        turning_points : sequence of Mapping
            The four conditions (SI), ``load`` and ``peak_ratio`` of each, to be marked.
        band : xarray.Dataset, optional
            ``<variable>_low`` and ``_high`` on the axes of ``data``, drawn behind the curves.
        """
        contents = self._panels(data)
        curves = shown_curves(data)
        curves.sort(key=lambda c: (getattr(c.condition, self.parameter), c.condition.is_two_body))
        conditions = [curve.condition for curve in curves]
        styles = Styles(conditions, self.parameter)
        common = shared_notes(conditions)
        newtons_per_load = float(data["normal_load"][-1] / data["load"][-1])
        figure = panel_figure([(content.x, content.y) for content in contents])
        for panel, content in zip(figure.axes, contents, strict=True):
            chosen = _on_surface(curves, data, content.surface)
            panel.add_title(_title(content, chosen, common))
            if band is not None and content.x == "load":
                draw_bands(panel, band, chosen, styles)
            for curve in chosen:
                draw_curve(panel, data, curve, styles)
            _draw_marks(panel, data, content, turning_points_of(chosen, turning_points))
            panel.frame(newtons_per_load)
        marks = mark_entries(figure) + [BAND_ENTRY] * (band is not None)
        title = parameter_title(self.parameter)
        draw_key(figure, title, ", ".join(common), styles.key(conditions), marks)
        return figure

    def _panels(self, data) -> Sequence[Content]:
        if not self.each_surface:
            return self.contents
        surfaces = range(data.sizes["roughness"])
        return [replace(each, surface=index) for index in surfaces for each in self.contents]


def draw_curve(panel: Panel, data: xr.Dataset, curve: Curve, styles: Styles) -> None:
    """Draw ``curve`` into ``panel``."""
    x, y = curve.values(data, panel.x_name), curve.values(data, panel.y_name)
    places = styles.markers_on(curve.condition, len(x))
    style = styles.of(curve.condition)
    panel.add_line(Line2D(x, y, label=curve.label, markevery=places, **style))


def draw_bands(panel: Panel, band: xr.Dataset, curves: Sequence[Curve], styles: Styles) -> None:
    """Draw the envelopes of ``curves`` at each load, in a tint of their colours.

    The tints are opaque: many curves lie on one another, and so would their bands.
    """
    load = band[panel.x_name].values
    some = np.unique([*range(0, load.size, BAND_STEP), load.size - 1])
    outlines = []
    for curve in curves:
        low, high = (curve.values(band, f"{panel.y_name}_{end}")[some] for end in ("low", "high"))
        there, back = (np.column_stack((load[some], edge)) for edge in (low, high))
        known = np.isfinite(low) & np.isfinite(high)
        outlines.append(np.concatenate((there[known], back[known][::-1])))
    names = [f"band; {curve.label}" for curve in curves]
    tints = [styles.tint(curve.condition) for curve in curves]
    panel.add_outlines(outlines, names, facecolors=tints, linewidths=0.0, zorder=1.5)


def _on_surface(curves, data, surface):
    """Those of ``curves`` on the surface with this index among the roughnesses of ``data``."""
    if surface is None:
        return curves
    roughness = data["roughness"].values[surface]
    return [curve for curve in curves if curve.condition.roughness == roughness]


def _title(content, chosen, common) -> str:
    """What the curves of a panel share beyond the others, or else what it shows."""
    shared = shared_notes([curve.condition for curve in chosen])
    own = [text for text in shared if text not in common]
    return ", ".join(own) or SCALES[content.y].title


def _draw_marks(panel, data, content, marked):
    if content.locus:
        mark_turning_points(panel, data, marked, "locus of the turning points")
    if content.locus or content.y == "particle_contact_area_ratio":
        mark_turning_points(panel, data, marked)
