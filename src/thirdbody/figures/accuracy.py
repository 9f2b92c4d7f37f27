"""What accuracy costs: largest error against time per point, a curve a class of points."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
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
LABELLED = (
    "library",
    "lubricated",
    "three_body",
)  # whose points have some of their rtol beside them
LABELS = (1e-2, 1e-3, 1e-6, 1e-9, 1e-11)
LABEL = {"xytext": (7, 0), "textcoords": "offset points", "va": "center", "zorder": 5} | {
    "bbox": {"facecolor": "white", "edgecolor": "none", "pad": 0.6},
    "fontsize": 7,
}


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
        lines: dict[tuple, list] = {}
        for method, rtol, *contact, where in cost:
            if where == span:
                lines.setdefault((method, *contact), []).append((method, rtol, *contact, where))
        series = []
        for (method, *contact), keys in lines.items():
            x = np.array([cost[key] for key in keys])
            y = np.clip([worst[key] for key in keys], ALL_DIGITS, NO_DIGIT)
            series.append(Series(CURVE, f"{' '.join(contact)}; {method}", x, y))
            look = LOOKS[tuple(contact)]
            axes.plot(x, y, **look | METHODS[method][1])
            for (_, rtol, *_), *point in zip(keys, x, y, strict=True):
                if (method, *contact) == LABELLED and rtol in LABELS:
                    axes.annotate(power_text(rtol), point, color=look["color"], **LABEL)
        quantities = "microseconds_per_point", "largest_error"
        panels.append(Panel(letter, title, *quantities, tuple(series)))
        title_axes(axes, panels[-1])
        axes.set(xscale="log", yscale="log", ylim=(0.2 * ALL_DIGITS, 5.0 * NO_DIGIT))
        axes.grid(True, color="0.9", linewidth=0.5)
        axes.set_xlabel("processor time a point (µs)")
    all_axes[0].set_ylabel("largest relative error")
    # classes by colour and marker, methods by line and filling
    looks = {" ".join(contact).replace("_", "-"): look for contact, look in LOOKS.items()}
    looks |= {text: {"color": "0.4", "marker": "o"} | look for text, look in METHODS.values()}
    entries = [Line2D([], [], label=text, **look) for text, look in looks.items()]
    figure.legend(handles=entries, loc="outside lower center", ncols=4)
    return Drawing(figure, tuple(panels))


def _key(row):
    return row["method"], row["rtol"], row["medium"], row["bodies"], row["span"]
