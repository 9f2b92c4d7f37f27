"""Measurable quantities from a solution: its variables, and two estimates that are not in the paper.

The estimates are suitable for the direction and order of magnitude of a change.  Friction is the sum for
solids and film, each with a constant coefficient (load sharing: Johnson, Greenwood & Poon 1972, Wear
19:91).  The contact resistance is that of one round spot of area A_t* A_n = pi a^2 (Holm 1967, "Electric
Contacts"): n equal distant spots have 1/sqrt(n) of it, layers of oxide or oil add to it.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from thirdbody.conditions import checked_numbers
from thirdbody.core.parameters import Parameters
from thirdbody.points import Solution
from thirdbody.toml_tables import toml_beside

TABLES = toml_beside(__file__)
MEASURED, FORMULAS, USUAL_ASSUMED = TABLES["measured"], TABLES["formulas"], TABLES["usual"]


@dataclass(frozen=True)
class Assumed:
    """Assumptions of the estimates, by default for steel in oil.

    ``boundary_friction`` is the friction coefficient [1] of the solids, 0.08 to 0.15 for steel in oil;
    ``film_friction`` that of the film, 0.01 to 0.07, depending on oil and sliding; ``resistivity_ohm_m``
    the mean electrical resistivity [ohm m] of both bodies.  Numbers or quantities.
    """

    boundary_friction: float = 0.12
    film_friction: float = 0.03
    resistivity_ohm_m: float = 2.2e-7

    def __post_init__(self):
        for name, number in checked_numbers(vars(self), USUAL_ASSUMED).items():
            object.__setattr__(self, name, number)


@np.errstate(divide="ignore")  # without contact the resistance is infinite
def measurable(found: Solution, parameters: Parameters, assumed: Assumed) -> dict[str, NDArray]:
    """All measurable quantities of a solution, by the columns of ``MEASURED`` and in their units."""
    area = found.total_contact_area * parameters.apparent_area
    solids = assumed.boundary_friction * found.solid_load_fraction
    return {
        "friction_coefficient": solids + assumed.film_friction * found.fluid_load_fraction,
        "contact_resistance_ohm": assumed.resistivity_ohm_m / (2.0 * np.sqrt(area / np.pi)),
        "film_thickness_nm": 1e9 * found.film_thickness * parameters.ball_radius,
        "separation_nm": 1e9 * found.separation,
        "real_contact_area_mm2": 1e6 * area,
        "real_contact_area_fraction": found.total_contact_area,
        "solid_load_fraction": found.solid_load_fraction,
        "fluid_load_fraction": found.fluid_load_fraction,
    }
