"""Quantities with a unit, as of pint, in the unit that ``solve`` takes.

Nothing is imported for it: a quantity brings its own registry of units along.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np


class Wanted(NamedTuple):
    """What a condition is: in words, its dimensions and unit as pint reads them."""

    words: str
    dimensions: str
    unit: str


FORCE = Wanted("a force, as in N", "[force]", "N")
WANTED = {
    "load": Wanted(f"a number without dimension or {FORCE.words}", "[]", "dimensionless"),
    "viscosity": Wanted("a kinematic viscosity, as in cSt", "[length] ** 2 / [time]", "m ** 2 / s"),
    "particle_diameter": Wanted("a length, as in nm", "[length]", "m"),
    "roughness": Wanted("a length, as in nm", "[length]", "m"),
    "particle_density": Wanted("a number per area, as in 1/mm**2", "[length] ** -2", "m ** -2"),
}


def without_unit(name: str, given: Any, newtons_per_load: float) -> Any:
    """What is ``given`` of a condition, as bare numbers.

    Parameters
    ----------
    name : str
        The condition, an argument of ``solve``.
    given : object
        A quantity, a list that has some among bare numbers, or anything else, which is returned.
    newtons_per_load : float
        F_t/F_t* [N], for a load that is given as a force.

    Returns
    -------
    object
        Numbers in the unit of the argument.

    Raises
    ------
    ValueError
        In one line that names the argument, the unit given and the dimension wanted.
    """
    if isinstance(given, (list, tuple)):
        kinds = set(map(type, given))
        if not any(map(is_quantity, kinds)) and not kinds & {list, tuple}:
            return given
        return [without_unit(name, each, newtons_per_load) for each in given]
    if not is_quantity(given):
        return given
    if name == "load" and given.check(FORCE.dimensions):
        return _decimal(given.to(FORCE.unit).magnitude) / newtons_per_load
    wanted = WANTED[name]
    if not given.check(wanted.dimensions):
        raise ValueError(f"{name} is in {given.units:~}; allowed: {wanted.words}")
    return _decimal(given.to(wanted.unit).magnitude)


def is_quantity(given) -> bool:
    """Whether an object, or those of a class, are quantities of pint."""
    return hasattr(given, "dimensionality") and hasattr(given, "to")


def _decimal(numbers):
    """``numbers`` to 15 digits: 300 nm are 3e-07 m, and not the product of two rounded numbers."""
    return np.vectorize(lambda number: float(f"{number:.15g}"), otypes=[float])(numbers)
