"""The five conditions under their names: ``viscosity`` is in SI, ``viscosity_cSt`` in centistokes.

The unit is in the name, for arguments and for results alike.  ``load`` is F_t*, ``load_N`` a normal
load, which the inputs of the model relate: F_t* = F_t/(A_n E_ss).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.conditions.checks import check_parameters, check_points, checked_axis
from thirdbody.conditions.labelled import is_labelled
from thirdbody.conditions.units import is_quantity
from thirdbody.data.conditions import AXES, Axis
from thirdbody.data.quantities import NORMAL_LOAD
from thirdbody.messages import shown
from thirdbody.model.parameters import Parameters

LOAD_IN_NEWTONS = "load_N"
ENGINEERING = {name: axis.key if name != "load" else LOAD_IN_NEWTONS for name, axis in AXES.items()}
# Where crossings are searched for unless it is said: the paper's ranges (Table 2) and about a decade
# beyond, in engineering units
SEARCHED = {
    "load": (0.01, 1000.0),
    "viscosity": (1.0, 1000.0),
    "particle_diameter": (10.0, 10_000.0),
    "roughness": (20.0, 2000.0),
    "particle_density": (1e8, 1e14),
}


@dataclass(frozen=True)
class Unit:
    """A name that conditions are given by: its axis, and its unit.

    Attributes
    ----------
    key : str
        The name, such as ``viscosity_cSt``.
    axis : Axis
        What it is.
    text : str
        The unit, spelt as UDUNITS reads it.
    scale : float
        The unit in SI; of a normal load, F_t*/F_t [N-1].
    """

    key: str
    axis: Axis
    text: str
    scale: float

    @classmethod
    def of(cls, key: str, parameters: Parameters) -> Unit:
        """The unit that a name stands for.

        Parameters
        ----------
        key : str
            A name of the five axes, in SI or in engineering units.
        parameters : Parameters
            Inputs of the model.

        Raises
        ------
        ValueError
            If there is no such name.

        Examples
        --------
        >>> import thirdbody
        >>> Unit.of("roughness_nm", thirdbody.load_parameters()).to_si(300)
        array(3.e-07)
        """
        check_parameters(parameters)
        known = dict.fromkeys((*AXES, *ENGINEERING.values()))
        if not isinstance(key, str) or key not in known:
            raise ValueError(f"there is no axis {shown(key)}; allowed: {', '.join(known)}")
        if key == LOAD_IN_NEWTONS:
            return cls(key, AXES["load"], NORMAL_LOAD.units, 1.0 / parameters.newtons_per_load)
        axis = next(axis for axis in AXES.values() if key in (axis.name, axis.key))
        if key == axis.name:
            return cls(key, axis, axis.units, 1.0)
        return cls(key, axis, axis.unit, axis.scale)

    def to_si(self, values: ArrayLike) -> NDArray:
        """``values`` in SI, equal decimals as equal floats (see ``Axis.to_si``)."""
        if self.scale == self.axis.scale != 1.0:
            return np.vectorize(self.axis.to_si, otypes=[float])(values)
        return np.multiply(values, self.scale)

    def from_si(self, values: ArrayLike) -> NDArray:
        """Values in SI in this unit."""
        return np.divide(values, self.scale)

    def searched(self, parameters: Parameters) -> tuple[float, float]:
        """Where crossings are searched for unless it is said, in this unit."""
        engineering = Unit.of(ENGINEERING[self.axis.name], parameters)
        low, high = self.from_si(engineering.to_si(SEARCHED[self.axis.name])).tolist()
        return low, high


def unit_text(name: str) -> str:
    """The engineering unit of an axis, spelt as UDUNITS reads it.

    Examples
    --------
    >>> unit_text("viscosity"), unit_text("load")
    ('cSt', 'N')
    """
    return NORMAL_LOAD.units if name == "load" else AXES[name].unit


def in_si(
    given: Mapping[str, ArrayLike], parameters: Parameters, but: str | None = None
) -> dict[str, NDArray]:
    """Conditions by the names of the five axes, SI.

    Parameters
    ----------
    given : mapping
        A value of each axis, by its name in SI or in engineering units; quantities of pint bring
        their own unit.
    parameters : Parameters
        Inputs of the model.
    but : str, optional
        Name of an axis that is not given.

    Returns
    -------
    dict
        Values by ``AXES``, in that order.

    Raises
    ------
    ValueError
        If an axis is missing, given twice, unknown, or the one that is not to be given, and for
        numbers and shapes that ``solve`` refuses.

    Examples
    --------
    >>> import thirdbody
    >>> inputs = thirdbody.load_parameters()
    >>> given = {"load": 1e-5, "roughness_nm": 300, "particle_diameter": 5e-7}
    >>> given |= {"particle_density": 1e11}
    >>> {name: float(value) for name, value in in_si(given, inputs, but="viscosity").items()}
    {'load': 1e-05, 'particle_diameter': 5e-07, 'roughness': 3e-07, 'particle_density': 100000000000.0}
    """
    found = {}
    for key, values in given.items():
        unit = Unit.of(key, parameters)
        name = unit.axis.name
        if name in found or name == but:
            reason = "is searched along" if name == but else "is given twice"
            raise ValueError(f"{key}: {name} {reason}; allowed: each axis once")
        found[name] = _checked(unit, values, parameters)
    missing = [name for name in AXES if name not in found and name != but]
    if missing:
        name = missing[0]
        raise ValueError(f"{name} is missing; allowed: {name} or {ENGINEERING[name]}")
    check_points(found)
    return {name: found[name] for name in AXES if name in found}


def _checked(unit, values, parameters) -> NDArray:
    """Values in SI: numbers in ``unit``, or a quantity in a unit of its own."""
    name, key = unit.axis.name, unit.key
    if is_labelled(values):
        raise ValueError(f"{key} has named dimensions; allowed: .values of it")
    if key == name or is_quantity(values):
        return checked_axis(name, values, parameters)
    if isinstance(values, (list, tuple)) and any(map(is_quantity, values)):
        raise ValueError(f"{key} is a list of quantities; allowed: numbers, or one quantity")
    try:
        return unit.to_si(checked_axis(name, values, parameters))
    except ValueError as error:
        raise ValueError(f"{key}{str(error).removeprefix(name)}") from None
