"""Courses of a quantity, and sequences of states: how far a curve is from the course or the
sequence that a claim names.
"""

from collections.abc import Sequence
from itertools import groupby

import numpy as np
from numpy.typing import NDArray

from chenhorng.sampling import SolvedCurve
from thirdbody.core.regimes import BOUNDARY_LIMIT, FULL_FILM_LIMIT, PARTICLE_LIMIT, SURFACE_LIMIT

SATURATED = 1e-12  # the odds of a ratio that is closer to 0 or 1 have lost their digits

# Regimes and modes of sections 3.1 and 3.2: the decisive quantity and its interval of a state.
STATES = {
    "boundary": ("solid_load_fraction", BOUNDARY_LIMIT, np.inf),
    "mixed": ("solid_load_fraction", FULL_FILM_LIMIT, BOUNDARY_LIMIT),
    "full_film": ("solid_load_fraction", -np.inf, FULL_FILM_LIMIT),
    "particle_surface": ("particle_contact_area_ratio", PARTICLE_LIMIT, np.inf),
    "hybrid": ("particle_contact_area_ratio", SURFACE_LIMIT, PARTICLE_LIMIT),
    "surface_surface": ("particle_contact_area_ratio", -np.inf, SURFACE_LIMIT),
}


def rise_miss(values: NDArray, step: float) -> float:
    """The deepest fall within a course, or its shortfall from a total rise of two steps if that is
    larger."""
    relapse = np.max(np.maximum.accumulate(values) - values)
    return np.max([relapse, 2.0 * step - (values[-1] - values[0])])


def peak_height(values: NDArray) -> float:
    """Height of the most prominent interior maximum above the higher of the minima beside it."""
    left = values - np.minimum.accumulate(values)
    right = values - np.minimum.accumulate(values[::-1])[::-1]
    return np.max(np.minimum(left, right))


def peak_miss(values: NDArray, step: float) -> float:
    """Shortfall of a course of ratios from an interior maximum of two steps.

    A course without a maximum also has a distance from turning, from the slope of ln(v/(1 - v)), so
    that a calibration has a slope.
    """
    size = np.abs(values)
    free = (size > SATURATED) & (size < 1.0 - SATURATED)
    odds = np.copysign(np.log(size[free] / (1.0 - size[free])), values[free])
    lack = -np.log(SATURATED)
    if odds.size > 2:
        changes = np.diff(odds) * odds.size
        climb = np.maximum.accumulate(changes)[:-1]
        drop = np.maximum.accumulate(-changes[::-1])[::-1][1:]
        lack = max(-np.max(np.minimum(climb, drop)), 0.0)
    return (2.0 + lack) * step - peak_height(values)


# Shortfall from a course, by its name: functions of the values and the step.
COURSES = {
    "increasing": rise_miss,
    "decreasing": lambda values, step: rise_miss(-values, step),
    "increasing_at_each_step": lambda values, step: 2.0 * step - np.min(np.diff(values)),
    "constant": lambda values, step: np.ptp(values),
    "rising_then_falling": peak_miss,
    "falling_then_rising": lambda values, step: peak_miss(-values, step),
}


def sequence_miss(
    curve: SolvedCurve, published: Sequence[str], tolerance: float, open_end: bool
) -> float:
    """Largest excursion of a curve from the ``published`` sequence of states.

    The points are assigned to the steps in order, so that the largest excursion is least.  Each
    step must have a point that is inside by the ``tolerance``; with ``open_end`` the last step
    need not.
    """
    excursions = np.array([_excursion(curve, step) for step in published])
    if np.isnan(excursions).any():
        return np.nan
    required = excursions[:-1] if open_end else excursions
    unmet = max(np.max(np.min(required, axis=1)) + tolerance, 0.0)
    # the least miss of the points so far, if the current point belongs to each of the steps
    reached = np.append(-np.inf, np.full(len(excursions), np.inf))
    for here in np.maximum(excursions, 0.0).T:
        reached[1:] = np.maximum(np.minimum(reached[1:], reached[:-1]), here)
        reached[0] = np.inf
    return max(reached[-2:].min() if open_end else reached[-1], unmet)


def _excursion(curve, step):
    """Distance of each point from a step, such as "mixed hybrid or full_film"; negative for a
    point inside."""
    excursions = []
    for alternative in step.split(" or "):
        outside = []
        for name in alternative.split():
            quantity, low, high = STATES[name]
            outside += [low - curve[quantity], curve[quantity] - high]
        excursions.append(np.max(outside, axis=0))
    return np.min(excursions, axis=0)


def passed_states(curve: SolvedCurve, published: Sequence[str]) -> list[str]:
    """The states along a curve: regimes, modes or both, as in the ``published`` sequence."""
    names = " ".join(published).replace(" or ", " ").split()
    families = {STATES[name][0] for name in names}
    inside = {
        name: (curve[quantity] > low) & (curve[quantity] <= high)
        for name, (quantity, low, high) in STATES.items()
        if quantity in families
    }
    passed = groupby(zip(*(values.tolist() for values in inside.values())))
    return [" ".join(name for name, there in zip(inside, row) if there) for row, _ in passed]
