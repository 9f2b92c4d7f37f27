"""The points to solve, and the forces at each for a given separation (Eq. 1)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.core.contact import Contact, ErrorTerms, SolidState
from thirdbody.core.film import INVERSE_ERROR, Film, has_film, log_load_parameter
from thirdbody.core.logarithms import EPSILON, WithSlope, log_sum
from thirdbody.core.parameters import Parameters

SOLIDS = "particle_diameter", "roughness", "particle_density"  # conditions of the solids


class Forces(NamedTuple):
    """Forces of solids and film at separations d [m]: arrays of the shape of d.

    ``log_solid`` and ``log_fluid`` are ln(F_s/F_t) and ln(F_f/F_t) [1].  ``excess`` is
    ln((F_s + F_f)/F_t) [1], which is 0 where the forces balance; ln(F_s/F_t) in dry contact, and
    where F_t alone gives the film.  The noise in ``errors`` is that of the excess, ``solid_noise``
    [1] that of ``log_solid``. ``solids`` has the areas.
    """

    separation: NDArray
    excess: WithSlope
    log_solid: WithSlope
    log_fluid: NDArray
    errors: ErrorTerms
    solid_noise: NDArray
    solids: SolidState

    def take(self, chosen: NDArray) -> Forces:
        """The forces at the points with the indices ``chosen``, along the last axis."""
        return _taken(self, chosen)


def _taken(record, chosen):
    """A record, which may contain records, with the ``chosen`` elements of its arrays."""
    if isinstance(record, tuple):
        return type(record)(*(_taken(part, chosen) for part in record))
    return record.take(chosen, axis=-1)


@dataclass(frozen=True)
class Points:
    """Points to solve: all with or all without particles, and likewise a film.

    ``film`` is None for dry contact; ``log_total`` is ln F_t* [1], 1-D.
    """

    contact: Contact
    film: Film | None
    log_total: NDArray

    @classmethod
    def of(
        cls, conditions: Mapping[str, NDArray], parameters: Parameters, table_rtol: float | None
    ) -> Points:
        """The points at five ``conditions`` by name, 1-D and SI.  All have particles, and a film,
        if the first point has; ``table_rtol`` is as in ``Contact.of``."""
        solids = {name: conditions[name] for name in SOLIDS}
        contact = Contact.of(**solids, parameters=parameters, table_rtol=table_rtol)
        film, viscosity = None, conditions["viscosity"]
        if has_film(viscosity[0]):
            film = Film.of(viscosity, conditions["roughness"], parameters)
        return cls(contact=contact, film=film, log_total=np.log(conditions["load"]))

    @property
    def parameters(self) -> Parameters:
        """Inputs of the model."""
        return self.contact.parameters

    @property
    def shared_film(self) -> Film | None:
        """The film if it is part of the force balance: if W of Eq. 8 contains F_f, not F_t."""
        return self.film if self.parameters.film_shares_load else None

    def take(self, chosen) -> Points:
        """The points selected by an index or mask ``chosen``."""
        return replace(
            self,
            contact=self.contact.take(chosen),
            film=self.film and self.film.take(chosen),
            log_total=self.log_total[chosen],
        )

    def forces(self, separation: NDArray, with_areas: bool = False) -> Forces:
        """Eq. 1 at ``separation`` d [m]: F_s (Eqs. 2 and 4) and, where films share the load, F_f of
        a film of thickness d (Eqs. 7 and 8)."""
        solids, table_error = self.contact.at(separation, with_areas), self.contact.summits.error
        log_solid = solids.log_load._replace(value=solids.log_load.value - self.log_total)
        rounding_of_load = 2.0 * EPSILON * np.abs(self.log_total)
        errors = ErrorTerms(
            steepest=np.maximum(solids.errors.steepest, 1.0 / separation),
            rounding=solids.errors.rounding + table_error,
            noise=solids.errors.noise + table_error + rounding_of_load,
        )
        forces = Forces(
            separation=separation,
            excess=log_solid,
            log_solid=log_solid,
            log_fluid=np.full(separation.shape, -np.inf),
            errors=errors,
            solid_noise=errors.noise,
            solids=solids,
        )
        film = self.shared_film
        return forces if film is None else self._with_film(film, forces)

    def _with_film(self, film, forces):
        """The forces of solids, and those of a film that shares the load with them (Eq. 1)."""
        log_fluid, film_noise = self.log_film_load(film, forces.separation)
        excess, solid = log_sum(forces.log_solid, log_fluid)  # Eq. 1: F_t = F_s + F_f
        errors = ErrorTerms(
            steepest=np.maximum(forces.errors.steepest, np.abs(log_fluid.slope)),
            rounding=np.maximum(forces.errors.rounding, film_noise),
            noise=solid * forces.errors.noise + (1.0 - solid) * film_noise + 4.0 * EPSILON,
        )
        return forces._replace(excess=excess, log_fluid=log_fluid.value, errors=errors)

    def log_film_load(self, film: Film, separation: NDArray) -> tuple[WithSlope, NDArray]:
        """ln(F_f/F_t) [1] of a ``film`` as thick as ``separation`` d [m], and its noise [1]."""
        thickness = separation / self.parameters.ball_radius
        log_parameter, slope = film.log_W_and_slope(thickness)
        noise = film.rounding(log_parameter, 1.0 / slope) * np.abs(slope)
        log_fluid = log_parameter - log_load_parameter(self.log_total, self.parameters)
        return WithSlope(value=log_fluid, slope=slope / separation), noise + INVERSE_ERROR

    def film_separation(self) -> tuple[NDArray, NDArray]:
        """d = R_x H_c [m] of films that carry all of F_t (Eqs. 7 and 8), and its relative rounding;
        0 when dry."""
        if self.film is None:
            nothing = np.zeros(self.log_total.shape)
            return nothing, nothing
        log_parameter = log_load_parameter(self.log_total, self.parameters)
        thickness, slope = self.film.thickness(log_parameter)
        rounding = self.film.rounding(log_parameter, slope / thickness)
        return self.parameters.ball_radius * thickness, rounding
