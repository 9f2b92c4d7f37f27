"""Arguments of users, checked and converted to SI: the conditions, and numbers with a unit in their
name.

This module alone refuses conditions that would silently give a wrong number.  A condition is a
number or an array of numpy, a list of numbers, a column of pandas, an array of xarray or a quantity
of pint.  Any other type is refused, because it may carry a unit, a mask or a date.
"""

import re
import sys
import warnings
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any, NamedTuple, TypedDict

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.core.parameters import Parameters
from thirdbody.core.particles import LARGEST_DIAMETER
from thirdbody.files import format_value
from thirdbody.variables import AXES, CONDITIONS, Axis, decimal

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

TYPES = "numbers and numpy arrays, lists of numbers, pandas columns, xarray arrays, pint quantities"
NEVER_ZERO = "load", "roughness"  # other conditions are 0 without oil or particles, or at rest
_BY_NAME = CONDITIONS | {axis.alias: axis for axis in CONDITIONS.values()}
TIGHTEST, LOOSEST = 1e-11, 1e-2  # ``rtol`` that float64 and the tables attain, and that is allowed
OIL_DENSITY = 850.0  # of mineral oils [kg m-3]
PACKED = "scale_factor", "add_offset"  # attributes of arrays that are not decoded
# by the name of a number: its least and its most usual value, and their unit
Usual = Mapping[str, tuple[float, float, str]]


class ConditionArguments(TypedDict, total=False):
    """The two names of each of the five conditions and of the speed, for help and type checkers."""

    load: ArrayLike | None
    load_N: ArrayLike | None
    viscosity: ArrayLike | None
    viscosity_cSt: ArrayLike | None
    particle_diameter: ArrayLike | None
    particle_diameter_nm: ArrayLike | None
    roughness: ArrayLike | None
    roughness_nm: ArrayLike | None
    particle_density: ArrayLike | None
    particle_density_per_m2: ArrayLike | None
    speed: ArrayLike | None
    speed_m_per_s: ArrayLike | None


class OutOfRangeWarning(UserWarning):
    """A number is outside its usual range, probably because it is in another unit.

    Examples
    --------
    >>> import warnings
    >>> import thirdbody as tb
    >>> with warnings.catch_warnings(record=True) as caught:
    ...     inputs = tb.bearing(pressure_viscosity_per_GPa=0.02)
    >>> print(caught[0].message)
    pressure_viscosity_per_GPa is 0.02 GPa-1; usual: 1 to 100 GPa-1
    """


@dataclass(frozen=True, eq=False)
class Conditions:
    """Conditions in SI, by the names of ``CONDITIONS``.

    Attributes
    ----------
    arrays : dict of arrays
        Float64 copies of the values, which the caller cannot change later.
    is_force : bool
        Whether the load is in newtons.  F_t* then depends on the inputs of the model.
    keys : dict of str
        The name of each condition in tables: the name in the call, for a quantity the alias.
    given : dict of arrays
        The values in the units of ``keys``.
    labelled : dict of xarray.DataArray
        The conditions with named dimensions.
    index : pandas.Index or None
        The index of the columns of pandas.
    """

    arrays: dict[str, NDArray]
    is_force: bool
    keys: dict[str, str]
    given: dict[str, NDArray]
    labelled: dict[str, "xr.DataArray"]
    index: "pd.Index | None"

    def with_load(
        self, parameters: Parameters, arrays: Mapping[str, NDArray] | None = None
    ) -> dict[str, NDArray]:
        """The conditions with the load as F_t* [1] of ``parameters``.

        ``arrays`` replaces the attribute of this name, if conditions have another shape.
        """
        solved = dict(self.arrays if arrays is None else arrays)
        if self.is_force and "load" in solved:
            solved["load"] = solved["load"] * (1.0 / parameters.newtons_per_load)
        return solved


def read_conditions(
    arguments: Mapping[str, Any], parameters: Parameters, without: str | None = None
) -> Conditions:
    """Read the five conditions from ``arguments`` by name or alias, and the speed if present.

    The condition called ``without`` must be absent.  An argument that is None counts as absent.
    The usual range of a load in newtons depends on ``parameters``.  Every public function calls
    this function directly, so that warnings name the line that called the public function.

    Raises
    ------
    TypeError
        For an unknown name.
    ValueError
        For a value whose type is not in ``TYPES``, a condition that is missing or given twice, a
        quantity of another dimension, a number that is negative or not finite, a load or roughness
        of 0, and columns with different indexes.

    Warns
    -----
    OutOfRangeWarning
        Once, for all numbers outside their usual range.
    """
    values = {}
    for key, value in arguments.items():
        axis = axis_of(key)
        if value is None:
            continue
        if axis.name in values or axis.name == without:
            reason = "is searched along" if axis.name == without else "is given twice"
            raise ValueError(f"{key}: {axis.name} {reason}; allowed: each condition once")
        values[axis.name] = key, value
    missing = [axis for name, axis in AXES.items() if name not in values and name != without]
    if missing:
        names = f"{missing[0].name} or {missing[0].alias}"
        raise ValueError(f"{missing[0].name} is missing; allowed: {names}")
    arrays, keys, given, labelled, unusual, is_force = {}, {}, {}, {}, [], False
    for name in CONDITIONS:
        if name in values:
            key, value = values[name]
            typed = _Typed.of(key, value)
            arrays[name] = typed.checked_si(parameters.newtons_per_load)
            unusual += typed.unusual(parameters.newtons_per_load)
            is_force |= typed.is_force
            keys[name], given[name] = typed.column, typed.numbers
            if _is_a(value, "xarray", "DataArray", "Variable"):
                labelled[name] = _with_values(value, arrays[name])
    _warn(unusual, stacklevel=4)
    return Conditions(
        arrays=arrays,
        is_force=is_force,
        keys=keys,
        given=given,
        labelled=labelled,
        index=common_index(arguments),
    )


def axis_of(key: str) -> Axis:
    """The axis with a name or an alias ``key``; ``TypeError`` if there is none."""
    if key not in _BY_NAME:
        raise TypeError(f"unknown condition {key!r}; allowed: {', '.join(_BY_NAME)}")
    return _BY_NAME[key]


def from_si(key: str, values: ArrayLike, newtons_per_load: float) -> NDArray:
    """``values`` [SI], a load F_t* [1], in the unit of the name or alias ``key``."""
    axis = axis_of(key)
    numbers = np.divide(values, 1.0 / newtons_per_load) if key == "load_N" else values
    return axis.from_si(numbers) if key == axis.alias else np.asarray(numbers, float)


def unit_text(key: str) -> str:
    """The unit of the name or alias ``key``."""
    axis = axis_of(key)
    return axis.alias_unit if key == axis.alias else axis.unit


def read_ends(name: str, ends: Any, key: str, parameters: Parameters) -> "Ends":
    """The two ``ends`` of a range, numbers in the unit of ``key`` or quantities.

    Raises ``ValueError``, with the argument ``name``, unless they are positive and increase.  Warns
    as ``read_conditions``.
    """
    newtons = parameters.newtons_per_load
    typed = [_Typed.of(key, end) for end in ends]
    read = Ends.of(typed, newtons)
    are_two = read.si.shape == (2,)
    first, last = read.with_load(parameters) if are_two else (0.0, 0.0)
    if not 0.0 < first < last:
        raise ValueError(f"{name} is {ends!r}; allowed: two numbers, positive and increasing")
    texts = [text.replace(key, name, 1) for end in typed for text in end.unusual(newtons)]
    _warn(texts[:1], stacklevel=4)
    return read


def searched_ends(axis: Axis, parameters: Parameters) -> "Ends":
    """The two ends of the default search along a condition."""
    typed = [_Typed.of(axis.alias, end) for end in axis.searched]
    return Ends.of(typed, parameters.newtons_per_load)


class Ends(NamedTuple):
    """The two ends of a range, SI.  A load that ``is_force`` is in newtons."""

    si: NDArray
    is_force: list[bool]

    @classmethod
    def of(cls, typed: list["_Typed"], newtons_per_load: float) -> "Ends":
        """The ends from numbers with their units."""
        si = np.array([end.checked_si(newtons_per_load) for end in typed])
        return cls(si, [end.is_force for end in typed])

    def with_load(self, parameters: Parameters) -> tuple[float, float]:
        """The ends in SI, a load as F_t* [1] of ``parameters``."""
        loads = self.si * (1.0 / parameters.newtons_per_load)
        first, last = np.where(self.is_force, loads, self.si).tolist()
        return first, last


class _Typed(NamedTuple):
    """Numbers of a condition in the unit of ``column``, its name in tables.

    This is the ``key`` of the call; of a quantity it is the alias, or the name of a load F_t*.
    """

    key: str
    axis: Axis
    column: str
    numbers: NDArray

    @classmethod
    def of(cls, key: str, value: Any) -> "_Typed":
        """The numbers of a ``value`` for the name or alias ``key``."""
        axis = axis_of(key)
        numbers, unit = _numbers_and_unit(key, value)
        if unit is None:
            return cls(key, axis, key, numbers)
        in_alias = axis.name != "load" or unit.is_compatible_with("N")
        column = axis.alias if in_alias else axis.name
        wanted = unit_of(key, unit_text(column))
        if not unit.is_compatible_with(wanted):
            such = f"a unit such as {axis.alias_unit}"
            raise ValueError(f"{key} is in {unit:~}; allowed: {such if in_alias else '1 or N'}")
        return cls(key, axis, column, decimal((numbers * unit).to(wanted).magnitude))

    @property
    def is_force(self) -> bool:
        """Whether this is a load in newtons."""
        return self.column == "load_N"

    def checked_si(self, newtons_per_load: float) -> NDArray:
        """The numbers in SI, a load that ``is_force`` in newtons.

        Raises ``ValueError`` for a number that no interface has.
        """
        is_alias = self.column == self.axis.alias
        si = np.asarray(self.axis.to_si(self.numbers) if is_alias else self.numbers)
        number = si * (1.0 / newtons_per_load) if self.is_force else si
        never_zero = self.axis.name in NEVER_ZERO
        allowed = ((number > 0.0) if never_zero else (number >= 0.0)) & np.isfinite(number)
        most = LARGEST_DIAMETER if self.axis.name == "particle_diameter" else np.inf
        allowed &= si <= most
        if not allowed.all():
            sign = "positive" if never_zero else "zero or positive"
            limit = f" up to {most:g} m" if most < np.inf else ""
            message = f"{self.key} is {self.numbers[~allowed][0]:g}"
            raise ValueError(f"{message}; allowed: {sign} finite numbers{limit}")
        return si

    def unusual(self, newtons_per_load: float) -> list[str]:
        """A message on the first number outside the usual range; empty if all are inside."""
        least, most = from_si(self.column, self.axis.usual, newtons_per_load)
        return unusual_text(self.key, self.numbers, least, most, unit_text(self.column))


def _with_values(labelled: Any, values: NDArray) -> "xr.DataArray":
    """The array ``labelled`` of xarray with other ``values`` and without attributes."""
    import xarray as xr

    return xr.DataArray(values, getattr(labelled, "coords", None), labelled.dims)


def common_index(arguments: Mapping[str, Any]) -> "pd.Index | None":
    """The index that all columns of pandas share, None without columns.

    Raises ``ValueError`` if the indexes differ.
    """
    columns = {key: value for key, value in arguments.items() if _is_a(value, "pandas", "Series")}
    if not columns:
        return None
    first, *others = columns
    for other in others:
        if not columns[other].index.equals(columns[first].index):
            message = f"{first} and {other} have different indexes"
            raise ValueError(f"{message}; allowed: columns of one table, or their .to_numpy()")
    return columns[first].index


def indexed(table: "pd.DataFrame", index: "pd.Index | None", points: ArrayLike) -> "pd.DataFrame":
    """The ``table`` with the labels of ``index``; unchanged if ``index`` is None.

    The rows of the table belong to ``points``: flat indices into an array whose last axis has the
    rows of ``index``.
    """
    if index is None:
        return table
    return table.set_index(index.take(np.asarray(points, int) % max(len(index), 1)))


# ---- types of values


def numbers_in(name: str, value: Any, unit: str) -> NDArray:
    """A value of a type in ``TYPES`` as float64 numbers.

    A quantity is converted to ``unit``, in the spelling of UDUNITS.  pint raises an error if its
    dimension is another.
    """
    numbers, unit_of_value = _numbers_and_unit(name, value)
    if unit_of_value is None:
        return numbers
    is_quantity = _is_a(value, "pint", "Quantity")
    quantity = value if is_quantity else registry().Quantity(numbers, unit_of_value)
    return np.asarray(quantity.to(str(registry().Unit(unit))).magnitude, float)


def _numbers_and_unit(name: str, value: Any) -> tuple[NDArray, Any]:
    """A value of a type in ``TYPES`` as float64 numbers, and its unit of pint or None.

    Raises ``ValueError`` for any other type.
    """
    if _is_a(value, "pint", "Quantity"):
        return _numbers(name, value.magnitude), value.units
    if _is_a(value, "xarray", "DataArray", "Variable"):
        packed = [attribute for attribute in PACKED if attribute in value.attrs]
        if packed:
            message = f"{name} has the attribute {packed[0]}, with numbers as a file stores them"
            raise ValueError(f"{message}; allowed: decoded numbers (xarray.decode_cf)")
        numbers, unit = _numbers_and_unit(name, value.data)
        text = value.attrs.get("units")
        return numbers, unit_of(name, text) if unit is None and text is not None else unit
    if _is_a(value, "pandas", "Series"):
        dtype = value.dtype
        package = type(dtype).__module__.partition(".")[0]  # types of other packages may have units
        if package not in ("numpy", "pandas") or dtype.kind not in "iuf":
            raise ValueError(f"{name} is a column of {dtype}; allowed: {TYPES}")
        return value.to_numpy(float, copy=True, na_value=np.nan), None
    return _numbers(name, value), None


def _numbers(name, value):
    """A number, an array of numpy or a list of numbers as float64; ``ValueError`` for any other
    type."""
    if isinstance(value, list | tuple):
        if all(map(_is_number, _flat(value))):
            return np.array(value, float)
        types = sorted({_type_name(item) for item in _flat(value) if not _is_number(item)})
        raise ValueError(f"{name} is a list with {', '.join(types)}; allowed: {TYPES}")
    if _is_number(value) or (type(value) is np.ndarray and value.dtype.kind in "iuf"):
        return np.array(value, float)
    raise ValueError(f"{name} is of type {_type_name(value)}; allowed: {TYPES}")


def _flat(values):
    for value in values:
        if isinstance(value, list | tuple):
            yield from _flat(value)
        else:
            yield value


def _is_number(value):
    if isinstance(value, np.generic):
        return value.dtype.kind in "iuf"  # no date, no bool
    return isinstance(value, int | float) and not isinstance(value, bool)


def _type_name(value):
    name = f"{type(value).__module__}.{type(value).__qualname__}".removeprefix("builtins.")
    return f"{name} of {value.dtype}" if type(value) is np.ndarray else name


def _is_a(value, package, *names):
    """Whether a value is of a class in a package.  The package is not imported for that."""
    module = sys.modules.get(package)
    return module is not None and isinstance(value, tuple(getattr(module, name) for name in names))


# units, their powers and products; pint would evaluate any other text
TERM = r"(?:[^\W\d]|[%⁻])+(?:(?:\*\*|\^)?-?\d)?"
UNIT = rf"(?:1\s*/\s*)?{TERM}(?:(?:\s*[*/]\s*|\s+){TERM})*|1|-"


def unit_of(name: str, text: str) -> Any:
    """The unit of pint that a ``text`` of the condition ``name`` spells."""
    if text in ("1", "-"):
        return registry().Unit("dimensionless")
    if not re.fullmatch(UNIT, str(text)):
        raise ValueError(f"{name} is in {text!r}; allowed: units, their powers and products")
    return registry().Unit(text)


@cache
def registry() -> Any:
    """The unit registry of pint.  It also reads powers as UDUNITS writes them: ``m2 s-1``."""
    import pint

    power = re.compile(r"(?<=[A-Za-z])(?<![0-9][eE])(?=-?\d)")
    return pint.UnitRegistry(preprocessors=[lambda text: power.sub("**", text)])


# ---- other arguments


def broadcast_by_name(conditions: Conditions) -> tuple[dict[str, NDArray], "xr.DataArray"]:
    """Broadcast conditions by the names of their dimensions.

    Returns views of one shape, and an array with the dimensions and coordinates of that shape.
    Raises ``ValueError`` for an array without named dimensions.  xarray raises an error for
    different coordinates.
    """
    import xarray as xr

    labelled = {}
    for name, values in conditions.arrays.items():
        if name not in conditions.labelled and values.ndim > 0:
            message = f"{conditions.keys[name]} is an array without named dimensions"
            raise ValueError(f"{message}; allowed: a number or an xarray.DataArray")
        labelled[name] = conditions.labelled.get(name, xr.DataArray(values))
    pattern = xr.apply_ufunc(
        lambda *columns: np.broadcast_arrays(*columns)[0], *labelled.values(), join="exact"
    )
    views = {name: array.broadcast_like(pattern).values for name, array in labelled.items()}
    return views, pattern


def checked_variables(
    variables: str | Collection[str] | None, allowed: Collection[str]
) -> Collection[str]:
    """The names ``variables``, by default all that are ``allowed``; ``ValueError`` for others."""
    if variables is None:
        return allowed
    names = [variables] if isinstance(variables, str) else [*variables]
    unknown = [name for name in names if name not in allowed]
    if unknown or not names:
        raise ValueError(f"variables has {unknown}; allowed: one or more of {', '.join(allowed)}")
    return names


def check_rtol(rtol: float) -> None:
    """Raise ``ValueError`` unless ``rtol`` is allowed."""
    if not TIGHTEST <= rtol <= LOOSEST:
        raise ValueError(f"rtol is {rtol!r}; allowed: {TIGHTEST:g} to {LOOSEST:g}")


def check_count(count: int) -> None:
    """Raise ``ValueError`` for less than two samples: a search needs two to look between."""
    if count < 2:
        raise ValueError(f"count is {count!r}; allowed: 2 or more")


def single_number(name: str, value: Any, unit: str = "1") -> float:
    """A number or quantity as a float in ``unit``; ``ValueError`` for several numbers."""
    numbers = numbers_in(name, value, unit)
    if numbers.ndim:
        raise ValueError(f"{name} is {format_value(value)}; allowed: one number")
    return float(numbers)


def checked_number(name: str, value: Any, positive: bool = True, unit: str = "1") -> float:
    """A number or quantity as a float in ``unit``.

    Raises ``ValueError`` unless it is a single finite number, at least 0, or above 0 if
    ``positive``.
    """
    number = single_number(name, value, unit)
    if not 0.0 <= number < np.inf or (positive and number == 0.0):
        sign = "a positive number" if positive else "zero or a positive number"
        raise ValueError(f"{name} is {format_value(value)}; allowed: {sign}")
    return number


def checked_numbers(
    arguments: Mapping[str, Any], usual: Usual, stacklevel: int
) -> dict[str, float]:
    """Numbers or quantities as floats in the units of ``usual``.

    Raises ``ValueError`` unless all are positive.  Issues one ``OutOfRangeWarning`` for all unusual
    numbers together.
    """
    numbers = {
        name: checked_number(name, value, unit=usual[name][2]) for name, value in arguments.items()
    }
    texts = [unusual_text(name, number, *usual[name]) for name, number in numbers.items()]
    _warn(sum(texts, []), stacklevel)
    return numbers


# ---- unusual numbers


def unusual_text(name: str, numbers: ArrayLike, least: float, most: float, unit: str) -> list[str]:
    """A message on the first number outside its usual range; empty if all are inside.

    0 is never unusual, as it stands for no oil or no particles.
    """
    numbers = np.ravel(numbers)
    outside = numbers[((numbers < least) & (numbers != 0.0)) | (numbers > most)]
    if not outside.size:
        return []
    suffix = "" if unit == "1" else f" {unit}"
    ends = " to ".join(f"{float(f'{end:.2g}'):g}" for end in (least, most))
    return [f"{name} is {outside[0]:g}{suffix}; usual: {ends}{suffix}"]


def _warn(unusual: list[str], stacklevel: int) -> None:
    """Issue one warning with all messages, for the line that ``stacklevel`` names."""
    if unusual:
        warnings.warn(", and ".join(unusual), OutOfRangeWarning, stacklevel=stacklevel)
