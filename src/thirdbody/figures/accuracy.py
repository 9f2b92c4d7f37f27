"""What an error costs: largest error against time per point, a curve a class of points."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from thirdbody.figures.naming import power_text
from thirdbody.figures.sheet.panel import FURNITURE, Panel

SIZE = (7.0, 4.3)  # inches
# span: letter, title, axes as shares of the figure
PANELS = {
    "usual": ("A", "Usual ranges (Table 2)", (0.085, 0.265, 0.405, 0.665)),
    "extremes": ("B", "Extremes", (0.585, 0.265, 0.405, 0.665)),
}
LOOKS = {
    ("dry", "two_body"): {"color": "C0", "marker": "o"},
    ("dry", "three_body"): {"color": "C4", "marker": "s"},
    ("lubricated", "two_body"): {"color": "C2", "marker": "^"},
    ("lubricated", "three_body"): {"color": "C1", "marker": "D"},
}
METHODS = {
    "library": {"linestyle": "-", "fillstyle": "full"},
    "elementwise_roots": {"linestyle": "--", "fillstyle": "none", "linewidth": 0.7},
    "nested_roots": {"linestyle": "none", "fillstyle": "full", "marker": "*", "markersize": 9},
}
NAMES = {
    "library": "library, each rtol",
    "elementwise_roots": "find_root, arrays",
    "nested_roots": "quad, brentq, one by one",
}
NO_DIGIT, ALL_DIGITS = 1.0, 1e-16  # errors beyond these are drawn there
LABELLED = ("lubricated", "three_body")  # whose points are labelled with some of their rtol
LABELS = (1e-2, 1e-3, 1e-6, 1e-9, 1e-11)
LABEL_HEIGHT = 4.0  # ratio of errors


def plot(errors: Sequence[Mapping], times: Sequence[Mapping]) -> Figure:
    """Largest error against time per point, both axes logarithmic.

    Parameters
    ----------
    errors, times : sequence of Mapping
        Rows of the tables of these names.
    """
    cost = {_key(row): row["microseconds_per_point"] for row in times}
    worst = dict.fromkeys(cost, 0.0)
    for row in errors:
        worst[_key(row)] = max(worst[_key(row)], row["largest_error"])
    figure = Figure(figsize=SIZE)
    for span, (letter, title, box) in PANELS.items():
        panel = figure.add_axes(
            Panel(figure, box, letter, "microseconds_per_point", "largest_error")
        )
        for contact, look in LOOKS.items():
            for method, style in METHODS.items():
                points = [
                    (rtol, cost[key], min(max(error, ALL_DIGITS), NO_DIGIT))
                    for key, error in worst.items()
                    for rtol in [key[1]]
                    if (key[0], *key[2:]) == (method, *contact, span)
                ]
                _draw(panel, points, f"{' '.join(contact)}; {method}", look | style)
                if method == "library" and contact == LABELLED:
                    _label(panel, points, look["color"])
        _frame(panel, title, (0.5 * min(cost.values()), 2.0 * max(cost.values())))
    _draw_key(figure)
    return figure


def _key(row):
    return row["method"], row["rtol"], row["medium"], row["bodies"], row["span"]


def _draw(panel, points, label, style):
    if points:
        _, x, y = zip(*points, strict=True)
        panel.add_line(Line2D(x, y, label=label, **style))


def _label(panel, points, colour):
    """The rtol asked for beside some of the points, one where two would overlap."""
    above = math.inf
    for rtol, x, y in sorted(points, key=lambda point: -point[2]):
        if rtol not in LABELS or y > above / LABEL_HEIGHT:
            continue
        above = y
        place = {"xytext": (7, 0), "textcoords": "offset points", "va": "center", "zorder": 5}
        paper = {"facecolor": "white", "edgecolor": "none", "pad": 0.6}
        panel.annotate(power_text(rtol), (x, y), color=colour, fontsize=6, bbox=paper, **place)


def _frame(panel, title, times):
    panel.set_xscale("log")
    panel.set_yscale("log")
    panel.set_xlim(times)
    panel.set_ylim(0.2 * ALL_DIGITS, 5.0 * NO_DIGIT)
    grid = {"color": "0.9", "linewidth": 0.5, "label": FURNITURE}
    panel.grid(True, **grid)
    panel.set_axisbelow(True)
    panel.xaxis.set_visible(True)
    panel.yaxis.set_visible(True)
    panel.set_xlabel("processor time a point (µs)", fontsize=8)
    panel.set_ylabel("largest relative error", fontsize=8)
    panel.add_title(title)


def _draw_key(figure):
    """Classes by colour and marker, methods by line and filling."""
    handles = [
        Line2D([], [], linestyle="-", label=" ".join(contact).replace("_", "-"), **look)
        for contact, look in LOOKS.items()
    ]
    grey = {"color": "0.4", "marker": "o"}
    handles += [
        Line2D([], [], label=NAMES[name], **grey | style) for name, style in METHODS.items()
    ]
    figure.legend(handles=handles, loc="lower center", ncols=4)
