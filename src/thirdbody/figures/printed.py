"""The paper's printed numbers: open marks with their tolerances, where the curves should pass.

A number that stands for a place on a curve (``A_sa,t*`` at the turning point, say) is drawn at the
other number that the paper prints of this place, or else where the curve has it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from os import PathLike

import numpy as np
import xarray as xr

from thirdbody.data.conditions import CONDITION_AXES
from thirdbody.data.tables import TABLES, read_csv
from thirdbody.figures.marks import PRINTED, condition_key
from thirdbody.figures.sheet.panel import NamedPoints, Panel
from thirdbody.figures.sheet.scales import SCALES
from thirdbody.figures.sheet.styles import Styles
from thirdbody.figures.shown import AREA_OVER_TWO_BODY, Curve
from thirdbody.model.regimes import BOUNDARY_LIMIT

RATIO, SOLID, AREA = "particle_contact_area_ratio", "solid_load_fraction", "total_contact_area"
STACKED = 0.055  # height from one printed window to the next
# panels over the load that show a number which is no variable of theirs
SHOWN_ON = {
    "turning_point_load": (RATIO,),
    "turning_point_ratio": (RATIO,),
    "turning_point_solid_load_fraction": (SOLID,),
    "turning_point_solid_load": (SOLID,),
    "bend_load": (AREA,),
    "bend_load_over_mixed_load": (AREA,),
    "total_contact_area_reversal_load": (AREA, AREA_OVER_TWO_BODY),
}


@dataclass(frozen=True)
class Mark:
    """A printed number in a panel: its place, and how far its tolerance reaches along an axis."""

    name: str
    x: float
    y: float
    reach: tuple[float, float]
    along: str  # "x" or "y"


def read_printed(path: str | PathLike, figure: str) -> list[dict]:
    """Rows of the table ``printed`` that belong to ``figure``.

    Raises
    ------
    OSError
        If the file is damaged: one line names it.
    """
    return [row for row in read_csv(path, TABLES["printed"]) if row["figure"] == figure]


def draw_printed(
    panel: Panel,
    data: xr.Dataset,
    curves: Sequence[Curve],
    printed: Sequence[Mapping],
    turning_points: Sequence[tuple[Curve, Mapping]],
    styles: Styles,
) -> None:
    """Draw the printed numbers that ``panel`` has room for, in the colours of their curves.

    Parameters
    ----------
    panel : Panel
        Where to draw; its curves must stand in it.
    data : xarray.Dataset
        The dataset of the curves.
    curves : sequence of Curve
        Those of the panel.
    printed : sequence of Mapping
        Rows of ``read_printed``.
    turning_points : sequence of (Curve, Mapping)
        Pairs of ``turning_points_of``.
    styles : Styles
        What tells the curves apart.
    """
    of_curve: dict[tuple, list] = {}
    for row in printed:
        conditions = [row[axis.column] for axis in CONDITION_AXES]
        if None not in conditions:
            of_curve.setdefault(condition_key(conditions), []).append(row)
    turning = {curve.place: point for curve, point in turning_points}
    drawn = set()
    for curve in curves:
        rows = of_curve.get(condition_key(curve.condition), ())
        place = _Places(data, curve, rows, turning.get(curve.place))
        marks = [mark for row in rows for mark in place.marks(row, panel.x_name, panel.y_name)]
        new = [mark for mark in marks if (mark.x, mark.y, mark.reach) not in drawn]
        drawn.update((mark.x, mark.y, mark.reach) for mark in new)
        draw_marks(panel, new, styles.of(curve.condition)["color"])


def draw_marks(panel: Panel, marks: Sequence[Mark], colour) -> None:
    """Draw ``marks`` as open squares over bars that reach as far as their tolerances."""
    if not marks:
        return
    names = [f"printed; {mark.name}" for mark in marks]
    points = [(mark.x, mark.y) for mark in marks]
    bars = [_bar(mark, SCALES[panel.y_name].share) for mark in marks]
    tolerances = [f"tolerance; {mark.name}" for mark in marks]
    panel.add_bars(bars, tolerances, colour, linewidths=PRINTED["markeredgewidth"], zorder=3.5)
    look = PRINTED | {"color": colour, "label": "printed", "zorder": 3.4}
    panel.add_line(NamedPoints(points, names, **look))


def _bar(mark, share) -> list[tuple[float, float]]:
    """Both ends of the tolerance of ``mark``; that of a ``share`` ends with it."""
    if mark.along == "x":
        return [(end, mark.y) for end in mark.reach]
    low, high = mark.reach
    return [(mark.x, max(low, 0.0) if share else low), (mark.x, min(high, 1.0) if share else high)]


class _Places:
    """Where the printed numbers of one curve belong.

    Parameters
    ----------
    data : xarray.Dataset
        The dataset of the curve.
    curve : Curve
        The curve.
    rows : sequence of Mapping
        Its rows of the table ``printed``.
    turning_point : Mapping, optional
        Its turning point, if it has one.
    """

    def __init__(self, data, curve, rows, turning_point):
        self.data, self.curve = data, curve
        self.load = data["load"].values
        self.printed = {row["quantity"]: row["value"] for row in reversed(rows)}
        self.turning_point = turning_point

    def marks(self, row, x_name, y_name):
        """The mark of ``row`` in a panel of these variables, if it shows what the row tells."""
        quantity, reach = row["quantity"], (row["low"], row["high"])
        if x_name == quantity == "film_thickness":
            y = self.at(y_name, self.extreme(row))
            return [Mark(row["id"], row["value"], y, reach, "x")]
        if x_name != "load":
            return []
        if y_name == quantity:
            return [Mark(row["id"], self.where(row), row["value"], reach, "y")]
        if quantity == "load" and y_name == row["at_quantity"]:
            return [Mark(row["id"], row["value"], row["at_level"], reach, "x")]
        if y_name not in SHOWN_ON.get(quantity, ()):
            return []
        if quantity == "bend_load_over_mixed_load":
            mixed = self.falls_to(SOLID, BOUNDARY_LIMIT)
            x, low, high = (mixed * value for value in (row["value"], *reach))
            return [Mark(row["id"], x, self.at(y_name, x), (low, high), "x")]
        if quantity.endswith("_load") and quantity != "turning_point_solid_load":
            y = self.at(y_name, row["value"])
            if quantity == "turning_point_load":
                y = self.turning_ratio(y)
            return [Mark(row["id"], row["value"], y, reach, "x")]
        x = self.turning_load()
        scale = 1.0 / x if quantity == "turning_point_solid_load" else 1.0  # L_s = L_s F_t*/F_t*
        low, high = scale * reach[0], scale * reach[1]
        return [Mark(row["id"], x, scale * row["value"], (low, high), "y")]

    def at(self, name, load) -> float:
        """The curve's value of the variable ``name`` at ``load``."""
        return float(np.interp(np.log(load), np.log(self.load), self.values(name)))

    def values(self, name):
        """The variable ``name`` along the curve."""
        return self.curve.values(self.data, name)

    def turning_load(self) -> float:
        """Load of the turning point: as printed, or as found, or where A_sa,t* is largest."""
        if "turning_point_load" in self.printed:
            return self.printed["turning_point_load"]
        if self.turning_point is not None:
            return self.turning_point["load"]
        return float(self.load[np.argmax(self.values(RATIO))])

    def turning_ratio(self, otherwise) -> float:
        """A_sa,t* at the turning point: as printed, or as found, or else another."""
        if "turning_point_ratio" in self.printed:
            return self.printed["turning_point_ratio"]
        return otherwise if self.turning_point is None else self.turning_point["peak_ratio"]

    def where(self, row) -> float:
        """The load at which the number of ``row`` is printed."""
        if row["at_quantity"] == "load":
            return row["at_level"]
        if row["at_quantity"]:
            return self.falls_to(row["at_quantity"], row["at_level"])
        return self.extreme(row)

    def falls_to(self, name, level) -> float:
        """The load at which the variable ``name`` last falls below ``level``, or the last load."""
        below = self.values(name) < level
        falls = np.flatnonzero(below[1:] & ~below[:-1])
        return float(self.load[falls[-1] + 1 if falls.size else -1])

    def extreme(self, row) -> float:
        """The load of the curve's extreme that ``row`` speaks of."""
        within = self.load <= (row["load_max"] or np.inf)
        within &= self.data["normal_load"].values <= (row["load_max_N"] or np.inf)
        values = self.values(row["quantity"])[within]
        found = np.flatnonzero(
            values == (values.min() if row["extreme"] == "minimum" else values.max())
        )
        # A constant curve has it everywhere: the end of what the paper speaks of tells most, or high
        # loads of a least share, as shares of the solid and of particles fall with the load.
        is_last = row["load_max"] or row["extreme"] == "minimum"
        return float(self.load[found[-1 if is_last else 0]])


def draw_printed_windows(
    panel: Panel, printed: Sequence[Mapping], roughness: float, height: float
) -> None:
    """Draw the printed windows on the surface of ``roughness`` [m], below each other from ``height``."""
    here = [
        row for row in printed if row["quantity"].startswith("window") and _is_at(row, roughness)
    ]
    heights = {
        name: height - STACKED * rank
        for rank, name in enumerate(dict.fromkeys(row["id"] for row in here), start=1)
    }
    marks = [
        Mark(row["id"], row["value"], heights[row["id"]], (row["low"], row["high"]), "x")
        for row in here
    ]
    draw_marks(panel, marks, "black")


def _is_at(row, roughness) -> bool:
    return bool(np.isclose(row["roughness_m"], roughness, rtol=1e-9))
