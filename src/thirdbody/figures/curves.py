"""Figures of curves: the combinations that a dataset shows, drawn into panels."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from thirdbody.figures.conditions import PARAMETERS, Conditions, shared_texts
from thirdbody.figures.key import draw_key
from thirdbody.figures.marks import mark_entries, mark_turning_points, turning_points_of
from thirdbody.figures.panel import QUANTITIES, panel_figure
from thirdbody.figures.styles import Styles
from thirdbody.scene import DIMENSIONS

BAND = {"alpha": 0.18, "linewidth": 0, "zorder": 1.5}


@dataclass(frozen=True)
class Curve(Conditions):
    """One curve of a dataset: its conditions and its ``place`` behind the load axis."""

    place: tuple[int, ...]

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
        return self.roughness in (None, curve.roughness)


def shown_curves(data) -> list[Curve]:
    """The combinations that ``data`` holds: all but those filled at every load."""
    status = data["solution_status"].values
    axes = [data[name].values for name in DIMENSIONS[1:]]
    places = np.argwhere(~np.isnan(status).all(axis=0)).tolist()
    return [
        Curve(*(float(axis[i]) for axis, i in zip(axes, place, strict=True)), tuple(place))
        for place in places
    ]


def plot_curves(data, parameter, contents, turning_points=(), band=None) -> Figure:
    """A figure with a panel for each of ``contents``, its curves told apart by ``parameter``.

    ``data`` is a dataset of ``read_dataset``; ``turning_points`` are dicts of conditions (SI),
    ``load`` and ``peak_ratio``; ``band`` holds ``<variable>_low`` and ``_high`` on the same axes.
    """
    curves = shown_curves(data)
    curves.sort(key=lambda curve: (getattr(curve, parameter), curve.is_two_body))
    styles = Styles(curves, parameter)
    common = shared_texts(curves)
    figure = panel_figure([(content.x, content.y) for content in contents])
    for panel, content in zip(figure.axes, contents, strict=True):
        chosen = [curve for curve in curves if content.holds(curve)]
        notes = [text for text in shared_texts(chosen) if text not in common]
        panel.add_title(", ".join(notes) or QUANTITIES[content.y].name)
        for curve in chosen:
            draw_curve(panel, data, curve, styles, band)
        _draw_marks(panel, data, content, turning_points_of(chosen, turning_points))
        panel.frame()
    title = PARAMETERS[parameter][0]
    draw_key(figure, title, ", ".join(common), styles.key(curves), mark_entries(figure))
    return figure


def draw_curve(panel, data, curve, styles, band):
    """Draw ``curve`` into ``panel``, over its band if there is one."""
    x, y = curve.values(data, panel.x_name), curve.values(data, panel.y_name)
    style = styles.of(curve)
    if band is not None:
        ends = (curve.values(band, f"{panel.y_name}_{end}") for end in ("low", "high"))
        label = f"band; {curve.label}"
        panel.fill_between(x, *ends, color=style["color"], label=label, **BAND)
    places = styles.markers_on(curve, len(x))
    panel.add_line(Line2D(x, y, label=curve.label, markevery=places, **style))


def _draw_marks(panel, data, content, marked):
    if content.locus:
        mark_turning_points(panel, data, marked, "locus of the turning points")
    if content.locus or content.y == "particle_contact_area_ratio":
        mark_turning_points(panel, data, marked)
