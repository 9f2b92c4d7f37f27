"""The work-precision figure: time of a point over the largest true error, of the library and of a
plain solver.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import matplotlib.style
import numpy as np
from matplotlib.figure import Figure

from thirdbody.plotting.drawing import STYLE, TWO_COLUMNS, Drawing

HEIGHT = 2.9  # inches
METHODS = {  # label, form and size: marks at the same place are both seen
    "library": ("tb.solve, rtol 1e-2 to 1e-11", "o-", 3.5),
    "library_grid": ("tb.grid, rtol written at the points", "s-", 6.5),
    "nested_roots": ("quad and brentq, a point at a time", "^", 5.0),
}
DECADES = 0.5  # points of the grid whose errors are closer than this have one text
SPANS = {"usual": "conditions of Table 2", "extremes": "extreme conditions"}
Rows = Sequence[Mapping[str, Any]]


def largest_errors(rows: Rows) -> dict[tuple, float]:
    """Largest true error of rows of ``errors``, by method, ``rtol`` and span."""
    found: dict[tuple, float] = {}
    for row in rows:
        key = row["method"], row["rtol"], row["span"]
        found[key] = max(found.get(key, 0.0), row["largest_error"])
    return found


@matplotlib.style.context(STYLE, after_reset=True)
def draw(errors: Rows, times: Rows) -> Figure:
    """The figure, from rows of the tables ``errors`` and ``times``."""
    error = largest_errors(errors)
    figure = Drawing(figsize=(TWO_COLUMNS, HEIGHT), layout="constrained")
    panels = figure.subplots(1, len(SPANS), sharex=True, sharey=True)
    for axes, (span, title) in zip(panels, SPANS.items(), strict=True):
        for method, (label, form, size) in METHODS.items():
            here = [row for row in times if (row["method"], row["span"]) == (method, span)]
            errors_here = [error[method, row["rtol"], span] for row in here]
            axes.loglog(
                errors_here,
                [row["microseconds_per_point"] for row in here],
                form,
                label=label,
                markersize=size,
                markerfacecolor=None if method == "library" else "none",
                zorder=3.0 if method == "library" else 2.0,  # in front
            )
            if method == "library_grid":
                _name_tolerances(axes, here, errors_here)
        axes.set_title(title, loc="left")
        axes.margins(x=0.1)
        axes.set_xlabel("largest relative error of any variable")
    panels[0].set_ylabel("time a point [µs]")
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=2)
    return figure


def _name_tolerances(axes, rows, errors) -> None:
    """Write ``rtol`` above the points of the grid, once for points of about the same error."""
    places: dict[int, list[tuple]] = {}
    for row, error in zip(rows, errors, strict=True):
        point = row["rtol"], error, row["microseconds_per_point"]
        places.setdefault(round(np.log10(error) / DECADES), []).append(point)
    for points in places.values():
        tolerances, errors, times = zip(*points, strict=True)
        ends = dict.fromkeys(
            f"{each:.0e}".replace("e-0", "e-") for each in (max(tolerances), min(tolerances))
        )
        axes.annotate(
            " to ".join(ends),
            (np.mean(errors), max(times)),
            (0.0, 5.0),
            textcoords="offset points",
            fontsize=7.0,
            rotation=50.0,
            rotation_mode="anchor",
        )
