"""Marks of the numbers that the paper prints, with their tolerances."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chenhorng.claims.between_curves import bend_load, crossings
from chenhorng.figures.numbers import UPRIGHT, Number
from chenhorng.sampling import area_slope
from thirdbody.curves import condition_key, row_key
from thirdbody.plotting import marks
from thirdbody.plotting.marks import AREA, RATIO
from thirdbody.plotting.panels import Curve, Series
from thirdbody.plotting.scales import SCALES
from thirdbody.variables import RELATIVE_AREA

PRINTED, EVERY_LOAD = "printed", "printed at every load"
ALONG_X, OF_ALL = "printed along x", "printed along x for all surfaces"
COMPUTED = "computed"
# how matplotlib draws each kind of mark; those with a label have an entry in the key, in this order
LOOKS: dict[str, dict[str, Any]] = {
    PRINTED: {
        "label": "printed, with tolerance",
        "color": "black",
        "linestyle": "-",  # in the key a bar, of a single point nothing
        "linewidth": 1.4,
        "marker": "D",
        "markersize": 5.5,
        "markerfacecolor": "none",  # the curve is seen in it
        "markeredgewidth": 1.2,
        "clip_on": False,
        "zorder": 3.1,
    },
    EVERY_LOAD: {
        "label": "printed for loads between strokes",
        "color": "black",
        "linestyle": "-",
        "linewidth": 0.9,
        "marker": "|",
        "markersize": 9.0,
        "markeredgewidth": 1.4,
        "zorder": 2.9,
    },
    ALONG_X: {
        "label": "printed position along x",
        "color": "black",
        "linestyle": (0, (4.0, 1.0, 1.0, 1.0)),
        "linewidth": 1.3,
        "zorder": 1.7,
    },
    OF_ALL: {
        "label": "the same, for all surfaces",
        "color": "black",
        "linestyle": ":",
        "linewidth": 1.6,
        "zorder": 1.7,
    },
    COMPUTED: {
        "label": "bend or crossing, computed",
        "linestyle": "none",
        "marker": "H",
        "markersize": 6.0,
        "markerfacecolor": "C1",
        "markeredgecolor": "black",
        "zorder": 3.2,
    },
}
# a bar with a stroke across each end, and a strip of a number that lacks an ordinate
BAR = {"linewidth": 1.4, "markersize": 5.0, "markeredgewidth": 1.2, "zorder": 3.0}
TOLERANCE, EDGE = "#F3D591", "#B8923A"  # also in the explorer
STRIP = {"facecolor": (TOLERANCE, 0.4), "edgecolor": EDGE, "linewidth": 0.6, "zorder": 0.6}
STRIP |= {"label": "tolerance of a printed line"}
LEAST_STRIP = 0.02  # of a strip that is drawn, in lengths of its curves
SQUARE = {"label": STRIP["label"], "linestyle": "none", "marker": "s", "markersize": 8.0}
LOOKS["strip"] = SQUARE | {"markerfacecolor": "#FBEFD0", "markeredgecolor": EDGE}
LOCUS, WINDOW = "locus of the turning points", "window"
LOOKS |= {kind: marks.LOOKS[kind] for kind in (marks.TURNING_POINTS, marks.SLIGHT)}
LOOKS[LOCUS] = {
    "label": "locus of turning points",
    "color": "C1",
    "linewidth": 2.2,
    "dashes": (2.5, 1.2),
    "zorder": 2.9,
}
LOOKS[WINDOW] = {"label": "computed limits of turning points", "color": "C5", "linewidth": 1.8}
ALL_LOOKS = LOOKS | marks.LOOKS

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


def printed_series(
    x: str, y: str, curves: Sequence[Curve], printed: Sequence[Mapping]
) -> Iterator[Series]:
    """The numbers of ``curves`` in rows of the table ``printed``, in a panel of ``x`` and ``y``.  A
    position that several curves share is shown once."""
    if x == "diameter_ratio":
        (roughness,) = {curve.condition.roughness for curve in curves}
        rows = [row for row in printed if row["quantity"].startswith("window")]
        yield from (_along_x(row) for row in rows if _is_on(row, roughness))
        return
    shown = {condition_key(curve.condition): curve for curve in curves}
    rows = [row for row in printed if row_key(row) in shown]
    for group in _groups(row for row in rows if _lacks_ordinate(row, x, y, rows)):
        of_group = [shown[row_key(row)] for row in group]
        yield _along_x(group[0], of_group, x)
        yield from _computed(group[0], y, of_group, curves)
    drawn = set()
    for curve in curves:
        key, colour = condition_key(curve.condition), _colour([curve])
        own = [row for row in rows if row_key(row) == key]
        numbers = {row["quantity"]: row["value"] for row in own}
        for row in own:
            if _lacks_ordinate(row, x, y, rows):
                continue
            found = _low_value_high(curve, row, x, y, numbers)
            place = row["id"], found and tuple(np.ravel(found))
            if found and place not in drawn:
                drawn.add(place)
                points = np.array(found)
                kind, (number_x, number_y) = PRINTED, points[:, 1:2]
                end = "|" if points[0, 0] < points[0, 2] else "_"
                look = BAR | colour | {"marker": end}
                if _is_at_every_load(row, x, y):
                    kind, number_y, look = EVERY_LOAD, np.full(2, row["value"]), STRIP
                    number_x = curve.values[x][_within(curve, row)][[0, -1]]
                    points[0] = np.sqrt(number_x.prod())
                yield Number(
                    kind=kind,
                    name=row["id"],
                    x=number_x,
                    y=number_y,
                    curve=curve.condition,
                    look=LOOKS[kind] | colour,
                    tolerance=(points[0, ::2], points[1, ::2]),
                    tolerance_look=look,
                )


def window_limits(windows: Sequence[Mapping], roughness: float) -> NDArray:
    """The finite limits of x_a/σ in rows of the table ``tpca_windows``, on a surface [m]."""
    ends = np.array([row["diameter_over_roughness"] for row in windows if _is_on(row, roughness)])
    return ends[np.isfinite(ends)]


def window_series(windows: Sequence[Mapping], roughness: float) -> Iterator[Series]:
    """The computed limits of x_a/σ with turning points on a surface, if there are limits."""
    ends = window_limits(windows, roughness)
    if ends.size:
        no_y = np.full(ends.size, np.nan)
        look, words = LOOKS[WINDOW], "computed"
        yield Number(WINDOW, "", ends, no_y, look=look, drawn_as=UPRIGHT, words=words)


def _is_on(row, roughness) -> bool:
    """Whether a row of a table is of the surface with this ``roughness`` [m]."""
    return bool(np.isclose(row["roughness_m"], roughness, rtol=1e-9))


def _groups(rows) -> Iterator[list[Mapping]]:
    """Rows of the same number: of one statement, with one value."""
    groups: dict[tuple, list[Mapping]] = {}
    for row in rows:
        groups.setdefault((row["id"], row["value"]), []).append(row)
    yield from groups.values()


def _colour(curves) -> dict[str, Any]:
    """The colour of one curve, or black for several and for a black or grey one."""
    colours = {curve.look["color"] for curve in curves}
    colour = colours.pop() if len(colours) == 1 else "black"
    return {"color": "black" if isinstance(colour, str) else colour}


def _lacks_ordinate(row, x, y, rows) -> bool:
    """Whether the paper prints the number in ``row`` along x alone."""
    quantity = row["quantity"]
    if x == "film_thickness":
        return quantity == x
    if x != "load" or y not in LOADS.get(quantity, ()):
        return False
    same = (one["quantity"] for one in rows if row_key(one) == row_key(row))
    return quantity != "turning_point_load" or "turning_point_ratio" not in same


def _along_x(row, curves=(), x="") -> Series:
    """A number printed along ``x`` alone: a line across the panel, of another kind if the number is
    for all surfaces.  Its strip is left out where it is no wider than the line."""
    kind = ALONG_X if row["id"].startswith(row["figure"] or "none") else OF_ALL
    nothing = np.full(2, np.nan)
    low, high = row["low"], row["high"]
    along = [curve.values[x] for curve in curves]
    place = np.log if x and SCALES[x].is_logarithmic else np.asarray
    is_seen = not along or np.ptp(place([low, high])) > LEAST_STRIP * np.ptp(place(along))
    return Number(
        kind=ALONG_X,
        name=row["id"],
        x=np.array([row["value"]]),
        y=nothing[:1],
        curve=curves[0].condition if len(curves) == 1 else None,
        look=LOOKS[kind] | (_colour(curves) if curves else {}),
        drawn_as=UPRIGHT,
        tolerance=(np.array([low, high]), nothing),
        tolerance_look=STRIP if is_seen else {},
        words="printed" if kind == ALONG_X else "printed for all surfaces",
    )


def _computed(row, y, of_group, curves) -> Iterator[Series]:
    """Where the model has the bends or the crossing of ``row``; a turning point has a star."""
    load = curves[0].values["load"]
    areas = [curve.values[AREA] for curve in of_group]
    if row["quantity"] == "total_contact_area_reversal_load":
        loads = crossings(load, np.array(areas))
        last = int(np.argmax(loads))
        places = [(of_group[last], loads[last])]
    elif row["quantity"] == "bend_load":
        places = []
        for curve, area in zip(of_group, areas, strict=True):
            dry = curve.condition._replace(viscosity=0.0)
            reference = next(one.values[AREA] for one in curves if one.condition == dry)
            slopes = area_slope(load, area), area_slope(load, reference)
            places.append((curve, bend_load(load, *slopes)))
    else:
        return
    for curve, at in places:
        if load[0] <= at <= load[-1]:
            yield Series(
                kind=COMPUTED,
                name=row["id"],
                x=np.array([at]),
                y=np.array([curve.at(y, at)]),
                curve=curve.condition,
                look=LOOKS[COMPUTED],
            )


def _is_at_every_load(row, x, y) -> bool:
    """Whether a printed extreme is an end of the axis, so that all values are equal to it."""
    ends = (0.0, 1.0) if SCALES[y].zones else ()
    return x == "load" and row["quantity"] == y and bool(row["extreme"]) and row["value"] in ends


def _low_value_high(curve, row, x, y, numbers) -> tuple[NDArray, NDArray] | None:
    """The low end, value and high end of the number in ``row``, as points in a panel of ``x`` and
    ``y``.  The other coordinate is that of the curve, or of the printed turning point in
    ``numbers``.  None if the panel does not show the number."""
    quantity, number = row["quantity"], np.array([row["low"], row["value"], row["high"]])
    if x != "load":
        return None
    if quantity == "load" and y == row["at_quantity"]:
        return number, np.full(3, row["at_level"])
    if y in LOADS.get(quantity, ()):
        return number, np.full(3, numbers["turning_point_ratio"])
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
    """The load of the number in ``row``, printed or read from the curve."""
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
