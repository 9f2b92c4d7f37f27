"""What accuracy costs: largest error against time per point, a curve a class of points."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from thirdbody.figures.drawing import CURVE, Drawing, Panel, Series, title_axes
from thirdbody.figures.naming import power_text

SIZE = (7.0, 4.3)  # inches
SPANS = {"usual": "Usual ranges (Table 2)", "extremes": "Extremes"}  # with titles of panels
LOOKS = {
    ("dry", "two_body"): {"color": "C0", "marker": "o"},
    ("dry", "three_body"): {"color": "C4", "marker": "s"},
    ("lubricated", "two_body"): {"color": "C2", "marker": "^"},
    ("lubricated", "three_body"): {"color": "C1", "marker": "D"},
}
METHODS = {
    "library": {"linestyle": "-", "fillstyle": "full"},
    "library_grid": {"linestyle": ":", "fillstyle": "full", "markersize": 3},
    "elementwise_roots": {"linestyle": "--", "fillstyle": "none", "linewidth": 0.7},
    "nested_roots": {"linestyle": "none", "fillstyle": "full", "marker": "*", "markersize": 9},
}
NAMES = {
    "library": "library, points, each rtol",
    "library_grid": "library, grids",
    "elementwise_roots": "find_root, arrays",
    "nested_roots": "quad, brentq, one by one",
}
NO_DIGIT, ALL_DIGITS = 1.0, 1e-16  # errors beyond these are drawn there
LABELLED = ("lubricated", "three_body")  # whose points are labelled with some of their rtol
LABELS = (1e-2, 1e-3, 1e-6, 1e-9, 1e-11)


def plot(errors: Sequence[Mapping], times: Sequence[Mapping]) -> Drawing:
    """Largest error against time per point, from rows of the tables ``errors`` and ``times``."""
    cost = {_key(row): row["microseconds_per_point"] for row in times}
    worst = dict.fromkeys(cost, 0.0)
    for row in errors:
        worst[_key(row)] = max(worst[_key(row)], row["largest_error"])
    figure = Figure(figsize=SIZE, layout="constrained")
    panels = []
    all_axes = figure.subplots(1, 2, sharex=True, sharey=True)
    for letter, axes, (span, title) in zip("AB", all_axes, SPANS.items(), strict=True):
        series = []
        for contact, look in LOOKS.items():
            for method, style in METHODS.items():
                keys = [key for key in cost if (key[0], *key[2:]) == (method, *contact, span)]
                if not keys:
                    continue
                x = np.array([cost[key] for key in keys])
                y = np.clip([worst[key] for key in keys], ALL_DIGITS, NO_DIGIT)
                series.append(Series(CURVE, f"{' '.join(contact)}; {method}", x, y))
                axes.plot(x, y, **look | style)
                if method == "library" and contact == LABELLED:
                    _label(axes, [key[1] for key in keys], x, y, look["color"])
        panels.append(
            Panel(letter, title, "microseconds_per_point", "largest_error", tuple(series))
        )
        title_axes(axes, panels[-1])
        axes.set(xscale="log", yscale="log", ylim=(0.2 * ALL_DIGITS, 5.0 * NO_DIGIT))
        axes.grid(True, color="0.9", linewidth=0.5)
        axes.set_xlabel("processor time a point (µs)")
    all_axes[0].set_ylabel("largest relative error")
    figure.legend(handles=_entries(), loc="outside lower center", ncols=4)
    return Drawing(figure, tuple(panels))


def _key(row):
    return row["method"], row["rtol"], row["medium"], row["bodies"], row["span"]


def _label(axes: Axes, tolerances, x, y, colour) -> None:
    """The rtol asked for beside some of the points."""
    place = {"xytext": (7, 0), "textcoords": "offset points", "va": "center", "zorder": 5}
    paper = {"facecolor": "white", "edgecolor": "none", "pad": 0.6}
    for rtol, *point in zip(tolerances, x, y, strict=True):
        if rtol in LABELS:
            axes.annotate(power_text(rtol), point, color=colour, fontsize=7, bbox=paper, **place)


def _entries() -> list[Line2D]:
    """Classes by colour and marker, methods by line and filling."""
    entries = [
        Line2D([], [], linestyle="-", label=" ".join(contact).replace("_", "-"), **look)
        for contact, look in LOOKS.items()
    ]
    grey = {"color": "0.4", "marker": "o"}
    methods = METHODS.items()
    return entries + [Line2D([], [], label=NAMES[name], **grey | style) for name, style in methods]
