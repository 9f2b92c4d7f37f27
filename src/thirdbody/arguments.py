"""The five conditions as given, and checks of the arguments of public functions.

Conditions are numbers, quantities with units or arrays with named dimensions, under any of their
names.  An error is one line; unusual numbers cause an ``OutOfRangeWarning``.
"""

import sys
import warnings
from collections.abc import Collection, Iterable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import replace
from decimal import Decimal
from functools import lru_cache
from itertools import zip_longest
from math import prod
from numbers import Integral, Real
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.core.floats import LEAST
from thirdbody.core.parameters import Parameters
from thirdbody.messages import did_you_mean, format_row, format_value
from thirdbody.units import (
    CONDITIONS,
    ENGINEERING,
    Unit,
    has_unit,
    in_own_unit,
    is_labelled,
    plain_numbers,
    unit_of,
)

if TYPE_CHECKING:
    import xarray as xr

NEVER_ZERO = "load", "roughness"  # the others are 0 without oil or particles
LARGEST = 1e100  # x_a in any unit, whose square float64 holds
PACKED = "scale_factor", "add_offset"  # attributes of arrays that are not decoded
MOST_VALUES = 1_000_000  # of a sweep or a curve
MOST_POINTS = 10**9  # in memory: 8 GB a variable
# least and most usual value of numbers by name, and their unit
Usual = Mapping[str, tuple[float, float, str]]
_CHECKED = ContextVar("whether conditions have been checked", default=False)


class OutOfRangeWarning(UserWarning):
    """Numbers are outside their usual range, probably because they are in another unit.

    Examples
    --------
    >>> import warnings
    >>> import thirdbody as tb
    >>> with warnings.catch_warnings(record=True) as caught:
    ...     inputs = tb.bearing(pressure_viscosity_per_GPa=0.02)
    >>> print(caught[0].message)
    pressure_viscosity_per_GPa is 0.02 GPa-1; usual: 1 to 100 GPa-1
    """


def in_si(
    given: Mapping[str, ArrayLike], parameters: Parameters, without: str | None = None
) -> dict[str, NDArray]:
    """The ``given`` conditions, numbers or quantities under any of their names, in SI by the
    arguments of ``solve``; warns like ``solve``, in the given units.

    The condition ``without`` must not be given.  Raises ``ValueError`` if a condition is missing,
    given twice, unknown or not allowed, and for numbers that ``solve`` refuses.
    """
    common_index(given)
    units = {}
    for key in given:
        name = unit_of(key).condition
        if name in units or name == without:
            reason = "is searched along" if name == without else "is given twice"
            raise ValueError(f"{key}: {name} {reason}; allowed: each axis once")
        units[name] = unit_of(key)
    newtons = parameters.newtons_per_load
    found, typed, usual = {}, {}, {}
    for name in CONDITIONS:
        if name in units:
            key = units[name].key
            unit, found[name] = _numbers(units[name], given[key], newtons)
            typed[key] = unit.from_si(found[name], newtons)
            usual[key] = *unit.from_si(CONDITIONS[name]["usual"], newtons), unit.text
        elif name != without:
            raise ValueError(f"{name} is missing; allowed: {name} or {ENGINEERING[name]}")
    warn_outside(typed, usual)
    return found


def common_index(given: Mapping[str, Any]) -> Any:
    """The index of the ``given`` columns of pandas, None if there are none; ``ValueError`` unless it is the same."""
    columns = {key: each for key, each in given.items() if is_column(each)}
    if not columns:
        return None
    first, *others = columns
    index = columns[first].index
    for other in others:
        if not columns[other].index.equals(index):
            message = f"{first} and {other} have different indexes"
            raise ValueError(f"{message}; allowed: columns of one table, or their .to_numpy()")
    return index


def is_column(given: Any) -> bool:
    """Whether ``given`` is a ``Series`` of pandas."""
    return hasattr(given, "iloc") and getattr(given, "ndim", 0) == 1


def ends_in_si(name: str, ends: Any, unit: Unit, parameters: Parameters) -> NDArray:
    """The ends of a range, two numbers in ``unit`` or quantities, in SI; ``ValueError`` unless they
    are positive and increase, and a warning like ``in_si``."""
    newtons = parameters.newtons_per_load
    own, numbers = in_own_unit(replace(unit, key=name), ends, newtons)
    allowed = "two numbers, positive and increasing"
    array = checked_array(name, numbers, allowed)
    if array.shape != (2,) or not 0.0 < array[0] < array[1] < np.inf:
        raise ValueError(f"{name} is {format_value(ends)}; allowed: {allowed}")
    usual = own.from_si(CONDITIONS[unit.condition]["usual"], newtons)
    warn_outside({name: array}, {name: (*usual, own.text)})
    return own.to_si(array, newtons)


def _numbers(unit: Unit, given: Any, newtons_per_load: float) -> tuple[Unit, NDArray]:
    """The unit of numbers or quantities, and a float64 copy in SI; for an array with named
    dimensions, of its values."""
    key = unit.key
    rows = None
    if is_column(given):
        rows, given = given.index, _cells(key, given)
    packed = [each for each in PACKED if each in getattr(given, "attrs", {})]
    if packed:
        message = f"{key} has the attribute {packed[0]}, with numbers as a file stores them"
        raise ValueError(f"{message}; allowed: decoded ones (xarray.decode_cf)")
    own, bare = in_own_unit(unit, given, newtons_per_load)
    array = checked_array(key, bare.data if is_labelled(bare) else bare)
    least, sign = (LEAST, "positive") if unit.condition in NEVER_ZERO else (0, "zero or positive")
    allowed, most = (array >= least) & np.isfinite(array), ""
    if unit.condition == "particle_diameter" and (array > LARGEST).any():
        allowed, most = allowed & (array <= LARGEST), f" up to {LARGEST:g}"
    wrong = array[~allowed]
    if wrong.size:
        row = "" if rows is None else f" in row {format_row(rows[np.argmin(allowed)])}"
        raise ValueError(f"{key} is {wrong[0]:g}{row}; allowed: {sign} finite numbers{most}")
    return own, np.array(own.to_si(array, newtons_per_load))


def _cells(key: str, column: Any) -> Any:
    """The values of a column; ``ValueError`` names the row of a cell that is not a number."""
    if hasattr(column.array, "quantity"):  # of pint-pandas
        return column.array
    if column.dtype.kind == "O":
        for row, cell in column.items():
            if not (_is_number(cell) or has_unit(cell)):
                message = f"{key} is {format_value(cell)} in row {format_row(row)}"
                raise ValueError(f"{message}; allowed: numbers")
    return column.to_numpy()


def broadcast_by_name(
    given: Mapping[str, Any], arrays: Mapping[str, NDArray]
) -> tuple[dict[str, Any], dict[str, NDArray], "xr.DataArray"]:
    """Broadcast the ``arrays`` of conditions [SI] by the names of the dimensions of the ``given`` ones, which
    have their own names.

    Returns them with these names and coordinates; views of one shape; and an array with the
    dimensions and coordinates of that shape.
    """
    import xarray as xr

    named = {}
    for key, each in given.items():
        name = unit_of(key).condition
        if is_labelled(each):
            coordinates = getattr(each, "coords", None)
            named[name] = xr.DataArray(arrays[name], coordinates, each.dims)
        elif arrays[name].ndim > 0:
            allowed = "a number or an xarray.DataArray"
            raise ValueError(f"{key} is an array without named dimensions; allowed: {allowed}")
    try:
        xr.align(*named.values(), join="exact")
    except ValueError:
        keys = ", ".join(key for key in given if unit_of(key).condition in named)
        message = "have different coordinates along one dimension; allowed: equal coordinates"
        raise ValueError(f"{keys} {message}") from None
    pattern = xr.apply_ufunc(
        lambda *columns: np.broadcast_arrays(*columns)[0], *named.values(), keep_attrs="override"
    )
    views = {name: each.broadcast_like(pattern).values for name, each in named.items()}
    return {**arrays, **named}, {**arrays, **views}, pattern


def checked_parameters(parameters: Any) -> Parameters:
    """``parameters``, by default the calibrated ones; ``ValueError`` unless they are ``Parameters``."""
    if parameters is None:
        return _published_parameters()
    if not isinstance(parameters, Parameters):
        allowed = "Parameters, as returned by load_parameters()"
        raise ValueError(f"parameters is a {type(parameters).__name__}; allowed: {allowed}")
    return parameters


@lru_cache
def _published_parameters():
    """Cached: reading the files takes longer than solving one point."""
    from thirdbody.configuration.inputs import load_parameters

    return load_parameters()


def checked_names(argument: str, given: Any, known: Collection[str]) -> Collection[str]:
    """The names of an ``argument``, one or more; ``ValueError`` unless all are in ``known``."""
    allowed = f"allowed: one or more of {', '.join(known)}"
    names = [given] if isinstance(given, str) else given
    listed = isinstance(names, Collection) and getattr(names, "ndim", 1) == 1
    if not listed or isinstance(names, bytes) or not len(names):
        raise ValueError(f"{argument} is {format_value(given)}; {allowed}")
    for name in names:
        if not isinstance(name, str) or name not in known:
            raise ValueError(
                f"{argument} has {format_value(name)}; {allowed}{did_you_mean(name, known)}"
            )
    return names


def check_rtol(rtol: Any) -> None:
    """Raise ``ValueError`` unless ``rtol`` is attainable with float64 and the tables."""
    if not isinstance(rtol, Real) or not 1e-11 <= rtol <= 1e-2:
        raise ValueError(f"rtol is {format_value(rtol)}; allowed: 1e-11 to 1e-2")


def check_points(arrays: Mapping[str, NDArray], given: Iterable[str] = ()) -> None:
    """Raise ``ValueError`` unless ``arrays``, by condition, broadcast to at most ``MOST_POINTS``; messages have
    the names that are ``given``."""
    typed = {unit_of(key).condition: key for key in given}
    shapes = {typed.get(name, name): array.shape for name, array in arrays.items() if array.ndim}
    columns = zip_longest(*(shape[::-1] for shape in shapes.values()), fillvalue=1)
    lengths = [set(column) - {1} or {1} for column in columns]
    if any(len(each) > 1 for each in lengths):
        message = ", ".join(f"{name} has {shape}" for name, shape in shapes.items())
        raise ValueError(f"shapes do not broadcast: {message}; allowed: shapes that do")
    points = prod(each.pop() for each in lengths)
    if points > MOST_POINTS:
        message = f"{', '.join(shapes)} make {points:.3g} points; allowed: at most {MOST_POINTS:g}"
        raise ValueError(f"{message} in one call; thirdbody.stream writes any number to a file")


def checked_array(name: str, given: Any, allowed: str = "numbers") -> NDArray:
    """Real numbers as a float64 array, which may contain inf or nan; quantities are refused."""
    several = given if isinstance(given, list | tuple) else [given]
    if any(isinstance(each, bool | np.bool_) for each in several):  # numpy takes True as 1
        raise ValueError(f"{name} is {format_value(given)}; allowed: {allowed}")
    if any(has_unit(each) or is_labelled(each) or hasattr(each, "iloc") for each in several):
        raise ValueError(f"{name} is a {type(given).__name__}; allowed: {allowed}")
    if np.ma.is_masked(given):
        raise ValueError(f"{name} has masked values; allowed: numbers at every point")
    try:
        array = np.asarray(given)
    except (TypeError, ValueError):  # a ragged list, or an object of another package
        raise ValueError(f"{name} is {format_value(given)}; allowed: {allowed}") from None
    check_points({name: array})
    try:
        if array.dtype.kind in "iuf" or all(map(_is_number, array.flat)):
            return np.asarray(array, float)
    except OverflowError:
        message = "has an integer beyond 1.8e308; allowed: finite numbers"
        raise ValueError(f"{name} {message}") from None
    raise ValueError(f"{name} is {format_value(given)}; allowed: {allowed}")


def _is_number(given: Any) -> bool:
    return isinstance(given, Real | Decimal) and not isinstance(given, bool)


def checked_number(name: str, value: Any, positive: bool = True) -> float:
    """A value as a float; ``ValueError`` unless it is a finite number that is ``positive``, or else not negative."""
    allowed = "positive numbers" if positive else "zero or positive numbers"
    number = checked_array(name, value, allowed)
    if number.ndim or not 0.0 <= number < np.inf or (positive and number == 0.0):
        raise ValueError(f"{name} is {format_value(value)}; allowed: {allowed}")
    return float(number)


def checked_numbers(given: Mapping[str, Any], usual: Usual) -> dict[str, float]:
    """The ``given`` numbers or quantities in the units of ``usual``; warns of unusual ones.

    Raises ``ValueError`` unless all are positive.
    """
    numbers = {
        name: checked_number(name, plain_numbers(name, each, usual[name][2]))
        for name, each in given.items()
    }
    warn_outside(numbers, usual)
    return numbers


def check_count(name: str, count: Any) -> None:
    """Raise ``ValueError`` unless a number of values is an integer from 2 to ``MOST_VALUES``."""
    whole = isinstance(count, Integral) and not isinstance(count, bool)
    if not whole or not 2 <= count <= MOST_VALUES:
        allowed = f"whole numbers from 2 to {MOST_VALUES}"
        raise ValueError(f"{name} is {format_value(count)}; allowed: {allowed}")


def warn_outside(given: Mapping[str, ArrayLike], usual: Usual) -> None:
    """Issue one ``OutOfRangeWarning`` for all values outside their usual range; 0 means none."""
    if _CHECKED.get():
        return
    found = []
    for name, values in given.items():
        least, most, unit = usual[name]
        values = np.ravel(values)
        outside = values[((values < least) & (values != 0.0)) | (values > most)]
        if outside.size:
            suffix = "" if unit == "1" else f" {unit}"
            ends = " to ".join(f"{float(f'{end:.2g}'):g}" for end in (least, most))
            found.append(f"{name} is {outside[0]:g}{suffix}; usual: {ends}{suffix}")
    if found:
        warnings.warn(", and ".join(found), OutOfRangeWarning, stacklevel=_outside_of_package())


@contextmanager
def without_warnings() -> Iterator[None]:
    """A context without warnings of conditions that have been checked; of other threads it changes nothing."""
    token = _CHECKED.set(True)
    try:
        yield
    finally:
        _CHECKED.reset(token)


def _outside_of_package() -> int:
    """The ``stacklevel`` of the nearest caller outside this package."""
    frame, level = sys._getframe(1), 1
    package = __name__.partition(".")[0]
    while frame and frame.f_globals.get("__name__", "").partition(".")[0] == package:
        frame, level = frame.f_back, level + 1
    return level
