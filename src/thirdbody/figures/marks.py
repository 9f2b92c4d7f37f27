"""What panels show beside curves: turning points of the contact area (TPCA), statuses of points."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from os import PathLike

import numpy as np
from matplotlib.lines import Line2D

from thirdbody.data.conditions import CONDITION_AXES
from thirdbody.data.quantities import STATUS
from thirdbody.data.tables import TABLES, read_csv
from thirdbody.figures.dataset_curves import Curve
from thirdbody.figures.drawing import Panel, Series
from thirdbody.model.regimes import SOLUTION_STATUSES, WITHOUT_VALUES

TURNING_POINTS, LOCUS = "turning points", "locus of the turning points"
WINDOW, PRINTED, TOLERANCE, BAND = "window", "printed", "tolerance", "band"
# statuses that are marked: text of the key, marker; where there are no values the curve ends
STATUS_MARKS = {
    "several_separations": ("several balances: the widest", "+"),
    "outside_film_formula": ("film outside its formula", "x"),
    "area_exceeded": ("contact area above 1", "1"),
    "not_converged": ("less accurate than asked", "2"),
    "coverage_exceeded": ("none beyond: particles cover all", "3"),
    "load_exceeded": ("none beyond: load not carried", "4"),
}
POINTS = {"linestyle": "none", "zorder": 3.2}
STATUS_LOOK = POINTS | {"markersize": 5.0, "markeredgewidth": 0.9, "color": "#A0005A"}
STAR = POINTS | {"marker": "*", "markersize": 8.0, "markerfacecolor": "C1"}
SQUARE = POINTS | {"marker": "s", "markersize": 9.0, "markerfacecolor": "none", "zorder": 2.8}
# kind of series: text in the key, line properties
MARKS = {
    TURNING_POINTS: ("turning point (TPCA)", STAR | {"markeredgecolor": "black"}),
    LOCUS: (
        "locus of turning points",
        {"linestyle": (0, (2.5, 1.2)), "linewidth": 2.2, "color": "C1", "zorder": 2.9},
    ),
    WINDOW: ("limits of turning points", {"color": "C5", "linewidth": 1.8}),
    PRINTED: (
        "printed, with tolerance",
        SQUARE | {"markeredgewidth": 1.1, "color": "black", "clip_on": False},
    ),
} | {
    kind: (text, STATUS_LOOK | {"marker": marker}) for kind, (text, marker) in STATUS_MARKS.items()
}
PRINTED_LIMIT = "printed limits, with tolerance", {"color": "black", "linestyle": "--"}
BAND_ENTRY = "ensemble range", {"color": "0.82", "linewidth": 6.0}


def read_turning_points(path: str | PathLike) -> list[dict[str, float]]:
    """Turning points from a file of the table ``tpca_loads``: the four conditions [SI], ``load`` and
    ``peak_ratio`` of each; ``OSError`` in one line if the file is damaged."""
    columns = {axis.name: axis.column for axis in CONDITION_AXES}
    columns |= {"load": "load", "peak_ratio": "peak_ratio"}
    return [
        {name: row[column] for name, column in columns.items()}
        for row in read_csv(path, TABLES["tpca_loads"])
    ]


def turning_point_series(x: str, y: str, curves: Sequence[Curve], kind: str) -> Iterator[Series]:
    """The turning points of ``curves`` in a panel of ``x`` and ``y`` as one series, if there are any."""
    marked = [curve for curve in curves if curve.turning_point]
    if marked:
        places = [[one.at(name, one.turning_point["load"]) for one in marked] for name in (x, y)]
        yield Series(kind, "", *np.array(places))


def status_series(x: str, y: str, curves: Sequence[Curve]) -> Iterator[Series]:
    """First and last points whose status is not ``converged``, and ends of curves without values."""
    for status in STATUS_MARKS:
        for curve in curves:
            marked = curve.values(STATUS) == SOLUTION_STATUSES.index(status)
            if status in WITHOUT_VALUES:
                beside = np.append(marked[1:], False) | np.append(False, marked[:-1])
                marked = beside & np.isfinite(curve.values(y))
            places = np.flatnonzero(marked)
            if places.size:
                ends = np.unique(places[[0, -1]])
                points = (curve.values(name)[ends] for name in (x, y))
                yield Series(status, curve.label, *points, curve.condition)


def mark_entries(panels: Sequence[Panel]) -> list[Line2D]:
    """Entries of the key for the marks that ``panels`` show."""
    kinds = {series.kind for panel in panels if not panel.is_over_sizes for series in panel.series}
    limits = {series.kind for panel in panels if panel.is_over_sizes for series in panel.series}
    entries = [entry for kind, entry in MARKS.items() if kind in kinds | limits - {PRINTED}]
    entries += [PRINTED_LIMIT] if PRINTED in limits else []
    entries += [BAND_ENTRY] if BAND in kinds else []
    return [Line2D([], [], label=text, **look) for text, look in entries]
