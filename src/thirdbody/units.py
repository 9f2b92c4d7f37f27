"""Units of the five conditions: names that carry a unit, and quantities of other packages.

``viscosity`` is in SI, ``viscosity_cSt`` in centistokes.  ``load`` is F_t* [1], ``load_N`` the
normal load F_t [N].  Quantities of pint, astropy, unyt and quantities, and arrays of xarray with
the attribute ``units``, carry their own unit.  ``units.toml`` is the table of the conditions.
"""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.extras import require
from thirdbody.messages import did_you_mean, format_value
from thirdbody.toml_tables import toml_beside


@dataclass(frozen=True)
class Unit:
    """A name for a condition, such as ``viscosity_cSt``, and its unit.

    ``condition`` is the corresponding argument of ``solve``, ``text`` the unit in UDUNITS spelling
    and ``scale`` its value in SI, for the load in newtons if it ``is_force``.
    """

    key: str
    condition: str
    text: str
    scale: float = 1.0
    is_force: bool = False

    def to_si(self, values: ArrayLike, newtons_per_load: float = 1.0) -> NDArray:
        """``values`` in the unit of ``solve``, SI or F_t* of a load: the floats nearest to the decimal result,
        300 nm is 3e-07 m."""
        numbers = np.asarray(values, float) if self.scale == 1.0 else decimal(values, self.scale)
        return np.multiply(numbers, 1.0 / newtons_per_load) if self.is_force else numbers

    def from_si(self, values: ArrayLike, newtons_per_load: float = 1.0) -> NDArray:
        """``values`` in SI converted to this unit."""
        numbers = np.divide(values, 1.0 / newtons_per_load) if self.is_force else values
        return np.divide(numbers, self.scale)


FORCE = "N", "a force, e.g. in N"  # another dimension of the load
PLAIN = "plain numbers, such as the nominal value"
CONDITIONS = toml_beside(__file__)
ENGINEERING = {name: each["engineering"] for name, each in CONDITIONS.items()}
UNITS = {
    name: Unit(key=name, condition=name, text=each["unit"]) for name, each in CONDITIONS.items()
}
for name, each in CONDITIONS.items():
    key, is_force = each["engineering"], name == "load"
    UNITS[key] = Unit(
        key=key,
        condition=name,
        text=each["engineering_unit"],
        scale=each["scale"],
        is_force=is_force,
    )
SI = {name: UNITS[name] for name in CONDITIONS}
# other arguments of functions that take conditions
OPTIONS = "parameters", "variables", "rtol", "progress"
SEARCHED = {name: tuple(each["searched"]) for name, each in CONDITIONS.items()}


def unit_of(key: Any, others: Iterable[str] = OPTIONS) -> Unit:
    """The unit of a name; raises ``ValueError`` if there is no such name, which the ``others`` may be."""
    if not isinstance(key, str) or key not in UNITS:
        allowed = ", ".join(UNITS) + did_you_mean(key, (*UNITS, *others))
        raise ValueError(f"unknown axis {format_value(key)}; allowed: {allowed}")
    return UNITS[key]


def units_in_tables(given: Mapping[str, Any]) -> dict[str, Unit]:
    """The unit of each of the ``given`` conditions in tables, by condition: that of its name, of quantities the
    one in engineering units."""
    units = {unit_of(key).condition: unit_of(key) for key in given}
    quantities = {unit_of(key).condition for key, each in given.items() if has_unit(each)}
    return units | {name: UNITS[ENGINEERING[name]] for name in quantities}


def in_own_unit(unit: Unit, given: Any, newtons_per_load: float) -> tuple[Unit, Any]:
    """The unit of ``given`` and plain numbers in it: of quantities their own unit, of several with
    different units SI, and of anything else ``unit``, that of the name of the argument; ``ValueError``
    for an unknown unit, a wrong dimension, uncertainties, and quantities mixed with numbers."""
    if is_labelled(given) and has_unit(given.data):
        given = given.data
    given = getattr(given, "quantity", given)  # an array of pint-pandas
    of_objects = isinstance(given, np.ndarray) and given.dtype == np.dtype("O")
    if of_objects or isinstance(given, list | tuple):
        parts = list(given.flat) if of_objects else given
        kinds = set(map(type, parts))
        if not any(map(has_unit, kinds)) and not kinds & {list, tuple}:
            return unit, given
        found = [in_own_unit(unit, each, newtons_per_load) for each in parts]
        plain = {own is unit for own, _ in found}
        if plain == {True}:
            return unit, given
        if True in plain:
            message = f"{unit.key} has quantities and plain numbers"
            raise ValueError(f"{message}; allowed: either of them")
        common, numbers = found[0][0], [number for _, number in found]
        if {own for own, _ in found} != {common}:
            common = replace(UNITS[unit.condition], key=unit.key)
            numbers = [own.to_si(number, newtons_per_load) for own, number in found]
        return common, np.reshape(numbers, given.shape) if of_objects else numbers
    if not has_unit(given):
        return unit, given
    quantity = given if is_quantity(given) else _of_pint(unit, given)
    is_force = unit.condition == "load" and quantity.is_compatible_with(FORCE[0])
    wanted, words = FORCE if is_force else CONDITIONS[unit.condition]["dimension"]
    if not quantity.is_compatible_with(wanted):
        found = f"{quantity.units:~}" or "no unit"
        raise ValueError(f"{unit.key} is in {found}; allowed: {words}")
    try:
        numbers = np.asarray(quantity.magnitude, float)
    except (TypeError, ValueError):
        kind = type(quantity.magnitude).__name__
        raise ValueError(f"{unit.key} is a quantity of {kind}; allowed: {PLAIN}") from None
    scale = float((1.0 * quantity.units).to(wanted).magnitude)
    return Unit(unit.key, unit.condition, f"{quantity.units:~}" or "1", scale, is_force), numbers


def plain_numbers(name: str, given: Any, unit: str) -> Any:
    """Numbers in ``unit``, in UDUNITS spelling, if ``given`` is a quantity; anything else as it is."""
    if not has_unit(given):
        return given
    known = registry()
    try:
        if not is_quantity(given):
            given = known.Quantity(np.asarray(given), known.Unit(_unit_text(given)))
        numbers = np.asarray(given.to(str(known.Unit(unit))).magnitude, float)
        return numbers if numbers.ndim else float(numbers)
    except Exception:  # pint raises many types
        raise ValueError(
            f"{name} is {format_value(given)}; allowed: a quantity in {unit}"
        ) from None


def has_unit(given: Any) -> bool:
    """Whether an object or a class is a quantity, or an array with a unit."""
    return is_quantity(given) or _unit_text(given) is not None


def is_quantity(given: Any) -> bool:
    """Whether an object or a class is a quantity of pint."""
    return hasattr(given, "dimensionality") and hasattr(given, "to")


def is_labelled(given: Any) -> bool:
    """Whether ``given`` is a ``DataArray`` or ``Variable`` of xarray."""
    return hasattr(given, "dims") and hasattr(given, "data")


def _unit_text(given: Any) -> str | None:
    """The unit of an array of xarray, or of a quantity of a package other than pint."""
    if is_labelled(given):
        attributes = getattr(given, "attrs", None)
        return attributes.get("units") if isinstance(attributes, dict) else None
    where = ("unit", "dimensionality", "units")  # of astropy, quantities and unyt
    return next((str(getattr(given, name)) for name in where if hasattr(given, name)), None)


def _of_pint(unit: Unit, given: Any) -> Any:
    """Convert a quantity of another package to pint."""
    if getattr(given, "uncertainty", None) is not None or np.any(getattr(given, "mask", False)):
        raise ValueError(f"{unit.key} has uncertainties or masked values; allowed: {PLAIN}")
    text = _unit_text(given)
    known = registry()
    try:
        return known.Quantity(np.asarray(given), known.Unit(text or "dimensionless"))
    except Exception:  # pint raises many types
        allowed = CONDITIONS[unit.condition]["dimension"][1]
        message = f"{unit.key} has the unknown unit {format_value(text)}"
        raise ValueError(f"{message}; allowed: {allowed}") from None


@cache
def registry() -> Any:
    """The unit registry of pint, which also reads powers as in UDUNITS: ``m2 s-1``."""
    require("data", "pint")
    import pint

    power = re.compile(r"(?<=[A-Za-z])(?<![0-9][eE])(?=-?\d)")
    known = pint.UnitRegistry(preprocessors=[lambda text: power.sub("**", text)])
    for alias in ("degree_Celsius = deg_C", "ohm = Ohm"):  # as astropy writes them
        known.define(f"@alias {alias}")
    return known


def decimal(values: ArrayLike, scale: float = 1.0, digits: int = 12) -> NDArray:
    """``scale`` times ``values``, rounded to ``digits`` significant digits."""
    return np.vectorize(lambda value: float(f"{value * scale:.{digits}g}"), otypes=[float])(values)
