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
    """Conditions [SI] by the arguments of ``solve``; warns as ``solve``, in the units that were given.

    Parameters
    ----------
    given : mapping
        A value of each condition, by its name in SI or in engineering units, or a quantity.
    parameters : Parameters
        Inputs of the model.
    without : str, optional
        Name of a condition that is not given.
    check : callable, optional
        Checks the values [SI] that belong to a name, and returns them.

    Raises
    ------
    ValueError
        If a condition is missing, given twice, unknown, or the one that is not to be given, and for
        numbers that ``solve`` refuses.

    Examples
    --------
    >>> import thirdbody
    >>> inputs = thirdbody.load_parameters()
    >>> given = {"load": 1e-5, "roughness_nm": 300, "particle_diameter": 5e-7}
    >>> given |= {"particle_density": 1e11}
    >>> {name: float(value) for name, value in in_si(given, inputs, without="viscosity").items()}
    {'load': 1e-05, 'particle_diameter': 5e-07, 'roughness': 3e-07, 'particle_density': 100000000000.0}
    """
    units = {}
    for key in given:
        unit = unit_of(key)
        name = unit.condition
        if name in units or name == without:
            reason = "is searched along" if name == without else "is given twice"
            raise ValueError(f"{key}: {name} {reason}; allowed: each axis once")
        units[name] = unit
    missing = [name for name in CONDITIONS if name not in units and name != without]
    if missing:
        name = missing[0]
        raise ValueError(f"{name} is missing; allowed: {name} or {ENGINEERING[name]}")
    found = {
        name: check(units[name].key, _numbers(units[name], given[units[name].key], parameters))
        for name in CONDITIONS
        if name in units
    }
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
