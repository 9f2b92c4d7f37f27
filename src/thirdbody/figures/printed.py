"""The numbers that the paper prints, with their tolerances, where curves should pass through them.

A number that stands for a place on a curve (``A_sa,t*`` at the turning point, say) is drawn at the
other number that the paper prints of this place, or else where the curve has it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from thirdbody.data.conditions import Condition, condition_key, row_key
from thirdbody.data.plain import PlainDataset
from thirdbody.figures.dataset_curves import AREA_OVER_TWO_BODY, Curve
from thirdbody.figures.drawing import Series
from thirdbody.figures.marks import PRINTED, TOLERANCE
from thirdbody.figures.scales import SCALES
from thirdbody.model.regimes import BOUNDARY_LIMIT

RATIO, SOLID, AREA = "particle_contact_area_ratio", "solid_load_fraction", "total_contact_area"
# panels over the load that show a number which is no variable of theirs
DRAWN_ON = {
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
    """A printed number in a panel: its place, and the ends of its tolerance along ``x`` or ``y``."""

    x: float
    y: float
    ends: tuple[float, float]
    along: str

    def series(self, name: str, is_fraction: bool = False, condition: Condition | None = None):
        """Its place and its tolerance as series; that of a fraction ends at 0 and 1."""
        low, high = np.clip(self.ends, 0.0, 1.0) if is_fraction and self.along == "y" else self.ends
        bar = ((low, high), (self.y,) * 2) if self.along == "x" else ((self.x,) * 2, (low, high))
        yield Series(PRINTED, name, np.array([self.x]), np.array([self.y]), condition)
        yield Series(TOLERANCE, name, *np.array(bar), condition)


def printed_series(
    data: PlainDataset,
    x: str,
    y: str,
    curves: Sequence[Curve],
    printed: Sequence[Mapping],
    turning_points: Sequence[tuple[Curve, Mapping]],
) -> Iterator[Series]:
    """Printed numbers of ``curves`` that a panel of ``x`` and ``y`` can show.

    ``printed`` are rows of the table of this name, ``turning_points`` pairs of ``turning_points_of``.
    """
    rows_of: dict[tuple, list] = {}
    for row in printed:
        rows_of.setdefault(row_key(row), []).append(row)
    turning = {curve.place: point for curve, point in turning_points}
    drawn = set()
    for curve in curves:
        rows = rows_of.get(condition_key(curve.condition), ())
        places = _Places(data, curve, rows, turning.get(curve.place, {}))
        before = set(drawn)
        for row in rows:
            mark = places.mark(row, x, y)
            if mark is not None and mark not in before:
                drawn.add(mark)
                yield from mark.series(row["id"], SCALES[y].is_fraction, curve.condition)


class _Places:
    """Where the printed ``rows`` of one curve belong, which has this turning point or none."""

    def __init__(self, data, curve, rows, turning_point):
        self.data, self.curve = data, curve
        self.load = data["load"].values
        self.printed = {row["quantity"]: row["value"] for row in reversed(rows)}
        self.turning_point = turning_point

    def mark(self, row, x_name, y_name) -> Mark | None:
        """The mark of ``row`` in a panel of these quantities, None if they do not show it."""
        quantity, value, ends = row["quantity"], row["value"], (row["low"], row["high"])
        if x_name == quantity == "film_thickness":
            return Mark(value, self.at(y_name, self.extreme(row)), ends, "x")
        if x_name != "load":
            return None
        if y_name == quantity:
            return Mark(self.load_of(row), value, ends, "y")
        if quantity == "load" and y_name == row["at_quantity"]:
            return Mark(value, row["at_level"], ends, "x")
        if y_name not in DRAWN_ON.get(quantity, ()):
            return None
        if quantity == "bend_load_over_mixed_load":
            mixed = self.falls_to(SOLID, BOUNDARY_LIMIT)
            x, low, high = (mixed * factor for factor in (value, *ends))
            return Mark(x, self.at(y_name, x), (low, high), "x")
        if quantity == "turning_point_load":
            found = self.turning_point.get("peak_ratio", self.at(y_name, value))
            return Mark(value, self.printed.get("turning_point_ratio", found), ends, "x")
        if quantity in ("bend_load", "total_contact_area_reversal_load"):
            return Mark(value, self.at(y_name, value), ends, "x")
        highest = self.load[np.argmax(self.curve.values(self.data, RATIO))]
        found = self.turning_point.get("load", float(highest))
        x = self.printed.get("turning_point_load", found)
        # L_s = L_s F_t*/F_t*
        scale = 1.0 / x if quantity == "turning_point_solid_load" else 1.0
        return Mark(x, scale * value, (scale * ends[0], scale * ends[1]), "y")

    def at(self, name, load) -> float:
        return self.curve.at(self.data, name, load)

    def load_of(self, row) -> float:
        """The load at which the number of ``row`` is printed."""
        if row["at_quantity"] == "load":
            return row["at_level"]
        if row["at_quantity"]:
            return self.falls_to(row["at_quantity"], row["at_level"])
        return self.extreme(row)

    def falls_to(self, name, level) -> float:
        """The load at which the variable ``name`` last falls below ``level``, or the last load."""
        below = self.curve.values(self.data, name) < level
        falls = np.flatnonzero(below[1:] & ~below[:-1])
        return float(self.load[falls[-1] + 1 if falls.size else -1])

    def extreme(self, row) -> float:
        """The load of the extreme of the curve that ``row`` names."""
        within = self.load <= (row["load_max"] or np.inf)
        within &= self.data["normal_load"].values <= (row["load_max_N"] or np.inf)
        values = self.curve.values(self.data, row["quantity"])[within]
        wanted = values.min() if row["extreme"] == "minimum" else values.max()
        found = np.flatnonzero(values == wanted)
        # A constant curve has it everywhere.  The paper speaks of loads up to the last one, and
        # fractions of the solid and of particles fall with the load.
        is_last = row["load_max"] or row["extreme"] == "minimum"
        return float(self.load[found[-1 if is_last else 0]])


def printed_window_series(printed: Sequence[Mapping], roughness: float) -> Iterator[Series]:
    """Printed ends of the range of x_a/σ with turning points on the surface of ``roughness`` [m]; they
    have no height: ``y`` is 0."""
    for row in printed:
        if row["quantity"].startswith("window") and np.isclose(
            row["roughness_m"], roughness, rtol=1e-9
        ):
            yield from Mark(row["value"], 0.0, (row["low"], row["high"]), "x").series(row["id"])
