"""Arrays of xarray: broadcasting by dimension name, and labels for the results.

xarray is imported only if such an array is given.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import reduce
from operator import add
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from thirdbody.units import is_labelled

if TYPE_CHECKING:
    import xarray as xr


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
    """Broadcast ``conditions`` by dimension name to arrays of one shape, and return with them an array with
    the dimensions and coordinates of that shape; ``ValueError`` if coordinates differ."""
    import xarray as xr

    named = {name: each for name, each in conditions.items() if is_labelled(each)}
    try:
        labelled = xr.align(*named.values(), join="exact")
    except ValueError:
        message = "have different coordinates along one dimension; allowed: equal coordinates"
        raise ValueError(f"{', '.join(named)} {message}") from None
    with np.errstate(over="ignore"):
        pattern = reduce(add, labelled)  # merges the coordinates
    _, *labelled = xr.broadcast(pattern, *labelled)
    found = {name: each.values for name, each in zip(named, labelled, strict=True)}
    return {**conditions, **found}, pattern


def labelled_as(pattern: xr.DataArray, found: Mapping[str, NDArray]) -> dict[str, xr.DataArray]:
    """The arrays ``found``, by name, each as a ``DataArray`` like ``pattern``."""
    return {name: pattern.copy(data=values).rename(name) for name, values in found.items()}
