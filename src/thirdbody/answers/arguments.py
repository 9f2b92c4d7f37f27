"""The checks of what a question is asked with: one line for each mistake."""

from __future__ import annotations

from collections.abc import Mapping
from numbers import Integral
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
    allowed = "positive numbers" if positive else "zero or positive numbers"
    number = checked_array(name, value, allowed)
    if number.ndim or not 0.0 <= number < np.inf or (positive and number == 0.0):
        raise ValueError(f"{name} is {shown(value)}; allowed: {allowed}")


def check_ends(name: str, ends: Any) -> None:
    """Raises ``ValueError`` unless the ``ends`` of a range are two numbers, positive and increasing."""
    allowed = "two numbers, positive and increasing"
    array = checked_array(name, ends, allowed)
    if array.shape != (2,) or not 0.0 < array[0] < array[1] < np.inf:
        raise ValueError(f"{name} is {shown(ends)}; allowed: {allowed}")


def check_count(name: str, count: Any) -> None:
    """Raises ``ValueError`` unless a number of values is whole, and at least 2."""
    whole = isinstance(count, Integral) and not isinstance(count, bool)
    if not whole or not 2 <= count <= MOST_VALUES:
        allowed = f"whole numbers from 2 to {MOST_VALUES}"
        raise ValueError(f"{name} is {shown(count)}; allowed: {allowed}")


def checked_levels(variable: Any, level: ArrayLike) -> NDArray[np.float64]:
    """The levels of a variable; ``ValueError`` for an unknown variable, and levels it cannot have."""
    if not isinstance(variable, str) or variable not in QUANTITIES:
        raise ValueError(f"variable is {shown(variable)}; allowed: {', '.join(QUANTITIES)}")
    quantity = QUANTITIES[variable]
    levels = checked_array("level", level, f"numbers, in {quantity.units}")
    impossible = levels[~((levels >= 0.0) & (levels <= quantity.largest) & np.isfinite(levels))]
    if impossible.size:
        most = f"0 to {quantity.largest:g}" if quantity.largest < np.inf else "zero or positive"
        raise ValueError(f"level of {variable} is {impossible[0]:g}; allowed: {most}")
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
