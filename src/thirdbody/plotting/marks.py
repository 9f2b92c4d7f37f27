"""Marks that follow from solved data: turning points (TPCA), slight peaks, ranges and statuses."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from os import PathLike
from typing import Any

import numpy as np
from matplotlib.colors import to_rgb
from numpy.typing import NDArray

from thirdbody.core.names import PARTICLE_CONTACT_AREA_RATIO, TOTAL_CONTACT_AREA
from thirdbody.core.regimes import SOLUTION_STATUSES, WITHOUT_VALUES
from thirdbody.plotting.panels import OUTLINE, Curve, Series
from thirdbody.variables import CONDITION_AXES, STATUS

TURNING_POINTS, SLIGHT, BAND = "turning points", "slight peaks", "band"
RATIO, AREA = PARTICLE_CONTACT_AREA_RATIO, TOTAL_CONTACT_AREA
PROMINENCE = 0.02  # of a turning point, as the core has it [1]
LEAST_RISE = 0.001  # of a slight peak, on both sides [1]
FROM_ZERO = 0.05  # of a slight peak on a linear axis, in heights of the highest curve
VISIBLE_ERROR = 1e-3  # from which a point that has not converged is marked
BAND_STEP = 2  # every second load is enough for the edge of a range
TINT = 0.13  # of the colour in a range, the rest is white
# markers of points that have not converged, dotted; the curve ends where there are no values
STATUSES = dict(zip(SOLUTION_STATUSES[1:], "+x134", strict=True))
PEAK = {"linestyle": "none", "marker": "*", "markersize": 6.5, "zorder": 3.2}
OF_STATUS = {
    "color": "#A0005A",
    "linestyle": ":",
    "markersize": 5.0,
    "markeredgewidth": 0.9,
    "zorder": 3.2,
}
# how matplotlib draws each kind of mark; those with a label have an entry in the key, in this order
LOOKS: dict[str, dict[str, Any]] = {
    TURNING_POINTS: PEAK
    | {
        "label": f"turning point (stands out ≥ {PROMINENCE:g})",
        "markerfacecolor": "C1",
        "markeredgecolor": "black",
    },
    SLIGHT: PEAK
    | {
        "label": f"peak that stands out < {PROMINENCE:g}",
        "markerfacecolor": "white",
        "markeredgecolor": "0.45",
    },
    # a tint, not grey
    BAND: {"label": "range of the ensemble", "color": "#C3DEDD", "linewidth": 6.0},
}
LOOKS |= {
    status: OF_STATUS | {"marker": marker, "label": status.replace("_", " ")}
    for status, marker in STATUSES.items()
}


def read_turning_points(path: str | PathLike) -> list[dict[str, Any]]:
    """Rows of a file of the table ``tpca_loads``, with the names of conditions."""
    names = {axis.column: axis.name for axis in CONDITION_AXES}
    import pandas as pd  # of all figures, few read a table

    return pd.read_csv(path).rename(columns=names).to_dict("records")


def turning_point_series(x: str, y: str, curves: Sequence[Curve]) -> Iterator[Series]:
    """A series of the turning points of ``curves``, if there are any, over ``x`` and ``y``."""
    marked = [curve for curve in curves if curve.turning_point]
    if marked:
        at_x, at_y = (
            np.array([one.at(name, one.turning_point["load"]) for one in marked]) for name in (x, y)
        )
        yield Series(TURNING_POINTS, "", at_x, at_y, look=LOOKS[TURNING_POINTS])


def highest_point(ratio: NDArray) -> tuple[int, float]:
    """Where A_sa,t* is highest, and by how much it exceeds the least value on either side."""
    top = int(np.nanargmax(ratio))
    return top, float(ratio[top] - max(np.nanmin(ratio[: top + 1]), np.nanmin(ratio[top:])))


def peak_load(load: NDArray, ratio: NDArray) -> float:
    """The load at which A_sa,t* is highest: of the parabola in ln(load) through the highest point
    and those beside it, or of that point where there is none."""
    top, _ = highest_point(ratio)
    if not 0 < top < load.size - 1:
        return float(load[top])
    three = slice(top - 1, top + 2)
    curvature, slope, _ = np.polyfit(np.log(load[three] / load[top]), ratio[three], 2)
    return float(load[top] * (np.exp(-slope / (2.0 * curvature)) if curvature < 0.0 else 1.0))


def slight_series(x: str, y: str, curves: Sequence[Curve], least: float = 0.0) -> Iterator[Series]:
    """Peaks of A_sa,t* that are no turning points, if other curves have turning points.  Without
    ``least`` the axis is linear, and peaks near zero are left out."""
    places = []
    highest = max((np.nanmax(curve.values[RATIO]) for curve in curves), default=0.0)
    for curve in curves if any(curve.turning_point for curve in curves) else ():
        ratio = curve.values[RATIO]
        top, rise = highest_point(ratio)
        is_apart = least > 0.0 or ratio[top] > FROM_ZERO * highest
        if not curve.turning_point and rise >= LEAST_RISE and is_apart:
            places.append([curve.values[name][top] for name in (x, y)])
    if places:
        at_x, at_y = np.array(places).T
        yield Series(SLIGHT, "", at_x, at_y, look=LOOKS[SLIGHT])


def status_series(
    name: str, x: NDArray, y: NDArray, values: Mapping[str, Any], condition: Any = None
) -> Iterator[Series]:
    """The points of a curve that are not ``converged``, dotted from the first to the last of each
    status, or where the curve ends beside points without values.  ``values`` are the variables
    along it."""
    found = np.asarray(values[STATUS])
    for status in STATUSES:
        marked = found == SOLUTION_STATUSES.index(status)
        if status == "not_converged" and "error_bound" in values:
            marked &= ~(np.asarray(values["error_bound"]) < VISIBLE_ERROR)
        if status in WITHOUT_VALUES:
            beside = np.append(marked[1:], False) | np.append(False, marked[:-1])
            marked = beside & np.isfinite(y)
        places = np.flatnonzero(marked)
        if places.size:
            own = np.s_[places[0] : places[-1] + 1]
            look = LOOKS[status] | {"markevery": [0, places[-1] - places[0]]}
            yield Series(status, name, x[own], np.where(marked, y, np.nan)[own], condition, look)


def doubtful(series: Iterable[Series]) -> dict[str, NDArray]:
    """Where curves of these names have points that are drawn by their status."""
    found: dict[str, NDArray] = {}
    for one in series:
        if one.kind in STATUSES and one.kind not in WITHOUT_VALUES:
            places = one.x[np.isfinite(one.y)]
            found[one.name] = np.append(found.get(one.name, []), places)
    return found


def range_series(
    name: str, x: NDArray, low: NDArray, high: NDArray, colour: Any, condition: Any = None
) -> Series:
    """The closed outline of a range where it is known: along the low end, back along the high."""
    known = np.isfinite(low) & np.isfinite(high)
    x, low, high = x[known], low[known], high[known]
    outline = np.append(x, x[::-1]), np.append(low, high[::-1])
    x, y = (np.append(each, each[:1]) for each in outline)
    # opaque with an edge, because several may overlap
    tint = 1.0 - TINT * (1.0 - np.array(to_rgb(colour)))
    look = {"facecolor": tint, "edgecolor": (colour, 0.5), "linewidth": 0.5, "zorder": 1.5}
    look["label"] = LOOKS[BAND]["label"]
    return Series(BAND, name, x, y, condition, look, drawn_as=OUTLINE)


def ends_of(outline: Series) -> tuple[NDArray, NDArray, NDArray]:
    """x, the low and the high end of a range, from its outline."""
    half = (outline.x.size - 1) // 2
    return outline.x[:half], outline.y[:half], outline.y[half : 2 * half][::-1]


def ranges_of(curves: Iterable[Curve], x: str, y: str) -> Iterator[Series]:
    """The ranges of ``y`` over the load ``x``, of those ``curves`` that have one."""
    for curve in curves if x in ("load", "normal_load") else ():
        if curve.has(f"{y}_low"):
            load, low, high = (curve.values[name] for name in (x, f"{y}_low", f"{y}_high"))
            some = np.unique([*range(0, load.size, BAND_STEP), load.size - 1])
            ends = load[some], low[some], high[some]
            yield range_series(curve.label, *ends, curve.look["color"], curve.condition)
