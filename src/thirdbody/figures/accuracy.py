"""What accuracy costs: largest error against time per point, a curve a class of points."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.lines import Line2D

from thirdbody.figures.drawing import CURVE, Drawing, Panel, Series

SIZE = (7.0, 4.3)  # inches
SPANS = {"usual": "Usual ranges (Table 2)", "extremes": "Extremes"}  # with titles of panels
CLASSES = {  # medium and bodies
    ("dry", "two_body"): {"color": "C0", "marker": "o"},
    ("dry", "three_body"): {"color": "C4", "marker": "s"},
    ("lubricated", "two_body"): {"color": "C2", "marker": "^"},
    ("lubricated", "three_body"): {"color": "C1", "marker": "D"},
}
# method: text of the key, line properties
METHODS = {
    "library": ("library, points, each rtol", {"linestyle": "-"}),
    "library_grid": ("library, grids", {"linestyle": ":", "markersize": 3}),
    "elementwise_roots": ("find_root, arrays", {"linestyle": "--", "fillstyle": "none"}),
    "nested_roots": (
        "quad, brentq, one by one",
        {"linestyle": "none", "marker": "*", "markersize": 9},
    ),
}
NO_DIGIT, ALL_DIGITS = 1.0, 1e-16  # errors beyond these are drawn there


def plot(errors: Sequence[Mapping], times: Sequence[Mapping]) -> Drawing:
    """Largest error against time per point, from rows of the tables ``errors`` and ``times``."""
    worst: dict[tuple, float] = {}
    for row in errors:
        worst[_key(row)] = max(worst.get(_key(row), ALL_DIGITS), row["largest_error"])
    figure = Drawing(figsize=SIZE, layout="constrained")
    figure.subplots(1, 2, sharex=True, sharey=True)
    for span, title in SPANS.items():
        lines: dict[tuple, list] = {}
        for row in times:
            if row["span"] == span:
                point = row["microseconds_per_point"], min(worst[_key(row)], NO_DIGIT)
                line = row["method"], row["medium"], row["bodies"]
                lines.setdefault(line, []).append(point)
        series: list[Series] = []
        axes = figure.add_panel(Panel(title, "microseconds_per_point", "largest_error", series))
        for (method, *kind), points in lines.items():
            x, y = np.transpose(points)
            series.append(Series(CURVE, f"{' '.join(kind)}; {method}", x, y))
            axes.plot(x, y, **CLASSES[tuple(kind)] | METHODS[method][1])
        axes.set(xscale="log", yscale="log", ylim=(0.2 * ALL_DIGITS, 5.0 * NO_DIGIT))
        axes.grid(True, color="0.9", linewidth=0.5)
        axes.set_xlabel("processor time a point (µs)")
    figure.axes[0].set_ylabel("largest relative error")
    # classes by colour and marker, methods by line and filling
    looks = {" ".join(kind).replace("_", "-"): look for kind, look in CLASSES.items()}
    looks |= {text: {"color": "0.4", "marker": "o"} | look for text, look in METHODS.values()}
    entries = [Line2D([], [], label=text, **look) for text, look in looks.items()]
    figure.legend(handles=entries, loc="outside lower center", ncols=4)
    return figure


def _key(row):
    return row["method"], row["rtol"], row["medium"], row["bodies"], row["span"]
