"""Marks in panels: turning points (TPCA), statuses of points, and printed numbers with their tolerances."""

from collections.abc import Iterator, Mapping, Sequence
from os import PathLike

import numpy as np
from numpy.typing import NDArray

from thirdbody.core.regimes import SOLUTION_STATUSES, WITHOUT_VALUES
from thirdbody.curves import condition_key, row_key
from thirdbody.paper.tables import TABLES, read_csv
from thirdbody.plotting.panels import Curve, Series
from thirdbody.plotting.scales import SCALES
from thirdbody.toml_tables import toml_beside
from thirdbody.variables import CONDITION_AXES, STATUS

TURNING_POINTS, LOCUS = "turning points", "locus of the turning points"
WINDOW, PRINTED, TOLERANCE, BAND = "window", "printed", "tolerance", "band"
EVERY_LOAD = "printed at every load"
SLIGHT = "slight peaks"
LEAST_RISE = 0.001  # of a slight peak, on both sides [1]
VISIBLE_ERROR = 1e-3  # from which a point that has not converged is marked
PRINTED_LIMIT, LIMIT_TOLERANCE = "printed limit", "tolerance of a limit"
LIMIT_OF_ALL = "printed limit of all surfaces"
# markers of points that have not converged; the curve ends where there are no values
STATUSES = dict(zip(SOLUTION_STATUSES[1:], "+x134", strict=True))
LOOKS = toml_beside(__file__)
LOOKS |= {
    status: LOOKS["status"] | {"marker": marker, "label": status.replace("_", " ")}
    for status, marker in STATUSES.items()
}

RATIO, SOLID = "particle_contact_area_ratio", "solid_load_fraction"
AREA, RELATIVE_AREA = "total_contact_area", "total_contact_area_over_two_body"
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


def read_turning_points(path: str | PathLike) -> list[dict[str, float]]:
    """Rows of a file of the table ``tpca_loads``, with the names of conditions; ``OSError`` if it is damaged."""
    names = {axis.column: axis.name for axis in CONDITION_AXES}
    rows = read_csv(path, TABLES["tpca_loads"])
    return [{names.get(column, column): value for column, value in row.items()} for row in rows]


def turning_point_series(x: str, y: str, curves: Sequence[Curve], kind: str) -> Iterator[Series]:
    """The turning points of ``curves`` in a panel of ``x`` and ``y`` as one series, if there are any."""
    marked = [curve for curve in curves if curve.turning_point]
    if marked:
        places = [[one.at(name, one.turning_point["load"]) for one in marked] for name in (x, y)]
        yield Series(kind, "", *np.array(places), look=LOOKS[kind])


def slight_series(x: str, y: str, curves: Sequence[Curve]) -> Iterator[Series]:
    """Peaks of A_sa,t* that are no turning points, in a panel where other curves have some."""
    places = []
    for curve in curves if any(curve.turning_point for curve in curves) else ():
        ratio = curve.values[RATIO]
        top = int(np.nanargmax(ratio))
        rise = ratio[top] - max(np.nanmin(ratio[: top + 1]), np.nanmin(ratio[top:]))
        if not curve.turning_point and rise >= LEAST_RISE:
            places.append([curve.values[name][top] for name in (x, y)])
    if places:
        yield Series(SLIGHT, "", *np.array(places).T, look=LOOKS[SLIGHT])


def status_series(x: str, y: str, curves: Sequence[Curve]) -> Iterator[Series]:
    """First and last points with a status other than ``converged``, and ends of curves without values."""
    for status in STATUSES:
        for curve in curves:
            marked = curve.values[STATUS] == SOLUTION_STATUSES.index(status)
            if status == "not_converged" and "error_bound" in curve.values:
                marked &= ~(curve.values["error_bound"] < VISIBLE_ERROR)
            if status in WITHOUT_VALUES:
                beside = np.append(marked[1:], False) | np.append(False, marked[:-1])
                marked = beside & np.isfinite(curve.values[y])
            places = np.flatnonzero(marked)
            if places.size:
                ends = np.unique(places[[0, -1]])
                points = (curve.values[name][ends] for name in (x, y))
                yield Series(status, curve.label, *points, curve.condition, LOOKS[status])


def printed_limit(row: Mapping) -> Iterator[Series]:
    """A printed end of a window, and its tolerance: a ``row`` of the table ``printed``.  Statements on all
    surfaces have a line of their own."""
    value, ends = np.array([row["value"]]), np.array([row["low"], row["high"]])
    own = row["id"].startswith(row["figure"] or "none")
    look = LOOKS[PRINTED_LIMIT if own else LIMIT_OF_ALL]
    yield Series(PRINTED, row["id"], value, np.zeros(1), look=look)
    yield Series(TOLERANCE, row["id"], ends, np.zeros(2), look=LOOKS[LIMIT_TOLERANCE])


def printed_series(
    x: str, y: str, curves: Sequence[Curve], printed: Sequence[Mapping]
) -> Iterator[Series]:
    """Printed numbers of ``curves``, rows of the table ``printed``, in a panel of ``x`` and ``y``;
    each position is shown once, even if several curves have it."""
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
                points, look = np.array(points), LOOKS[PRINTED] | colour
                if _is_at_every_load(row, x, y):
                    load = curve.values[x][_within(curve, row)][[0, -1]]
                    value = np.full(2, row["value"])
                    points[0] = np.sqrt(load.prod())  # the tolerance in their middle
                    look = LOOKS[EVERY_LOAD] | colour
                    yield Series(EVERY_LOAD, row["id"], load, value, curve.condition, look)
                else:
                    if _is_regime(row, y):
                        look |= {"marker": ""}
                    yield Series(PRINTED, row["id"], *points[:, 1:2], curve.condition, look)
                end = "|" if points[0, 0] < points[0, 2] else "_"
                look = LOOKS[TOLERANCE] | colour | {"marker": end}
                yield Series(TOLERANCE, row["id"], *points[:, ::2], curve.condition, look)


def _is_at_every_load(row, x, y) -> bool:
    """Whether a printed extreme is an end of the axis, so that all values are equal to it."""
    ends = (0.0, 1.0) if SCALES[y].zones else ()
    return x == "load" and row["quantity"] == y and bool(row["extreme"]) and row["value"] in ends


def _is_regime(row, y) -> bool:
    """Whether the paper names the zone up to the end of an axis, so that only the tolerance is told."""
    return bool(SCALES[y].zones) and row["at_quantity"] == "load" and row["value"] in (0.0, 1.0)


def _low_value_high(curve, row, x, y, numbers) -> tuple[NDArray, NDArray] | None:
    """The number in ``row`` between the ends of its tolerance, as points in a panel of ``x`` and
    ``y``, along the other axis at the curve, of a turning point at the printed one of ``numbers``, of a film
    at 0; None if the panel does not show it."""
    quantity, number = row["quantity"], np.array([row["low"], row["value"], row["high"]])
    if x == quantity == "film_thickness":
        return number, np.zeros(3)  # on its axis
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
