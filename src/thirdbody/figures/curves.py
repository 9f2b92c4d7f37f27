"""Figures of curves: the combinations that a dataset shows, drawn into panels."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from thirdbody.data.conditions import Condition
from thirdbody.data.netcdf import shown_combinations
from thirdbody.figures.marks import mark_entries, mark_turning_points, turning_points_of
from thirdbody.figures.sheet.key import draw_key
from thirdbody.figures.sheet.naming import label, parameter_title, shared_notes
from thirdbody.figures.sheet.panel import QUANTITIES, panel_figure
from thirdbody.figures.sheet.styles import Styles

BAND_STEP = 2  # every second load is fine enough for the edge of a band
# of the key: the text, and a line about as wide as a band
BAND_ENTRY = (
    "calibrated ensemble",
    {"color": "0.82", "linewidth": 6.0, "solid_capstyle": "butt"},
)


@dataclass(frozen=True)
class Curve:
    """One curve of a dataset: its ``condition`` and its ``place`` behind the load axis."""

    condition: Condition
    place: tuple[int, ...]

    @property
    def label(self) -> str:
        """What the file of the drawn data calls it."""
        return label(self.condition)

    def values(self, data, name):
        """Values of the variable ``name`` along the curve."""
        values = data[name].values
        return values if values.ndim == 1 else values[(slice(None), *self.place)]


@dataclass(frozen=True)
class Content:
    """What a panel shows: ``y`` against ``x`` of the curves with one ``roughness``, or of all."""

    y: str
    x: str = "load"
    roughness: float | None = None
    locus: bool = False

    def holds(self, curve) -> bool:
        """Whether ``curve`` belongs to the panel."""
        return self.roughness in (None, curve.condition.roughness)


def shown_curves(data) -> list[Curve]:
    """The combinations that ``data`` holds: all but those filled at every load."""
    axes = [data[name].values for name in Condition._fields]
    return [
        Curve(
            Condition(*(float(axis[i]) for axis, i in zip(axes, place, strict=True))), tuple(place)
        )
        for place in np.argwhere(shown_combinations(data)).tolist()
    ]


def plot_curves(data, parameter, contents, turning_points=(), band=None) -> Figure:
    """A figure with a panel for each of ``contents``, its curves told apart by ``parameter``.

    ``data`` is a dataset of ``read_dataset``; ``turning_points`` are dicts of conditions (SI),
    ``load`` and ``peak_ratio``; ``band`` holds ``<variable>_low`` and ``_high`` on the same axes.
    """
    curves = shown_curves(data)
    curves.sort(key=lambda c: (getattr(c.condition, parameter), c.condition.is_two_body))
    conditions = [curve.condition for curve in curves]
    styles = Styles(conditions, parameter)
    common = shared_notes(conditions)
    figure = panel_figure([(content.x, content.y) for content in contents])
    for panel, content in zip(figure.axes, contents, strict=True):
        chosen = [curve for curve in curves if content.holds(curve)]
        shared = shared_notes([curve.condition for curve in chosen])
        own = [text for text in shared if text not in common]
        panel.add_title(", ".join(own) or QUANTITIES[content.y].name)
        if band is not None and content.x == "load":
            draw_bands(panel, band, chosen, styles)
        for curve in chosen:
            draw_curve(panel, data, curve, styles)
        _draw_marks(panel, data, content, turning_points_of(chosen, turning_points))
        panel.frame()
    marks = mark_entries(figure) + [BAND_ENTRY] * (band is not None)
    draw_key(figure, parameter_title(parameter), ", ".join(common), styles.key(conditions), marks)
    return figure


def draw_curve(panel, data, curve, styles):
    """Draw ``curve`` into ``panel``."""
    x, y = curve.values(data, panel.x_name), curve.values(data, panel.y_name)
    places = styles.markers_on(curve.condition, len(x))
    style = styles.of(curve.condition)
    panel.add_line(Line2D(x, y, label=curve.label, markevery=places, **style))


def draw_bands(panel, band, curves, styles):
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


def _draw_marks(panel, data, content, marked):
    if content.locus:
        mark_turning_points(panel, data, marked, "locus of the turning points")
    if content.locus or content.y == "particle_contact_area_ratio":
        mark_turning_points(panel, data, marked)
