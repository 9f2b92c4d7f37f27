"""Names for the state of an interface: lubrication regime and contact mode (sections 3.1, 3.2)."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

BOUNDARY_LIMIT = 0.90  # of L_s
FULL_FILM_LIMIT = 0.03  # of L_s
PARTICLE_LIMIT = 0.95  # of A_sa,t*
SURFACE_LIMIT = 0.05  # of A_sa,t*

LUBRICATION_REGIMES = ("boundary", "mixed", "full_film")
BOUNDARY, MIXED, FULL_FILM = range(3)
CONTACT_MODES = ("two_body", "surface_surface", "hybrid", "particle_surface")
TWO_BODY, SURFACE_SURFACE, HYBRID, PARTICLE_SURFACE = range(4)
# in the order of their codes in data files; ``MILDEST_FIRST`` has them by gravity
SOLUTION_STATUSES = (
    "converged",
    "outside_film_formula",
    "coverage_exceeded",
    "not_converged",
    "area_exceeded",
    "load_exceeded",
)
FLAG_MEANINGS = {  # what the values 0, 1, ... of each flag stand for
    "lubrication_regime": LUBRICATION_REGIMES,
    "contact_mode": CONTACT_MODES,
    "solution_status": SOLUTION_STATUSES,
}
WITHOUT_VALUES = ("coverage_exceeded", "load_exceeded")  # nan, and NO_FLAG for regime and mode
NO_FLAG = np.int8(-1)
# Where several apply, the last of these is the status.
MILDEST_FIRST = (
    "outside_film_formula",
    "area_exceeded",
    "not_converged",
    "coverage_exceeded",
    "load_exceeded",
)
FILM_COUNTS = 1e-3  # of L_f: a film that carries less does not affect the other quantities


def lubrication_regime(solid_load_fraction: ArrayLike) -> NDArray[np.int8]:
    """Index into ``LUBRICATION_REGIMES`` for a fraction L_s [1] of the load, of the same shape.

    Boundary above 0.90, full film below 0.03, else mixed (section 3.1 of the paper).

    Examples
    --------
    >>> [LUBRICATION_REGIMES[index] for index in lubrication_regime([0.95, 0.5, 0.01])]
    ['boundary', 'mixed', 'full_film']
    """
    fraction = np.asarray(solid_load_fraction)
    thick, thin = fraction < FULL_FILM_LIMIT, fraction > BOUNDARY_LIMIT
    return np.where(thick, FULL_FILM, np.where(thin, BOUNDARY, MIXED)).astype(np.int8)


def contact_mode(
    particle_contact_area_ratio: ArrayLike, has_particles: ArrayLike
) -> NDArray[np.int8]:
    """Index into ``CONTACT_MODES`` for a ratio A_sa,t* [1] and whether there are particles; both
    broadcast.

    Particle-surface above 0.95, surface-surface below 0.05, else hybrid (section 3.2 of the paper);
    an interface without particles is two-body.

    Examples
    --------
    >>> modes = contact_mode([0.0, 0.01, 0.2, 0.99], [False, True, True, True])
    >>> [CONTACT_MODES[index] for index in modes]
    ['two_body', 'surface_surface', 'hybrid', 'particle_surface']
    """
    ratio = np.asarray(particle_contact_area_ratio)
    alone, beside = ratio > PARTICLE_LIMIT, ratio < SURFACE_LIMIT
    mode = np.where(alone, PARTICLE_SURFACE, np.where(beside, SURFACE_SURFACE, HYBRID))
    return np.where(has_particles, mode, TWO_BODY).astype(np.int8)


def codes_to_name(variables: Mapping[str, Any]) -> dict[str, NDArray[np.int8]]:
    """The codes of the flags among ``variables`` as people read their names: ``NO_FLAG`` for the contact
    mode in a full film, where hardly anything touches.

    Examples
    --------
    >>> found = codes_to_name({"lubrication_regime": [1, 2], "contact_mode": [2, 2]})
    >>> found["contact_mode"].tolist()
    [2, -1]
    """
    codes = {name: np.asarray(variables[name]) for name in FLAG_MEANINGS if name in variables}
    if {"lubrication_regime", "contact_mode"} <= codes.keys():
        is_full = codes["lubrication_regime"] == FULL_FILM
        codes["contact_mode"] = np.where(is_full, NO_FLAG, codes["contact_mode"])
    return codes


def has_values(solution_status: ArrayLike) -> NDArray[np.bool_]:
    """Whether points have values, a separation, loads and areas, for indices into ``SOLUTION_STATUSES``."""
    return ~np.isin(solution_status, [SOLUTION_STATUSES.index(name) for name in WITHOUT_VALUES])


def gravest_status(**applies: NDArray) -> NDArray[np.int8]:
    """Index into ``SOLUTION_STATUSES`` of the most severe status at each point; ``applies`` are
    bool arrays of one shape, by status.
    """
    status = np.zeros(next(iter(applies.values())).shape, np.int8)
    for name in MILDEST_FIRST:
        if name in applies:
            status[applies[name]] = SOLUTION_STATUSES.index(name)
    return status
