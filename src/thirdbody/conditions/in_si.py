"""The five conditions under any of their names, in SI."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.conditions.checks import checked_axis
from thirdbody.conditions.usual import warn_unusual
from thirdbody.model.parameters import Parameters
from thirdbody.units import ENGINEERING, UNITS, Unit, has_unit, unit_of

CONDITIONS = tuple(ENGINEERING)


def in_si(
    given: Mapping[str, ArrayLike],
    parameters: Parameters,
    without: str | None = None,
    check: Callable[[str, NDArray], NDArray] = lambda key, values: values,
) -> dict[str, NDArray]:
    """The ``given`` conditions, numbers or quantities under any of their names, in SI by the arguments of
    ``solve``; warns as ``solve``, in the units that were given.

    The condition ``without`` is not given.  ``check`` gets the values [SI] that belong to a name, and
    returns them.  Raises ``ValueError`` if a condition is missing, given twice, unknown, or the one that
    is not to be given, and for numbers that ``solve`` refuses.
    """
    units = {}
    for key in given:
        unit = unit_of(key)
        name = unit.condition
        if name in units or name == without:
            reason = "is searched along" if name == without else "is given twice"
            raise ValueError(f"{key}: {name} {reason}; allowed: each axis once")
        units[name] = unit
    found = {}
    for name in CONDITIONS:
        if name in units:
            key = units[name].key
            found[name] = check(key, _numbers(units[name], given[key], parameters))
        elif name != without:
            raise ValueError(f"{name} is missing; allowed: {name} or {ENGINEERING[name]}")
    warn_unusual(found, units, parameters.newtons_per_load)
    return found


def _numbers(unit: Unit, values: Any, parameters: Parameters) -> NDArray:
    """Values in SI: numbers in ``unit``, or quantities in a unit of their own."""
    if unit is UNITS[unit.condition] or has_unit(values):
        return np.array(checked_axis(unit.condition, values, parameters))
    if isinstance(values, (list, tuple)) and any(map(has_unit, values)):
        raise ValueError(f"{unit.key} is a list of quantities; allowed: numbers, or one quantity")
    try:
        numbers = checked_axis(unit.condition, values, parameters)
    except ValueError as error:
        raise ValueError(f"{unit.key}{str(error).removeprefix(unit.condition)}") from None
    return unit.to_si(numbers, parameters.newtons_per_load)
