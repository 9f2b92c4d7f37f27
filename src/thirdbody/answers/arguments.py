"""The checks of what a question is asked with: one line for each mistake."""

from __future__ import annotations

import math
from collections.abc import Mapping
from numbers import Integral, Real
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.conditions.checks import check_points, checked_array
from thirdbody.conditions.in_si import in_si
from thirdbody.data.quantities import QUANTITIES
from thirdbody.messages import shown
from thirdbody.model.parameters import Parameters
from thirdbody.units import is_labelled

MOST_VALUES = 1_000_000  # of a sweep or a curve


def check_number(name: str, value: Any, positive: bool = True) -> None:
    """Raises ``ValueError`` unless a value is a finite number, ``positive``, or zero or more."""
    if not _is_number(value) or value < 0.0 or (positive and value == 0.0):
        least = "positive" if positive else "zero or positive"
        raise ValueError(f"{name} is {shown(value)}; allowed: {least} numbers")


def check_ends(name: str, ends: Any) -> None:
    """Raises ``ValueError`` unless the ``ends`` of a range are two numbers, positive and increasing."""
    several = isinstance(ends, (tuple, list)) or (isinstance(ends, np.ndarray) and ends.ndim == 1)
    if not several or len(ends) != 2 or not all(map(_is_number, ends)):
        message = "allowed: two numbers, positive and increasing"
        raise ValueError(f"{name} is {shown(ends)}; {message}")
    low, high = map(float, ends)
    if not 0.0 < low < high:
        raise ValueError(f"{name} is {low:g} to {high:g}; allowed: positive and increasing")


def check_count(name: str, count: Any) -> None:
    """Raises ``ValueError`` unless a number of values is whole, and at least 2."""
    whole = isinstance(count, Integral) and not isinstance(count, bool)
    if not whole or not 2 <= count <= MOST_VALUES:
        raise ValueError(
            f"{name} is {shown(count)}; allowed: whole numbers from 2 to {MOST_VALUES}"
        )


def checked_levels(variable: Any, level: ArrayLike) -> NDArray[np.float64]:
    """The levels of a variable; ``ValueError`` for an unknown variable, and levels it cannot have."""
    if not isinstance(variable, str) or variable not in QUANTITIES:
        raise ValueError(f"variable is {shown(variable)}; allowed: {', '.join(QUANTITIES)}")
    quantity = QUANTITIES[variable]
    allowed = f"numbers, in {quantity.units}"
    levels = checked_array("level", level, allowed)
    if not np.isfinite(levels).all():
        raise ValueError(f"level is {shown(level)}; allowed: {allowed}")
    impossible = levels[(levels < 0.0) | (levels > quantity.largest)]
    if impossible.size:
        most = f"0 to {quantity.largest:g}" if quantity.largest < math.inf else "zero or positive"
        raise ValueError(f"level of {variable} is {impossible.flat[0]:g}; allowed: {most}")
    return levels


def queries(
    conditions: Mapping[str, ArrayLike], parameters: Parameters, along: str, **more: NDArray
) -> tuple[tuple[int, ...], dict[str, NDArray]]:
    """The shape of queries, to which ``more`` columns and the conditions broadcast, and all of them flat,
    in SI; the condition ``along`` is not given."""
    for key, values in conditions.items():
        if is_labelled(values):
            raise ValueError(f"{key} has named dimensions; allowed: .values of it")
    given = more | in_si(conditions, parameters, without=along)
    check_points(given)
    columns = np.broadcast_arrays(*given.values())
    return columns[0].shape, dict(zip(given, map(np.ravel, columns)))


def _is_number(value: Any) -> bool:
    """Whether a value is a real number, finite as a float."""
    if not isinstance(value, Real) or isinstance(value, bool):
        return False
    try:
        return math.isfinite(value)
    except OverflowError:  # an integer of more than 308 digits
        return False
