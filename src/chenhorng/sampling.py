"""Curves at the loads of a claim: bounds of the range, levels of quantities, and values between
loads.
"""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

TINY = 1e-300  # least argument of logarithms, so that vanishing quantities can be compared

CURVE_QUANTITIES = (
    *("load", "solid_load", "solid_load_fraction", "particle_contact_area_ratio"),
    *("total_contact_area", "total_contact_area_slope", "film_thickness"),
    "real_contact_pressure",
)
# Keys of conditions that bound a range of loads: the quantity, and the sign for which sign * (bound
# - value) is positive outside the bound.
RANGE_KEYS = {f"{name}_min": (name, 1.0) for name in CURVE_QUANTITIES} | {
    f"{name}_max": (name, -1.0) for name in CURVE_QUANTITIES
}

SolvedCurve = Mapping[str, NDArray]  # from ``chenhorng.claims.evidence.curve_of``


class NotReached(Exception):
    """No load of a curve is within the bounds of a claim, by the shortfall in the argument."""


def loads_within(
    limits: Mapping[str, float], grid: SolvedCurve, bounded: Sequence[SolvedCurve]
) -> NDArray:
    """Loads F_t* [1] of a curve, ``grid``: one if ``limits`` give it or a level, otherwise all
    within their bounds on ``bounded`` curves; ``NotReached`` if there are none."""
    load = grid["load"]
    if not limits:
        return load
    if "load" in limits:
        return np.array([limits["load"]])
    for name in limits.keys() & set(CURVE_QUANTITIES):
        return np.array([first_fall(load, logarithm(grid[name]) - np.log(limits[name]))])
    heaviest = np.interp(limits.get("load_max_N", np.inf), grid["normal_load"], load)
    low = max(limits.get("load_min", 0.0), load[0])
    high = min(limits.get("load_max", heaviest), load[-1])
    if not low < high:
        raise NotReached(np.log(low / high))
    loads = np.concatenate([[low], load[(load > low) & (load < high)], [high]])
    shortfall = np.full(loads.size, -np.inf)
    for key in limits.keys() & RANGE_KEYS.keys():
        name, sign = RANGE_KEYS[key]
        for curve in bounded:
            shortfall = np.maximum(shortfall, sign * (limits[key] - sample(curve, name, loads)))
    if shortfall.min() > 0.0:
        raise NotReached(shortfall.min())
    return loads[~(shortfall > 0.0)]


def first_fall(loads: NDArray, values: NDArray) -> float:
    """Load at which ``values`` first fall to zero, or the first load if they start below;
    extrapolated with the last slope, over a decade at most, so that nothing jumps when inputs
    change."""
    above = values > 0.0
    if not above[0]:
        return loads[0] if values[0] <= 0.0 else np.nan
    right = above.size - 1 if above.all() else int(np.argmin(above))
    step = np.log(loads[right] / loads[right - 1])
    fall = np.maximum(values[right - 1] - values[right], TINY)
    advance = np.minimum(values[right - 1] / fall, np.log(10.0) / abs(step))
    return loads[right - 1] * np.exp(advance * step)


def sample(curve: SolvedCurve, quantity: str, x: NDArray, against: str = "load") -> NDArray:
    """A quantity where ``against`` equals ``x``, interpolated in logarithms; nan if unsolved."""
    if quantity == against:
        return x
    values = curve[quantity]
    if x is curve["load"]:  # no interpolation needed
        return values
    known = np.log(curve[against])
    forward = slice(None, None, 1 if known[0] < known[-1] else -1)
    if (values <= 0.0).any():
        return np.interp(np.log(x), known[forward], values[forward], np.nan, np.nan)
    return np.exp(np.interp(np.log(x), known[forward], np.log(values[forward]), np.nan, np.nan))


def logarithm(values: ArrayLike) -> NDArray:
    """The natural logarithm, also of what vanishes."""
    return np.log(np.maximum(values, TINY))


def area_slope(load: NDArray, area: NDArray) -> NDArray:
    """The slope of A_t* over F_t*, both on logarithmic axes [1]."""
    return np.gradient(np.log(np.maximum(area, np.finfo(float).tiny)), np.log(load))
