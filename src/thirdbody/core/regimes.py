"""Lubrication regime and contact mode of an interface (sections 3.1, 3.2), and the status of a
solution.
"""

from collections.abc import Mapping
from enum import StrEnum, auto
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.core.names import (
    CONTACT_MODE,
    LUBRICATION_REGIME,
    PARTICLE_CONTACT_AREA_RATIO,
    SOLID_LOAD_FRACTION,
    SOLUTION_STATUS,
)

BOUNDARY_LIMIT = 0.90  # of L_s
FULL_FILM_LIMIT = 0.03  # of L_s
PARTICLE_LIMIT = 0.95  # of A_sa,t*
SURFACE_LIMIT = 0.05  # of A_sa,t*


class State(StrEnum):
    """A state: its name, with the ``code`` that it has in data files.

    Comparison with a code, or with a text that is no name, raises ``ValueError``.

    Examples
    --------
    >>> ContactMode.hybrid == "hybrid", ContactMode.hybrid in {"hybrid"}, int(ContactMode.hybrid)
    (True, True, 2)
    """

    code: int

    def __new__(cls, name: str) -> "State":
        state = str.__new__(cls, name)
        state._value_ = name
        state.code = -1 if name == "without_values" else len(cls.__members__)
        return state

    def __eq__(self, other: object) -> bool:
        is_text_or_code = isinstance(other, (str, int, np.integer))
        if is_text_or_code and other not in type(self)._value2member_map_:
            allowed = ", ".join(type(self))
            raise ValueError(f"{type(self).__name__} is {other!r}; allowed: {allowed}")
        return str.__eq__(self, other)

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __int__(self) -> int:
        return self.code

    __hash__ = str.__hash__
    __repr__ = str.__repr__


class LubricationRegime(State):
    """Regime of lubrication, by the fraction of the load that the solids carry."""

    boundary = auto()
    mixed = auto()
    full_film = auto()
    without_values = auto()


class ContactMode(State):
    """Mode of contact, by the fraction of the contact area that the particles have."""

    two_body = auto()
    surface_surface = auto()
    hybrid = auto()
    particle_surface = auto()
    without_values = auto()


class SolutionStatus(State):
    """Status of a solution: whether the equations hold.

    The order is that of the codes in data files.  ``MILDEST_FIRST`` sorts by gravity.
    """

    converged = auto()
    outside_film_formula = auto()
    coverage_exceeded = auto()
    not_converged = auto()
    area_exceeded = auto()
    load_exceeded = auto()


STATES = {
    LUBRICATION_REGIME: LubricationRegime,
    CONTACT_MODE: ContactMode,
    SOLUTION_STATUS: SolutionStatus,
}
# states by code; the code -1 takes the last state
_BY_CODE = {name: np.array([*states], object) for name, states in STATES.items()}
# the quantity and level of each limit, the flag that changes there, and its states below and above
LIMITS = (
    (SOLID_LOAD_FRACTION, BOUNDARY_LIMIT, LUBRICATION_REGIME, "mixed", "boundary"),
    (SOLID_LOAD_FRACTION, FULL_FILM_LIMIT, LUBRICATION_REGIME, "full_film", "mixed"),
    (PARTICLE_CONTACT_AREA_RATIO, PARTICLE_LIMIT, CONTACT_MODE, "hybrid", "particle_surface"),
    (PARTICLE_CONTACT_AREA_RATIO, SURFACE_LIMIT, CONTACT_MODE, "surface_surface", "hybrid"),
)
# names of the values 0, 1, ... of each flag
FLAG_MEANINGS = {
    name: tuple(state.value for state in states if state.code >= 0)
    for name, states in STATES.items()
}
LUBRICATION_REGIMES, CONTACT_MODES, SOLUTION_STATUSES = FLAG_MEANINGS.values()
# points with these statuses have nan, and NO_FLAG for regime and mode
WITHOUT_VALUES = ("coverage_exceeded", "load_exceeded")
NO_FLAG = np.int8(-1)  # ``without_values``
# if several statuses apply, the last of them is the status of the point
MILDEST_FIRST = (
    "outside_film_formula",
    "area_exceeded",
    "not_converged",
    "coverage_exceeded",
    "load_exceeded",
)
FILM_COUNTS = 1e-3  # of L_f: a film that carries less does not affect the other quantities


def lubrication_regime(solid_load_fraction: ArrayLike) -> NDArray[np.int8]:
    """Indices into ``LUBRICATION_REGIMES`` for fractions L_s [1] of the load.

    Boundary above 0.90, full film below 0.03, else mixed (section 3.1 of the paper).

    Examples
    --------
    >>> [LUBRICATION_REGIMES[index] for index in lubrication_regime([0.95, 0.5, 0.01])]
    ['boundary', 'mixed', 'full_film']
    """
    fraction = np.asarray(solid_load_fraction)
    regime = np.full(fraction.shape, LubricationRegime.mixed.code, np.int8)
    regime[fraction < FULL_FILM_LIMIT] = LubricationRegime.full_film.code
    regime[fraction > BOUNDARY_LIMIT] = LubricationRegime.boundary.code
    return regime


def contact_mode(
    particle_contact_area_ratio: ArrayLike, has_particles: ArrayLike
) -> NDArray[np.int8]:
    """Indices into ``CONTACT_MODES`` for ratios A_sa,t* [1], with or without particles.

    Particle-surface above 0.95, surface-surface below 0.05, else hybrid (section 3.2 of the paper).
    An interface without particles is two-body.  Both arguments broadcast.

    Examples
    --------
    >>> modes = contact_mode([0.0, 0.01, 0.2, 0.99], [False, True, True, True])
    >>> [CONTACT_MODES[index] for index in modes]
    ['two_body', 'surface_surface', 'hybrid', 'particle_surface']
    """
    ratio = np.asarray(particle_contact_area_ratio)
    alone, beside = ratio > PARTICLE_LIMIT, ratio < SURFACE_LIMIT
    mode = np.full(ratio.shape, ContactMode.hybrid.code, np.int8)
    mode[beside] = ContactMode.surface_surface.code
    mode[alone] = ContactMode.particle_surface.code
    return np.where(has_particles, mode, np.int8(ContactMode.two_body.code))


def codes_to_name(variables: Mapping[str, Any]) -> dict[str, NDArray[np.int8]]:
    """The codes of the flags among ``variables``, states or codes, for output by name.

    The contact mode in a full film becomes ``NO_FLAG``, because hardly anything touches.

    Examples
    --------
    >>> codes = codes_to_name({"lubrication_regime": [1, 2], "contact_mode": [2, 2]})
    >>> codes["contact_mode"].tolist()
    [2, -1]
    """
    codes = {
        name: np.asarray(variables[name], np.int8) for name in FLAG_MEANINGS if name in variables
    }
    if {LUBRICATION_REGIME, CONTACT_MODE} <= codes.keys():
        is_full = codes[LUBRICATION_REGIME] == LubricationRegime.full_film.code
        codes[CONTACT_MODE] = np.where(is_full, NO_FLAG, codes[CONTACT_MODE])
    return codes


def states_of(name: str, codes: ArrayLike) -> NDArray[np.object_]:
    """The states of the flag ``name`` with these ``codes``, of the same shape."""
    return np.asarray(_BY_CODE[name][np.asarray(codes)], object)


def has_values(solution_status: ArrayLike) -> NDArray[np.bool_]:
    """Whether points have a separation, loads and areas, for indices into ``SOLUTION_STATUSES``."""
    return ~np.isin(solution_status, [SOLUTION_STATUSES.index(name) for name in WITHOUT_VALUES])


def gravest_status(**applies: NDArray) -> NDArray[np.int8]:
    """Index into ``SOLUTION_STATUSES`` of the gravest status at each point.

    ``applies`` has a bool array for each status: the points to which the status applies.
    """
    status = np.zeros(next(iter(applies.values())).shape, np.int8)
    for name in MILDEST_FIRST:
        if name in applies:
            status[applies[name]] = SOLUTION_STATUSES.index(name)
    return status
