"""Turning points of the contact area (TPCA): read, matched to their curves, marked."""

from __future__ import annotations

import numpy as np
from matplotlib.lines import Line2D

from thirdbody.data.conditions import CONDITION_AXES, Condition
from thirdbody.data.tables import TABLES, read_csv
from thirdbody.model.regimes import PARTICLE_LIMIT

TURNING_POINTS = {
    "linestyle": "none",
    "marker": "*",
    "markersize": 8.0,
    "markerfacecolor": "C1",
    "markeredgecolor": "black",
}
LOCUS = {"linestyle": (0, (2.5, 1.2)), "linewidth": 2.2, "color": "C1"}
# label of what is drawn: its text in the key, its style
MARKS = {
    "turning points": ("turning point (TPCA)", TURNING_POINTS),
    "locus of the turning points": ("their locus", LOCUS),
}


def read_turning_points(path) -> list[dict]:
    """Conditions (SI), load and peak ratio of each row of the table ``tpca_loads`` at ``path``."""
    return [
        {axis.name: row[axis.column] for axis in CONDITION_AXES}
        | {name: row[name] for name in ("load", "peak_ratio")}
        for row in read_csv(path, TABLES["tpca_loads"])
    ]


def turning_points_of(curves, turning_points):
    """Pairs of a curve and its turning point, where it has one within the hybrid mode.

    A curve whose ratio rises above the limit of the p-s mode has a maximum too, but the contact
    then leaves the hybrid mode: by section 3.3 that is no turning point.
    """
    found = {
        _key(point[name] for name in Condition._fields): point
        for point in turning_points
        if point["peak_ratio"] < PARTICLE_LIMIT
    }
    keys = [_key(curve.condition) for curve in curves]
    return [(curve, found[key]) for curve, key in zip(curves, keys, strict=True) if key in found]


def mark_turning_points(panel, data, marked, label="turning points"):
    """Draw the mark ``label`` at ``marked``, pairs of a curve and its turning point, if any."""
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


def mark_entries(figure):
    """Text and style of the marks that ``figure`` shows, for its key."""
    drawn = {line.get_label() for panel in figure.axes for line in panel.lines}
    return [entry for label, entry in MARKS.items() if label in drawn]


def _key(values):
    """Conditions free of the rounding of files."""
    return tuple(f"{value:.9g}" for value in values)
