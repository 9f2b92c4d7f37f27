"""Marks of the numbers that the paper prints, with their tolerances."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from thirdbody.curves import condition_key, row_key
from thirdbody.plotting import marks
from thirdbody.plotting.marks import AREA, RATIO, RELATIVE_AREA, is_on
from thirdbody.plotting.panels import UPRIGHT, Curve, Series
from thirdbody.plotting.scales import SCALES

PRINTED, EVERY_LOAD = "printed", "printed at every load"
PRINTED_LIMIT, LIMIT_OF_ALL = "printed limit", "printed limit of all surfaces"
# how matplotlib draws each kind of mark; those with a label have an entry in the key, in this order
LOOKS: dict[str, dict[str, Any]] = {
    PRINTED: {
        "label": "printed, with tolerance",
        "color": "black",
        "linestyle": "-",  # in the key a bar, of a single point nothing
        "linewidth": 1.4,
        "marker": "D",
        "markersize": 5.5,
        "markerfacecolor": "white",
        "markeredgewidth": 1.2,
        "clip_on": False,
        "zorder": 3.1,
    },
    EVERY_LOAD: {
        "label": "printed, at every load",
        "color": "black",
        "linestyle": "-",
        "linewidth": 0.9,
        "marker": "|",
        "markersize": 9.0,
        "markeredgewidth": 1.4,
        "zorder": 2.9,
    },
    PRINTED_LIMIT: {
        "label": "printed limits, tolerance in grey",
        "color": "black",
        "linestyle": "--",
    },
    LIMIT_OF_ALL: {
        "label": "printed limits, all surfaces",
        "color": "black",
        "linestyle": ":",
        "linewidth": 1.6,
    },
}
ALL_LOOKS = marks.LOOKS | LOOKS
# a bar with a stroke across each end, and a zone of a limit
BAR = {"linewidth": 1.4, "markersize": 5.0, "markeredgewidth": 1.2, "zorder": 3.0}
ZONE = {"color": "0.93", "linewidth": 0.0, "zorder": 0.5}

SOLID = "solid_load_fraction"
# panels over the load for numbers that are not variables: loads, and values at a turning point
LOADS = {
    "turning_point_load": (RATIO,),
    "bend_load": (AREA,),
    "total_contact_area_reversal_load": (AREA, RELATIVE_AREA),
}
AT_TURNING_POINT = {
    "turning_point_ratio": RATIO,
    "turning_point_solid_load_fraction": SOLID,
    "turning_point_solid_load": SOLID,
}


def _printed_limit(row) -> Series:
    """A number printed without an ordinate, across the panel; one for all surfaces has a line of its own."""
    value, ends = np.array([row["value"]]), np.array([row["low"], row["high"]])
    own = row["id"].startswith(row["figure"] or "none")
    look = LOOKS[PRINTED_LIMIT if own else LIMIT_OF_ALL]
    return Series(
        kind=PRINTED,
        name=row["id"],
        x=value,
        y=np.zeros(1),
        look=look,
        drawn_as=UPRIGHT,
        tolerance=(ends, np.zeros(2)),
        tolerance_look=ZONE,
    )


def printed_series(
    x: str, y: str, curves: Sequence[Curve], printed: Sequence[Mapping]
) -> Iterator[Series]:
    """Printed numbers of ``curves``, rows of the table ``printed``, in a panel of ``x`` and ``y``;
    each position is shown once, even if several curves have it."""
    if x == "diameter_ratio":
        for row in printed:
            if row["quantity"].startswith("window") and is_on(row, curves[0].condition.roughness):
                yield _printed_limit(row)
        return
    if x == "film_thickness":
        shown = {condition_key(curve.condition) for curve in curves}
        for row in printed:
            if row["quantity"] == x and row_key(row) in shown:
                yield _printed_limit(row)
        return
    drawn = set()
    for curve in curves:
        key, colour = condition_key(curve.condition), {"color": curve.look["color"]}
        if isinstance(curve.look["color"], str):  # grey or black
            colour = {"color": "black"}
        own = [row for row in printed if row_key(row) == key]
        numbers = {row["quantity"]: row["value"] for row in own}
        for row in own:
            points = _low_value_high(curve, row, x, y, numbers)
            place = row["id"], tuple(np.ravel(points))
            if points and place not in drawn:
                drawn.add(place)
                points = np.array(points)
                kind, (number_x, number_y) = PRINTED, points[:, 1:2]
                if _is_at_every_load(row, x, y):
                    kind, number_y = EVERY_LOAD, np.full(2, row["value"])
                    number_x = curve.values[x][_within(curve, row)][[0, -1]]
                    points[0] = np.sqrt(number_x.prod())  # the tolerance in their middle
                hidden = {"marker": ""} if _is_regime(row, y) else {}
                end = "|" if points[0, 0] < points[0, 2] else "_"
                yield Series(
                    kind=kind,
                    name=row["id"],
                    x=number_x,
                    y=number_y,
                    curve=curve.condition,
                    look=LOOKS[kind] | colour | hidden,
                    tolerance=(points[0, ::2], points[1, ::2]),
                    tolerance_look=BAR | colour | {"marker": end},
                )


def _is_at_every_load(row, x, y) -> bool:
    """Whether a printed extreme is an end of the axis, so that all values are equal to it."""
    ends = (0.0, 1.0) if SCALES[y].zones else ()
    return x == "load" and row["quantity"] == y and bool(row["extreme"]) and row["value"] in ends


def _is_regime(row, y) -> bool:
    """Whether the paper names the zone up to the end of an axis, so that only the tolerance is told."""
    return bool(SCALES[y].zones) and row["at_quantity"] == "load" and row["value"] in (0.0, 1.0)


def _low_value_high(curve, row, x, y, numbers) -> tuple[NDArray, NDArray] | None:
    """The number in ``row`` between the ends of its tolerance, as points in a panel of ``x`` and
    ``y``, along the other axis at the curve, of a turning point at the printed one of ``numbers``,
    None if the panel does not show it."""
    quantity, number = row["quantity"], np.array([row["low"], row["value"], row["high"]])
    if x != "load":
        return None
    if quantity == "load" and y == row["at_quantity"]:
        return number, np.full(3, row["at_level"])
    if y in LOADS.get(quantity, ()):
        if quantity == "turning_point_load" and "turning_point_ratio" in numbers:
            return number, np.full(3, numbers["turning_point_ratio"])
        return number, np.full(3, curve.at(y, number[1]))
    if y != AT_TURNING_POINT.get(quantity, quantity):
        return None
    load = _load_of(curve, row)
    if quantity in AT_TURNING_POINT:
        load = numbers.get("turning_point_load", load)
    if quantity == "turning_point_solid_load":
        number = number / load  # L_s = L_s F_t*/F_t*
    if SCALES[y].zones:  # a fraction
        number = np.clip(number, 0.0, 1.0)
    return np.full(3, load), number


def _load_of(curve, row) -> float:
    """The load of the number in ``row``: given, or where the curve has a level, an extreme or its turning point."""
    if row["at_quantity"] == "load":
        return row["at_level"]
    if row["at_quantity"]:
        return _falls_to(curve, row["at_quantity"], row["at_level"])
    load, within = curve.values["load"], _within(curve, row)
    values = curve.values[RATIO if row["quantity"] in AT_TURNING_POINT else row["quantity"]]
    find = np.argmin if row["extreme"] == "minimum" else np.argmax
    return float(load[find(values[within])])


def _within(curve, row) -> NDArray:
    """Whether each load is one of those of which the number in ``row`` is told."""
    within = curve.values["load"] <= (row["load_max"] or np.inf)
    return within & (curve.values["normal_load"] <= (row["load_max_N"] or np.inf))


def _falls_to(curve, name, level) -> float:
    """The load at which the variable ``name`` last falls below ``level``, or the last load."""
    below = curve.values[name] < level
    falls = np.flatnonzero(below[1:] & ~below[:-1])
    return float(curve.values["load"][falls[-1] + 1 if falls.size else -1])
