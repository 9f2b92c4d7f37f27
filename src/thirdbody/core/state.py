"""The variables of solved points: how they follow from the forces (Eqs. 3, 9 and 10), and the bound
of their errors.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from thirdbody.core.film import THICKEST, Film, log_load_parameter
from thirdbody.core.logarithms import TINY
from thirdbody.core.names import (
    CONTACT_MODE,
    ERROR_BOUND,
    FILM_THICKNESS,
    FLUID_LOAD_FRACTION,
    LUBRICATION_REGIME,
    PARTICLE_CONTACT_AREA_RATIO,
    SEPARATION,
    SOLID_LOAD_FRACTION,
    SOLUTION_STATUS,
    SURFACE_CONTACT_AREA_RATIO,
    TOTAL_CONTACT_AREA,
)
from thirdbody.core.parameters import Parameters
from thirdbody.core.regimes import (
    FILM_COUNTS,
    FLAG_MEANINGS,
    NO_FLAG,
    contact_mode,
    gravest_status,
    lubrication_regime,
)
from thirdbody.core.root import EnclosedRoots

FLAGS = tuple(FLAG_MEANINGS)


def type_of(variable: str) -> type[np.int8 | float]:
    """Data type of a ``variable``."""
    return np.int8 if variable in FLAGS else float


def describe(roots: EnclosedRoots, rtol: float) -> dict[str, NDArray]:
    """All variables by name, as 1-D arrays over ``roots.points``, for a requested ``rtol``."""
    points, ends = roots.points, roots.forces
    solid, fluid = fractions(ends.log_solid.value - ends.log_fluid)  # Eq. 9, F_t = F_s + F_f
    both = quantities(
        separation=ends.separation,
        solid_load_fraction=solid,
        fluid_load_fraction=fluid,
        particle_area=ends.solids.particle_area.value,
        log_summit_area=ends.solids.log_summit_area.value,
        parameters=points.parameters,
    )
    variables = {name: 0.5 * values.sum(axis=0) for name, values in both.items()}
    error = _error_bound(ends, both)
    error = np.where(roots.certain & (error <= 1.0), error, np.inf)
    variables[ERROR_BOUND] = error
    particles = points.contact.particles
    covered = np.asarray(particles is not None and particles.covers_all)
    unsolved = np.isnan(variables[SEPARATION])
    statuses = {
        "not_converged": ~(error <= rtol),
        "coverage_exceeded": covered,
        "load_exceeded": unsolved,
    }
    with_particles = particles is not None
    add_flags(
        variables, points.film, points.log_total, points.parameters, with_particles, **statuses
    )
    _remove_values(variables, unsolved | covered)
    return variables


def quantities(
    *,
    separation: NDArray,
    solid_load_fraction: NDArray,
    fluid_load_fraction: NDArray,
    particle_area: NDArray,
    log_summit_area: NDArray,
    parameters: Parameters,
) -> dict[str, NDArray]:
    """The variables that are numbers, by name (Eqs. 3, 5 and 10), in arrays of one shape.

    Parameters
    ----------
    separation : array
        d [m].
    solid_load_fraction, fluid_load_fraction : array
        L_s and L_f [1] (Eq. 9).
    particle_area : array
        A_sa/A_n [1].
    log_summit_area : array
        ln(A_ss-sa/A_n) [1], of the summits beside the particles.
    parameters : Parameters
        Inputs of the model.
    """
    particles, summits = fractions(np.log(particle_area) - log_summit_area)
    return {
        TOTAL_CONTACT_AREA: particle_area + np.exp(log_summit_area),  # Eqs. 3 and 5
        PARTICLE_CONTACT_AREA_RATIO: particles,  # Eq. 10
        SURFACE_CONTACT_AREA_RATIO: summits,
        SOLID_LOAD_FRACTION: solid_load_fraction,
        FLUID_LOAD_FRACTION: fluid_load_fraction,
        SEPARATION: separation,
        # Eq. 7 gives d = R_x H_c; the paper has it so also when dry
        FILM_THICKNESS: separation / parameters.ball_radius,
    }


def fractions(log_odds: NDArray) -> tuple[NDArray, NDArray]:
    """The fractions [1] of two parts in their sum, for ln of the first over the second."""
    return 1.0 / (1.0 + np.exp(-log_odds)), 1.0 / (1.0 + np.exp(log_odds))


def _remove_values(variables, without_values):
    """Replace the variables of points ``without_values``, except the status, by nan or
    ``NO_FLAG``."""
    if not without_values.any():
        return
    for name, values in variables.items():
        if name != SOLUTION_STATUS:
            values[without_values] = np.nan if type_of(name) is float else NO_FLAG


def add_flags(
    variables: dict[str, NDArray],
    film: Film | None,
    log_load: NDArray,
    parameters: Parameters,
    with_particles: bool,
    **statuses: NDArray,
) -> None:
    """Add regime, mode and status to ``variables`` under loads ln F_t* [1].

    ``statuses`` are the statuses, by name, that do not follow from the variables.
    """
    variables[LUBRICATION_REGIME] = lubrication_regime(variables[SOLID_LOAD_FRACTION])
    variables[CONTACT_MODE] = contact_mode(variables[PARTICLE_CONTACT_AREA_RATIO], with_particles)
    statuses["area_exceeded"] = variables[TOTAL_CONTACT_AREA] > 1.0
    if film is not None:
        fluid = variables[FLUID_LOAD_FRACTION]
        log_fluid = np.log(fluid) if parameters.film_shares_load else 0.0
        meaningful = film.is_meaningful(log_load_parameter(log_load + log_fluid, parameters))
        meaningful &= variables[FILM_THICKNESS] <= THICKEST
        statuses["outside_film_formula"] = ~meaningful & (fluid > FILM_COUNTS)
    variables[SOLUTION_STATUS] = gravest_status(**statuses)


def _error_bound(ends, both):
    """Largest relative deviation of loads and areas from the mean of both ends, plus rounding;
    ``both`` are the quantities at the ends by name."""
    width = np.diff(ends.separation, axis=0)[0]
    areas = _area_difference(ends.solids, both, width)
    loads, shared = _load_difference(ends, both, width)
    apart = np.maximum(width / ends.separation[0], np.maximum(areas, loads))
    rounding = np.maximum(*ends.errors.rounding)
    rounding += np.where(shared, np.maximum(*ends.solid_noise), 0.0)
    return 0.5 * np.expm1(apart) + rounding


def _area_difference(solids, both, width):
    """Largest relative difference of the areas of summits and particles between both ends."""
    area, log_summits = solids.particle_area, solids.log_summit_area.value
    log_bare = np.log1p(-solids.coverage)
    summits = _difference(log_summits - log_bare) + _difference(log_bare)
    # an area that is negligible alone may matter in a ratio
    smaller = np.minimum(both[PARTICLE_CONTACT_AREA_RATIO], both[SURFACE_CONTACT_AREA_RATIO])
    # the steeper slope of both ends leaves a margin
    rise = width * np.abs(area.slope).max(axis=0) / area.value.min(axis=0)
    particles = np.maximum(_difference(np.log(area.value)), rise)
    summits = _where_resolved(summits, np.maximum(np.exp(log_summits), smaller))
    return summits + _where_resolved(particles, np.maximum(area.value, smaller))


def _load_difference(ends, both, width):
    """Largest relative difference of the loads of solids and film between both ends, and where both
    carry load."""
    solid, fluid = both[SOLID_LOAD_FRACTION], both[FLUID_LOAD_FRACTION]
    shared = np.minimum(solid, fluid).max(axis=0) > TINY
    rise = width * np.abs(ends.log_solid.slope).max(axis=0)
    solids = np.maximum(_difference(ends.log_solid.value), rise)
    loads = _where_resolved(solids, solid) + _where_resolved(_difference(ends.log_fluid), fluid)
    return np.where(shared, loads, 0.0), shared


def _difference(both):
    return np.abs(both[0] - both[1])


def _where_resolved(difference, fraction):
    """The ``difference`` of logarithms where float64 holds all digits of ``fraction``; else 0."""
    return np.where(fraction.max(axis=0) > TINY, difference, 0.0)
