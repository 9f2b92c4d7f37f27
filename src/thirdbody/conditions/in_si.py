"""The five conditions, under any of their names, in SI; arrays of xarray by dimension name."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.conditions.checks import checked_array, warn_outside
from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import LEAST
from thirdbody.units import ENGINEERING, Unit, has_unit, is_labelled, unit_of, without_unit

if TYPE_CHECKING:
    import xarray as xr

CONDITIONS = tuple(ENGINEERING)
NEVER_ZERO = "load", "roughness"  # the others are 0 without oil or particles
# usual range, SI, far wider than those of the paper: a load in newtons or a size in nm is outside
USUAL = {
    "load": (1e-13, 2e-2),
    "viscosity": (3e-7, 1e-2),
    "particle_diameter": (1e-9, 1e-3),
    "roughness": (1e-10, 1e-3),
    "particle_density": (1e6, 1e16),
}


def in_si(
    given: Mapping[str, ArrayLike], parameters: Parameters, without: str | None = None
) -> dict[str, NDArray]:
    """The ``given`` conditions, numbers or quantities under any of their names, in SI by the
    arguments of ``solve``; warns like ``solve``, in the given units.

    The condition ``without`` must not be given.  Raises ``ValueError`` if a condition is missing,
    given twice, unknown or not allowed, and for numbers that ``solve`` refuses.
    """
    units = {}
    for key in given:
        name = unit_of(key).condition
        if name in units or name == without:
            reason = "is searched along" if name == without else "is given twice"
            raise ValueError(f"{key}: {name} {reason}; allowed: each axis once")
        units[name] = unit_of(key)
    found, typed, usual = {}, {}, {}
    for name in CONDITIONS:
        if name in units:
            unit = units[name]
            found[name] = _numbers(unit, given[unit.key], parameters.newtons_per_load)
            typed[unit.key], ends = (
                unit.from_si(each, parameters.newtons_per_load)
                for each in (found[name], USUAL[name])
            )
            usual[unit.key] = *ends, unit.text
        elif name != without:
            raise ValueError(f"{name} is missing; allowed: {name} or {ENGINEERING[name]}")
    warn_outside(typed, usual)
    return found


def _numbers(unit: Unit, given: Any, newtons_per_load: float) -> NDArray:
    """A float64 copy in SI of numbers in ``unit``, or of quantities in their own unit; for an array
    with named dimensions, its values."""
    key = unit.key
    if hasattr(given, "iloc"):
        instead = ".pint.quantity" if hasattr(given, "pint") else ".to_numpy() or .to_xarray()"
        raise ValueError(f"{key} is a {type(given).__name__} of pandas; allowed: its {instead}")
    if key != unit.condition and isinstance(given, list | tuple) and any(map(has_unit, given)):
        raise ValueError(f"{key} is a list of quantities; allowed: numbers, or one quantity")
    bare = without_unit(unit, given, newtons_per_load)
    array = checked_array(key, bare.data if is_labelled(bare) else bare)
    least, sign = (LEAST, "positive") if unit.condition in NEVER_ZERO else (0, "zero or positive")
    wrong = array[~((array >= least) & np.isfinite(array))]
    if wrong.size:
        raise ValueError(f"{key} is {wrong[0]:g}; allowed: {sign} finite numbers")
    return np.array(array if has_unit(given) else unit.to_si(array, newtons_per_load))


def with_names(given: Mapping[str, Any], arrays: Mapping[str, NDArray]) -> dict[str, Any]:
    """The ``arrays`` of conditions [SI] with the dimensions and coordinates of the ``given`` ones;
    ``ValueError`` for an array without named dimensions."""
    import xarray as xr

    named = [name for name, each in given.items() if is_labelled(each)]
    for name, array in arrays.items():
        if name not in named and array.ndim > 0:
            allowed = f"a number or an xarray.DataArray, like {named[0]}"
            raise ValueError(f"{name} is an array without named dimensions; allowed: {allowed}")
    labelled = {
        name: xr.DataArray(arrays[name], getattr(given[name], "coords", None), given[name].dims)
        for name in named
    }
    return {**arrays, **labelled}


def broadcast_by_name(conditions: Mapping[str, Any]) -> tuple[dict[str, NDArray], xr.DataArray]:
    """Views of ``conditions``, broadcast by dimension name to one shape, and an array with the
    dimensions and coordinates of that shape; ``ValueError`` if coordinates differ."""
    import xarray as xr

    named = {name: each for name, each in conditions.items() if is_labelled(each)}
    try:
        xr.align(*named.values(), join="exact")
    except ValueError:
        message = "have different coordinates along one dimension; allowed: equal coordinates"
        raise ValueError(f"{', '.join(named)} {message}") from None
    pattern = xr.apply_ufunc(
        lambda *columns: np.broadcast_arrays(*columns)[0], *named.values(), keep_attrs="override"
    )
    found = {name: each.broadcast_like(pattern).values for name, each in named.items()}
    return {**conditions, **found}, pattern
