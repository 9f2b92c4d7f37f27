"""Measurable quantities of a solution: its variables, and two estimates that are not in the paper.

The estimates give the direction and the order of magnitude of a change.  ``friction`` shares the load
between solids and film, each with a constant coefficient (Johnson, Greenwood & Poon 1972, Wear 19:91).
``contact_resistance`` is that of one round spot (Holm 1967, "Electric Contacts").
"""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from thirdbody.conditions import checked_numbers
from thirdbody.points import Solution


class Measurable(NamedTuple):
    """A measurable quantity: its name in headings, the unit of its column, and its usual range."""

    heading: str
    unit: str
    usual: tuple[float, float]


MEASURED = {  # by column
    "friction_coefficient": Measurable("friction coefficient", "1", (1e-4, 1.5)),
    "contact_resistance_ohm": Measurable("contact resistance", "ohm", (1e-6, 1e9)),
    "film_thickness_nm": Measurable("film thickness", "nm", (0.1, 1e6)),
    "separation_nm": Measurable("separation", "nm", (0.1, 1e6)),
    "real_contact_area_mm2": Measurable("real contact area", "mm2", (1e-9, 1e3)),
    "real_contact_area_fraction": Measurable("real contact area fraction", "1", (1e-9, 1.0)),
    "solid_load_fraction": Measurable("solid load fraction", "1", (1e-6, 1.0)),
    "fluid_load_fraction": Measurable("fluid load fraction", "1", (1e-6, 1.0)),
}
# for steel in oil
COEFFICIENTS = {"boundary_friction": 0.12, "film_friction": 0.03, "resistivity_ohm_m": 2.2e-7}
USUAL_COEFFICIENTS = {
    "boundary_friction": (0.01, 1.0, "1"),
    "film_friction": (1e-4, 0.2, "1"),
    "resistivity_ohm_m": (1e-8, 1e-4, "ohm m"),
}
FORMULAS = {
    "friction_coefficient": "{boundary_friction:.3g} L_s + {film_friction:.3g} L_f",
    "contact_resistance_ohm": "one round spot of A_t* A_n, bodies of {resistivity_ohm_m:.3g} ohm m",
}
MOST_UNCERTAIN = (
    0.5  # standard error over the value, above which the data do not tell a coefficient
)


def friction(
    solution: Solution, boundary_friction: float = 0.12, film_friction: float = 0.03
) -> NDArray:
    """Friction coefficient mu_b L_s + mu_f L_f [1]: an estimate that is not in the paper.

    The load on the solids has one constant coefficient, the load on the film another one (load sharing:
    Johnson, Greenwood & Poon 1972, Wear 19:91).  Ploughing, heating and shear thinning are neglected.

    Parameters
    ----------
    solution : Solution
        Points of ``thirdbody.solve``.
    boundary_friction : float or quantity
        mu_b of the solids [1]: 0.08 to 0.15 for steel in oil.
    film_friction : float or quantity
        mu_f of the film [1]: 0.01 to 0.07, which depends on the oil and on sliding.

    Returns
    -------
    array
        Of the shape of the points; nan without a solution.

    Raises
    ------
    ValueError
        For a coefficient that is not positive.

    Examples
    --------
    >>> import thirdbody as tb
    >>> layer = dict(particle_diameter_nm=500, particle_density_per_m2=1e11, roughness_nm=300)
    >>> points = tb.solve(load_N=[1, 10, 50], viscosity_cSt=90, **layer)
    >>> tb.lab.friction(points, boundary_friction=0.11).round(3)
    array([0.11 , 0.091, 0.053])
    """
    numbers = _checked(boundary_friction=boundary_friction, film_friction=film_friction)
    solids = numbers["boundary_friction"] * solution.solid_load_fraction
    return solids + numbers["film_friction"] * solution.fluid_load_fraction


@np.errstate(divide="ignore")  # without contact the resistance is infinite
def contact_resistance(solution: Solution, resistivity_ohm_m: float = 2.2e-7) -> NDArray:
    """Electrical contact resistance rho/(2 a) [ohm], pi a^2 = A_t* A_n: an estimate that is not in the paper.

    It is the constriction of one round spot (Holm 1967, "Electric Contacts").  Of n equal distant spots it
    is 1/sqrt(n) of that.  Oxides, films on the surfaces and leads add to it.  Particles conduct.

    Parameters
    ----------
    solution : Solution
        Points of ``thirdbody.solve``.
    resistivity_ohm_m : float or quantity
        Mean resistivity rho of both bodies [ohm m].

    Returns
    -------
    array
        Of the shape of the points; infinite without contact, nan without a solution.

    Raises
    ------
    ValueError
        For a resistivity that is not positive.

    Examples
    --------
    >>> import thirdbody as tb
    >>> layer = dict(particle_diameter_nm=500, particle_density_per_m2=1e11, roughness_nm=300)
    >>> points = tb.solve(load_N=[1, 50], viscosity_cSt=90, **layer)
    >>> (1e3 * tb.lab.contact_resistance(points)).round(1)  # [mohm]
    array([13.8,  2.6])
    """
    resistivity = _checked(resistivity_ohm_m=resistivity_ohm_m)["resistivity_ohm_m"]
    area = solution.total_contact_area * solution.parameters.apparent_area
    return resistivity / (2.0 * np.sqrt(area / np.pi))


def _checked(**coefficients):
    return checked_numbers(coefficients, USUAL_COEFFICIENTS)


def measurable(solution: Solution, coefficients: Mapping[str, float]) -> dict[str, NDArray]:
    """All measurable quantities of a solution, by the columns of ``MEASURED`` and in their units."""
    parameters = solution.parameters
    boundary, film, resistivity = (coefficients[name] for name in COEFFICIENTS)
    return {
        "friction_coefficient": friction(solution, boundary, film),
        "contact_resistance_ohm": contact_resistance(solution, resistivity),
        "film_thickness_nm": 1e9 * solution.film_thickness * parameters.ball_radius,
        "separation_nm": 1e9 * solution.separation,
        "real_contact_area_mm2": 1e6 * solution.total_contact_area * parameters.apparent_area,
        "real_contact_area_fraction": solution.total_contact_area,
        "solid_load_fraction": solution.solid_load_fraction,
        "fluid_load_fraction": solution.fluid_load_fraction,
    }


def fitted_coefficients(
    measured: pd.DataFrame,
    solution: Solution,
    known: Mapping[str, float | None],
) -> tuple[dict[str, float], list[str]]:
    """The coefficients of the estimates, and notes on those of the ``measured`` columns.

    Those that are not ``known`` are fitted by linear least squares, of the resistance with relative
    residuals; where the measurements do not tell them, they are the ``COEFFICIENTS`` for steel in oil.
    """
    spot = contact_resistance(solution) / COEFFICIENTS["resistivity_ohm_m"]
    terms = {
        "friction_coefficient": {
            "boundary_friction": solution.solid_load_fraction,
            "film_friction": solution.fluid_load_fraction,
        },
        "contact_resistance_ohm": {"resistivity_ohm_m": spot},
    }
    weights = {"friction_coefficient": 1.0, "contact_resistance_ohm": 1.0 / spot}
    coefficients = _checked(**{name: n for name, n in known.items() if n is not None})
    columns = [column for column in terms if column in measured]
    notes = []
    for column in columns:
        weighted = pd.DataFrame(terms[column]).mul(weights[column], axis=0)
        weighted["measured"] = measured[column].to_numpy() * weights[column]
        weighted = weighted.replace([np.inf, -np.inf], np.nan).dropna()
        notes += _fit(weighted.drop(columns="measured"), weighted["measured"], coefficients)
    coefficients = COEFFICIENTS | coefficients
    for column in columns:
        notes.append(f"{column} is an estimate: {FORMULAS[column].format(**coefficients)}")
    return coefficients, notes


def _fit(terms, measured, coefficients):
    """Add the coefficients of the ``terms`` that are not in ``coefficients``; returns notes on them."""
    notes: list[str] = []
    while unknown := [name for name in terms if name not in coefficients]:
        known = [name for name in terms if name in coefficients]
        rest = measured - terms[known] @ np.array([coefficients[name] for name in known])
        values, errors = _least_squares(terms[unknown].to_numpy(), rest.to_numpy())
        if ((values > 0.0) & (errors <= MOST_UNCERTAIN * values)).all():
            coefficients |= dict(zip(unknown, values.tolist()))
            return notes + [
                f"{name} is {value:.3g} with a standard error of {error:.2g}, fitted to the measurements"
                for name, value, error in zip(unknown, values, errors)
            ]
        # what contributes least is told least
        least = min(unknown, key=lambda name: COEFFICIENTS[name] * np.linalg.norm(terms[name]))
        coefficients[least] = COEFFICIENTS[least]
        notes.append(
            f"{least} is {COEFFICIENTS[least]:g}, of steel in oil: the measurements do not tell it"
        )
    return notes


def _least_squares(terms, measured):
    """Coefficients of the columns of ``terms``, and their standard errors; infinite if not determined."""
    values, _, rank, _ = np.linalg.lstsq(terms, measured)
    freedom = len(measured) - terms.shape[1]
    if freedom < 1 or rank < terms.shape[1]:
        return values, np.full(len(values), np.inf)
    variance = np.sum((measured - terms @ values) ** 2) / freedom
    return values, np.sqrt(variance * np.diag(np.linalg.inv(terms.T @ terms)))
