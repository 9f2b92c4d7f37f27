"""Turning points of the contact area (TPCA): read, matched to their curves, marked."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from os import PathLike

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from thirdbody.data.conditions import CONDITION_AXES, Condition
from thirdbody.data.tables import TABLES, read_csv
from thirdbody.figures.sheet.key import Entry
from thirdbody.figures.sheet.panel import NamedPoints, Panel
from thirdbody.figures.shown import Curve
from thirdbody.model.regimes import WITHOUT_VALUES

TURNING_POINTS = {
    "linestyle": "none",
    "marker": "*",
    "markersize": 8.0,
    "markerfacecolor": "C1",
    "markeredgecolor": "black",
}
LOCUS = {"linestyle": (0, (2.5, 1.2)), "linewidth": 2.2, "color": "C1"}
STATUS_STEP = 6  # points of a curve from one mark of their status to the next
# where the status of a point is not plain ``converged``: text of the key, marker; points without
# values have it at the end of the curve beside them
STATUS_MARKS = {
    "several_separations": ("several balances: the widest", "+"),
    "outside_film_formula": ("film outside its formula", "x"),
    "area_exceeded": ("contact area above 1", "1"),
    "not_converged": ("less exact than asked", "2"),
    "coverage_exceeded": ("none beyond: particles cover all", "3"),
    "load_exceeded": ("none beyond: load not borne", "4"),
}
STATUS_LOOK = {"markersize": 5.0, "markeredgewidth": 0.9, "color": "#A0005A", "zorder": 3.2}
# open marks of what the paper prints, over bars as far as its tolerance
PRINTED = {
    "linestyle": "none",
    "marker": "s",
    "markersize": 5.2,
    "markerfacecolor": "white",
    "markeredgewidth": 1.1,
    "color": "black",
}
WINDOW = {"linestyle": "-", "linewidth": 1.1, "marker": "d", "markersize": 6.0, "color": "C5"}
# label of what is drawn: its text in the key, its style
MARKS = {
    "turning points": ("turning point (TPCA)", TURNING_POINTS),
    "locus of the turning points": ("their locus", LOCUS),
    "window": ("their window", WINDOW),
    "printed": ("printed, with tolerance", PRINTED),
} | {
    meaning: (text, STATUS_LOOK | {"marker": marker, "linestyle": "none"})
    for meaning, (text, marker) in STATUS_MARKS.items()
}


def read_turning_points(path: str | PathLike) -> list[dict[str, float]]:
    """Turning points from a file of the table ``tpca_loads``.

    Returns
    -------
    list of dict
        The four conditions (SI), ``load`` and ``peak_ratio`` of each.

    Raises
    ------
    OSError
        If the file is damaged: one line names it.
    """
    return [
        {axis.name: row[axis.column] for axis in CONDITION_AXES}
        | {name: row[name] for name in ("load", "peak_ratio")}
        for row in read_csv(path, TABLES["tpca_loads"])
    ]


def turning_points_of(
    curves: Sequence[Curve], turning_points: Iterable[Mapping]
) -> list[tuple[Curve, Mapping]]:
    """Pairs of a curve and its turning point, where it has one."""
    found = {
        condition_key(point[name] for name in Condition._fields): point for point in turning_points
    }
    keys = [condition_key(curve.condition) for curve in curves]
    return [(curve, found[key]) for curve, key in zip(curves, keys, strict=True) if key in found]


def mark_turning_points(
    panel: Panel,
    data: xr.Dataset,
    marked: Sequence[tuple[Curve, Mapping]],
    label: str = "turning points",
) -> None:
    """Draw a mark at turning points, if there are any.

    Parameters
    ----------
    panel : Panel
        Where to draw.
    data : xarray.Dataset
        The dataset of the curves.
    marked : sequence of (Curve, Mapping)
        Pairs of ``turning_points_of``.
    label : str
        Which of ``MARKS``.
    """
    if marked:
        load = np.log(data["load"].values)
        x, y = (
            [
                np.interp(np.log(point["load"]), load, curve.values(data, name))
                for curve, point in marked
            ]
            for name in (panel.x_name, panel.y_name)
        )
        panel.add_line(Line2D(x, y, label=label, zorder=3, **MARKS[label][1]))


def mark_statuses(panel: Panel, data: xr.Dataset, curves: Sequence[Curve]) -> None:
    """Draw marks along ``curves`` where the status of their points is not plain ``converged``, and at
    the ends next to points without values."""
    status = data["solution_status"].attrs
    values = dict(zip(status["flag_meanings"].split(), status["flag_values"], strict=True))
    for meaning, (_, marker) in STATUS_MARKS.items():
        points, names = [], []
        for curve in curves:
            marked = curve.values(data, "solution_status") == values[meaning]
            if meaning in WITHOUT_VALUES:
                marked = _beside(marked) & np.isfinite(curve.values(data, panel.y_name))
            places = np.flatnonzero(marked)
            for place in _some_of_each_run(places):
                names.append(f"{meaning}; {curve.label}")
                points.append(
                    [curve.values(data, name)[place] for name in (panel.x_name, panel.y_name)]
                )
        if points:
            panel.add_line(NamedPoints(points, names, label=meaning, marker=marker, **STATUS_LOOK))


def _beside(these) -> NDArray[np.bool_]:
    """Which points are next to some of ``these``."""
    return np.convolve(these, [1, 0, 1], "same") > 0


def _some_of_each_run(places) -> NDArray[np.intp]:
    """Of ``places``, the ends of each run without gaps and every ``STATUS_STEP`` within."""
    runs = np.split(places, np.flatnonzero(np.diff(places) > 1) + 1)
    return np.concatenate([np.union1d(run[::STATUS_STEP], run[-1:]) for run in runs])


def mark_entries(figure: Figure) -> list[Entry]:
    """Text and style of the marks that ``figure`` shows, for its key."""
    drawn = {line.get_label() for panel in figure.axes for line in panel.lines}
    return [entry for label, entry in MARKS.items() if label in drawn]


def condition_key(values: Iterable[float]) -> tuple[str, ...]:
    """Conditions free of the rounding of files."""
    return tuple(f"{value:.9g}" for value in values)
