"""What laboratories measure, from a solution of the model: variables of it, and two plain estimates.

The model has neither friction nor electricity.  Both estimates are outside of the paper, and good for
the direction and the order of magnitude of a change:

- friction coefficient: ``boundary_friction`` L_s + ``film_friction`` L_f, the sum of what solids and film
  carry, each with a constant coefficient (load sharing of Johnson, Greenwood & Poon 1972, Wear 19:91);
- contact resistance: ``resistivity``/(2 a) of one round spot of the area A_t* A_n = pi a^2 (Holm 1967,
  "Electric Contacts").  Of n equal spots far apart it would be 1/sqrt(n) of that; layers of oxide or oil
  on the spots add to it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.conditions.checks import check_number
from thirdbody.conditions.usual import (
    BOUNDARY_FRICTION,
    FILM_FRICTION,
    RESISTIVITY_OHM_M,
    warn_outside,
)
from thirdbody.model.parameters import Parameters
from thirdbody.solver.solution import Solution

USUAL = {  # usual ends and unit of what is assumed
    "boundary_friction": ((0.01, 1.0), "1"),
    "film_friction": ((1e-4, 0.2), "1"),
    "resistivity_ohm_m": ((1e-8, 1e-4), "ohm m"),
}


@dataclass(frozen=True)
class Assumed:
    """What the estimates need besides the model.

    Attributes
    ----------
    boundary_friction : float
        Friction coefficient [1] of what the solids carry; 0.08 to 0.15 are usual of steel in oil.
    film_friction : float
        Friction coefficient [1] of what the film carries; 0.01 to 0.07, by oil and sliding.
    resistivity_ohm_m : float
        Mean electrical resistivity [ohm m] of both bodies, by default that of bearing steel.
    """

    boundary_friction: float = BOUNDARY_FRICTION
    film_friction: float = FILM_FRICTION
    resistivity_ohm_m: float = RESISTIVITY_OHM_M

    def __post_init__(self):
        for name, value in vars(self).items():
            check_number(name, value)
        warn_outside({name: (value, *USUAL[name]) for name, value in vars(self).items()})


def friction_coefficient(found: Solution, parameters: Parameters, assumed: Assumed) -> NDArray:
    """The friction coefficient [1], an estimate."""
    solids = assumed.boundary_friction * found.solid_load_fraction
    return solids + assumed.film_friction * found.fluid_load_fraction


def contact_resistance(found: Solution, parameters: Parameters, assumed: Assumed) -> NDArray:
    """The constriction resistance [ohm], an estimate.

    Examples
    --------
    Of one spot of 0.01 mm2 between bodies of steel:

    >>> from types import SimpleNamespace
    >>> found = SimpleNamespace(total_contact_area=0.01)
    >>> parameters = SimpleNamespace(apparent_area=1e-6)
    >>> round(float(contact_resistance(found, parameters, Assumed())), 5)
    0.00195
    """
    radius = np.sqrt(found.total_contact_area * parameters.apparent_area / np.pi)
    return assumed.resistivity_ohm_m / (2.0 * radius)


class Measured(NamedTuple):
    """A variable that can be measured."""

    column: str  # its name with its unit, as tables have it
    unit: str  # as pint reads it
    model: Callable[[Solution, Parameters, Assumed], NDArray]  # its values in that unit
    formula: str = ""  # of an estimate: what is assumed


def _film_thickness_nm(found, parameters, assumed):
    return 1e9 * found.film_thickness * parameters.ball_radius


def _contact_area_mm2(found, parameters, assumed):
    return 1e6 * found.total_contact_area * parameters.apparent_area


MEASURED = {  # by the words of their headings
    "friction coefficient": Measured(
        "friction_coefficient",
        "dimensionless",
        friction_coefficient,
        "{boundary_friction:g} L_s + {film_friction:g} L_f",
    ),
    "contact resistance": Measured(
        "contact_resistance_ohm",
        "ohm",
        contact_resistance,
        "one round spot of A_t* A_n between bodies of {resistivity_ohm_m:g} ohm m (Holm)",
    ),
    "film thickness": Measured("film_thickness_nm", "nm", _film_thickness_nm),
    "separation": Measured("separation_nm", "nm", lambda found, *_: 1e9 * found.separation),
    "real contact area": Measured("real_contact_area_mm2", "mm**2", _contact_area_mm2),
    "real contact area fraction": Measured(
        "real_contact_area_fraction", "dimensionless", lambda found, *_: found.total_contact_area
    ),
    "solid load fraction": Measured(
        "solid_load_fraction", "dimensionless", lambda found, *_: found.solid_load_fraction
    ),
    "fluid load fraction": Measured(
        "fluid_load_fraction", "dimensionless", lambda found, *_: found.fluid_load_fraction
    ),
}
