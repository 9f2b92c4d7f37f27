"""Marks in panels: turning points of the contact area (TPCA), statuses of points, and printed
numbers with their tolerances, through which curves should pass.

A printed number at a point of a curve (``A_sa,t*`` at the turning point, for example) is drawn at
the other printed coordinate of this point, or otherwise at that of the curve.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from os import PathLike
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from matplotlib.lines import Line2D

from thirdbody.data.conditions import CONDITION_AXES, Condition, condition_key, row_key
from thirdbody.data.quantities import STATUS
from thirdbody.data.tables import TABLES, read_csv
from thirdbody.figures.drawing import Panel, Series
from thirdbody.figures.scales import SCALES
from thirdbody.model.regimes import BOUNDARY_LIMIT, SOLUTION_STATUSES, WITHOUT_VALUES

if TYPE_CHECKING:
    from thirdbody.figures.curves import Curve

TURNING_POINTS, LOCUS = "turning points", "locus of the turning points"
WINDOW, PRINTED, TOLERANCE, BAND = "window", "printed", "tolerance", "band"
# markers of points that have not converged; the curve ends where there are no values
STATUSES = dict(zip(SOLUTION_STATUSES[1:], "+x1234", strict=True))
POINTS = {"linestyle": "none", "zorder": 3.2}
LINE = {"linestyle": (0, (2.5, 1.2)), "linewidth": 2.2, "color": "C1", "zorder": 2.9}
CROSS = POINTS | {"markersize": 5.0, "markeredgewidth": 0.9, "color": "#A0005A"}
STAR = POINTS | {
    "marker": "*",
    "markersize": 8.0,
    "markerfacecolor": "C1",
    "markeredgecolor": "black",
}
SQUARE = POINTS | {"marker": "s", "markersize": 9.0, "markerfacecolor": "none", "zorder": 2.8}
SQUARE |= {"markeredgewidth": 1.1, "color": "black", "clip_on": False}
# kind of series: text in the legend, line properties
MARKS = {
    TURNING_POINTS: ("turning point (TPCA)", STAR),
    LOCUS: ("locus of turning points", LINE),
    WINDOW: ("limits of turning points", {"color": "C5", "linewidth": 1.8}),
    PRINTED: ("printed, with tolerance", SQUARE),
} | {name: (name.replace("_", " "), CROSS | {"marker": mark}) for name, mark in STATUSES.items()}
PRINTED_LIMIT = "printed limits, with tolerance", {"color": "black", "linestyle": "--"}
BAND_ENTRY = "ensemble range", {"color": "0.82", "linewidth": 6.0}

RATIO, SOLID = "particle_contact_area_ratio", "solid_load_fraction"
AREA, RELATIVE_AREA = "total_contact_area", "total_contact_area_over_two_body"
MIXED = "bend_load_over_mixed_load"
# panels over the load for numbers that are not variables: loads of a bend or a reversal, and those
# of a turning point
LOADS = {
    "bend_load": (AREA,),
    MIXED: (AREA,),
    "total_contact_area_reversal_load": (AREA, RELATIVE_AREA),
}
AT_TURNING_POINT = {
    "turning_point_load": RATIO,
    "turning_point_ratio": RATIO,
    "turning_point_solid_load_fraction": SOLID,
    "turning_point_solid_load": SOLID,
}


def read_turning_points(path: str | PathLike) -> list[dict[str, float]]:
    """Turning points from a file of the table ``tpca_loads``: the four conditions [SI], ``load``
    and ``peak_ratio``; ``OSError`` in one line if the file is damaged."""
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
    """First and last points with a status other than ``converged``, and ends of curves without values."""
    for status in STATUSES:
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
    """Legend entries for the marks in ``panels``."""
    kinds = {series.kind for panel in panels if not panel.is_over_sizes for series in panel.series}
    limits = {series.kind for panel in panels if panel.is_over_sizes for series in panel.series}
    entries = [entry for kind, entry in MARKS.items() if kind in kinds | limits - {PRINTED}]
    entries += [PRINTED_LIMIT] if PRINTED in limits else []
    entries += [BAND_ENTRY] if BAND in kinds else []
    return [Line2D([], [], label=text, **look) for text, look in entries]


class Mark(NamedTuple):
    """A printed number in a panel: its position, and the ends of its tolerance along ``x`` or ``y``."""

    x: float
    y: float
    ends: tuple[float, float]
    along: str

    def series(self, name: str, condition: Condition | None = None) -> Iterator[Series]:
        """Series of the number and of its tolerance."""
        bar = (self.ends, (self.y,) * 2) if self.along == "x" else ((self.x,) * 2, self.ends)
        yield Series(PRINTED, name, np.array([self.x]), np.array([self.y]), condition)
        yield Series(TOLERANCE, name, *np.array(bar), condition)


def printed_series(
    x: str, y: str, curves: Sequence[Curve], printed: Sequence[Mapping]
) -> Iterator[Series]:
    """Printed numbers of ``curves``, rows of the table ``printed``, in a panel of ``x`` and ``y``;
    each position is shown once, even if several curves have it."""
    drawn: set[Mark] = set()
    for curve in curves:
        key = condition_key(curve.condition)
        rows = [row for row in printed if row_key(row) == key]
        numbers = {row["quantity"]: row["value"] for row in reversed(rows)}
        marks = [(row["id"], _mark(curve, row, numbers, x, y)) for row in rows]
        new = [(name, mark) for name, mark in marks if mark and mark not in drawn]
        for name, mark in new:
            yield from mark.series(name, curve.condition)
            drawn.add(mark)


def _mark(curve, row, numbers, x, y) -> Mark | None:
    """The mark of ``row`` in a panel of ``x`` and ``y``, or None; ``numbers`` are those of the curve."""
    quantity, value, ends = row["quantity"], row["value"], (row["low"], row["high"])
    if x == quantity == "film_thickness":
        return Mark(value, curve.at(y, _extreme(curve, row)), ends, "x")
    if x != "load":
        return None
    if y == quantity:
        if SCALES[y].limits:  # a fraction
            ends = tuple(np.clip(ends, 0.0, 1.0))
        return Mark(_load_of(curve, row), value, ends, "y")
    if quantity == "load" and y == row["at_quantity"]:
        return Mark(value, row["at_level"], ends, "x")
    if y in LOADS.get(quantity, ()):
        unit = _falls_to(curve, SOLID, BOUNDARY_LIMIT) if quantity == MIXED else 1.0
        load, low, high = (unit * each for each in (value, *ends))
        return Mark(load, curve.at(y, load), (low, high), "x")
    if y != AT_TURNING_POINT.get(quantity):
        return None
    if quantity == "turning_point_load":
        found = curve.turning_point.get("peak_ratio", curve.at(y, value))
        return Mark(value, numbers.get("turning_point_ratio", found), ends, "x")
    highest = float(curve.values("load")[np.argmax(curve.values(RATIO))])
    load = numbers.get("turning_point_load", curve.turning_point.get("load", highest))
    # L_s = L_s F_t*/F_t*
    unit = 1.0 / load if quantity == "turning_point_solid_load" else 1.0
    low, high = np.clip([unit * end for end in ends], 0.0, 1.0)
    return Mark(load, unit * value, (low, high), "y")


def _load_of(curve, row) -> float:
    """The load of the printed number in ``row``."""
    if row["at_quantity"] == "load":
        return row["at_level"]
    if row["at_quantity"]:
        return _falls_to(curve, row["at_quantity"], row["at_level"])
    return _extreme(curve, row)


def _falls_to(curve, name, level) -> float:
    """The load at which the variable ``name`` last falls below ``level``, or the last load."""
    below = curve.values(name) < level
    falls = np.flatnonzero(below[1:] & ~below[:-1])
    return float(curve.values("load")[falls[-1] + 1 if falls.size else -1])


def _extreme(curve, row) -> float:
    """The load of the extreme of the curve in ``row``."""
    load = curve.values("load")
    within = load <= (row["load_max"] or np.inf)
    within &= curve.values("normal_load") <= (row["load_max_N"] or np.inf)
    values = curve.values(row["quantity"])[within]
    wanted = values.min() if row["extreme"] == "minimum" else values.max()
    found = np.flatnonzero(values == wanted)
    # A constant curve has it everywhere.  The paper means loads up to the last one, and the
    # fractions of solids and particles decrease with the load.
    is_last = row["load_max"] or row["extreme"] == "minimum"
    return float(load[found[-1 if is_last else 0]])
