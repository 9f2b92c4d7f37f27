"""Conversion of the five conditions, under any of their names, to SI."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.conditions.checks import checked_array
from thirdbody.conditions.usual import USUAL, warn_outside
from thirdbody.messages import shown
from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import LEAST
from thirdbody.units import ENGINEERING, Unit, in_own_unit, is_labelled, unit_of

CONDITIONS = tuple(ENGINEERING)
NEVER_ZERO = "load", "roughness"  # the others are 0 without oil or particles


def in_si(
    given: Mapping[str, ArrayLike],
    parameters: Parameters,
    without: str | None = None,
    check: Callable[[str, NDArray], NDArray] = lambda key, values: values,
) -> dict[str, NDArray]:
    """The ``given`` conditions, numbers or quantities under any of their names, in SI by the
    arguments of ``solve``; warns like ``solve``, in the given units.

    The condition ``without`` must not be given.  ``check`` is called with each name and its values
    [SI], and returns the values.  Raises ``ValueError`` if a condition is missing, given twice,
    unknown or not allowed, and for numbers that ``solve`` refuses.
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
            units[name], values = _numbers(units[name], given[key], parameters)
            found[name] = check(key, values)
        elif name != without:
            raise ValueError(f"{name} is missing; allowed: {name} or {ENGINEERING[name]}")
    typed = {}
    for name, values in found.items():
        unit = units[name]
        both = (unit.from_si(each, parameters.newtons_per_load) for each in (values, USUAL[name]))
        typed[unit.key] = *both, unit.text
    warn_outside(typed)
    return found


def ends_in_si(name: str, ends: Any, unit: Unit, parameters: Parameters) -> NDArray:
    """The ends of a range, two numbers in ``unit`` or quantities, in SI; ``ValueError`` unless they
    are positive and increase, and a warning like ``in_si``."""
    newtons = parameters.newtons_per_load
    own, numbers = in_own_unit(replace(unit, key=name), ends, newtons)
    allowed = "two numbers, positive and increasing"
    array = checked_array(name, numbers, allowed)
    if array.shape != (2,) or not 0.0 < array[0] < array[1] < np.inf:
        raise ValueError(f"{name} is {shown(ends)}; allowed: {allowed}")
    warn_outside({name: (array, own.from_si(USUAL[unit.condition], newtons), own.text)})
    return own.to_si(array, newtons)


def _numbers(unit: Unit, given: Any, parameters: Parameters) -> tuple[Unit, NDArray]:
    """The unit of numbers or quantities, and a float64 copy in SI; for an array with named
    dimensions, of its values."""
    key, newtons = unit.key, parameters.newtons_per_load
    if hasattr(given, "iloc"):
        message = f"{key} is a {type(given).__name__} of pandas"
        raise ValueError(f"{message}; allowed: its .to_numpy() or .to_xarray()")
    own, bare = in_own_unit(unit, given, newtons)
    array = checked_array(key, bare.data if is_labelled(bare) else bare)
    least, sign = (LEAST, "positive") if unit.condition in NEVER_ZERO else (0, "zero or positive")
    wrong = array[~((array >= least) & np.isfinite(array))]
    if wrong.size:
        raise ValueError(f"{key} is {wrong[0]:g}; allowed: {sign} finite numbers")
    return own, np.array(own.to_si(array, newtons))
