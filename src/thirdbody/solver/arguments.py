"""The checks of what is given to ``solve``, ``grid`` and ``stream``: one line for each mistake."""

from __future__ import annotations

from collections.abc import Collection
from itertools import zip_longest
from math import prod
from numbers import Real
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import LEAST
from thirdbody.solver.labelled import is_labelled
from thirdbody.solver.solution import VARIABLES
from thirdbody.solver.units import without_unit

NEVER_ZERO = "load", "roughness"  # the other conditions are 0 where there is no oil, or no particle
MOST_POINTS = 10**9  # in memory: 8 GB a variable


def check_parameters(parameters: Any) -> None:
    """Raises ``ValueError`` unless ``parameters`` are what ``load_parameters`` gives."""
    if not isinstance(parameters, Parameters):
        kind = type(parameters).__name__
        raise ValueError(f"parameters is a {kind}; allowed: Parameters, as of load_parameters()")


def check_variables(variables: Any, known: Collection[str] = VARIABLES) -> None:
    """Raises ``ValueError`` unless ``variables`` is a collection of names out of ``known``."""
    allowed = f"allowed: a list out of {', '.join(known)}"
    if not isinstance(variables, Collection):
        raise ValueError(f"variables is a {type(variables).__name__}; {allowed}")
    unknown = [name for name in variables if name not in known]
    if isinstance(variables, str) or unknown:
        shown = variables if isinstance(variables, str) else unknown[0]
        raise ValueError(f"variables has {shown!r}; {allowed}")


def check_rtol(rtol: Any) -> None:
    """Raises ``ValueError`` unless ``rtol`` is within what float64 and the tables can promise."""
    if not isinstance(rtol, Real) or not 1e-11 <= rtol <= 1e-2:
        raise ValueError(f"rtol is {rtol!r}; allowed: 1e-11 to 1e-2")


def check_points(*arrays: NDArray) -> None:
    """Raises ``ValueError`` if ``arrays`` broadcast to more points than memory holds."""
    sizes = zip_longest(*(array.shape[::-1] for array in arrays), fillvalue=1)
    points = prod(map(max, sizes))
    if points > MOST_POINTS:
        told = f"{points:.3g} points in one call; allowed: at most {MOST_POINTS:g}"
        raise ValueError(f"{told}, and thirdbody.stream writes any number to a file")


def checked_axis(name: str, values: ArrayLike, parameters: Parameters) -> NDArray:
    """A condition as float64 in SI, or a ``ValueError`` that names it and its first bad value.

    Parameters
    ----------
    name : str
        The condition, an argument of ``solve``.
    values : array_like
        Numbers or quantities; of an array with named dimensions its values.
    parameters : Parameters
        Say how many newtons a load is.
    """
    if hasattr(values, "iloc"):
        kind = type(values).__name__
        raise ValueError(
            f"{name} is a {kind} of pandas; allowed: .to_numpy() or .to_xarray() of it"
        )
    given = values.data if is_labelled(values) else values
    given = without_unit(name, given, parameters.newtons_per_load)
    if np.ma.is_masked(given):
        raise ValueError(f"{name} has masked values; allowed: numbers at every point")
    try:
        array = np.asarray(given)
    except ValueError:
        raise ValueError(f"{name} is a ragged list; allowed: numbers of one shape") from None
    if array.dtype.kind == "O" and all(type(each) in (int, float) for each in array.flat):
        array = _of_long_integers(name, array)
    if array.dtype.kind not in "iuf":
        raise ValueError(f"{name} is of type {array.dtype}; allowed: numbers")
    array = np.asarray(array, float)
    zero_allowed = name not in NEVER_ZERO
    least = 0.0 if zero_allowed else LEAST
    if not (array.min(initial=1.0) >= least and array.max(initial=1.0) < np.inf):
        bad = array[~((array >= least) & np.isfinite(array))].flat[0]
        sign = "zero or positive" if zero_allowed else "positive"
        raise ValueError(f"{name} is {bad:g}; allowed: {sign} finite numbers")
    return array


def _of_long_integers(name, array):
    """An array of Python's integers, which numpy takes for objects where they are long."""
    try:
        return array.astype(float)
    except OverflowError:
        told = "has an integer beyond 1.8e308; allowed: finite numbers"
        raise ValueError(f"{name} {told}") from None
