"""The points to be solved, and the forces on each at a given separation (Eq. 1)."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.model.contact import Contact, log_sum
from thirdbody.model.film import EPSILON, INVERSE_ERROR, Film, has_film, log_load_parameter
from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import ParticleLayer, has_particles
from thirdbody.solver.summits import RoughSurfaces


def make_contact(
    particle_diameter: NDArray,
    roughness: NDArray,
    particle_density: NDArray,
    parameters: Parameters,
    table_rtol: float | None = None,
) -> Contact:
    """The solids of points that all have particles or all have none.

    Parameters
    ----------
    particle_diameter, roughness, particle_density : array
        x_a [m], sigma [m] and eta_a [m-2], 1-D and of one length.
    parameters : Parameters
        Inputs of the model.
    table_rtol : float, optional
        Relative error for which tables of the summits are good; by default they are integrated.
    """
    particles = None
    if has_particles(particle_diameter[0], particle_density[0]):
        particles = ParticleLayer.of(particle_diameter, roughness, particle_density, parameters)
    surfaces = RoughSurfaces.of(roughness, parameters, table_rtol)
    return Contact(surfaces, particles, parameters)


class Forces(NamedTuple):
    """What solids and film carry together at separations d: arrays of their shape.

    ``excess`` is ln((F_s + F_f)/F_t) [1], ``slope`` its derivative by d [m-1], and ``noise`` what rounding
    and tables may change in it.  ``steepest`` bounds |d ln v/dd| [m-1] of d and of each part v of loads
    and areas, and ``rounding`` is the relative error that rounding and tables leave in any of them.
    ``log_solid`` and ``log_fluid`` are ln(F_s/F_t) and ln(F_f/F_t) [1], and ``solid_noise`` is the
    noise of the first.  The others are those of ``SolidLoad``.
    """

    separation: NDArray
    excess: NDArray
    slope: NDArray
    noise: NDArray
    steepest: NDArray
    rounding: NDArray
    log_solid: NDArray
    log_fluid: NDArray
    solid_noise: NDArray
    solid_slope: NDArray
    area: NDArray
    area_slope: NDArray
    coverage: NDArray
    log_beside: NDArray | None


@dataclass(frozen=True)
class Points:
    """Points to be solved, all with or without particles and all with or without a film.

    ``film`` is None where the interface is dry; ``log_load`` is ln F_t* [1], 1-D.
    """

    contact: Contact
    film: Film | None
    log_load: NDArray

    @classmethod
    def of(
        cls, conditions: Iterable[NDArray], parameters: Parameters, table_rtol: float | None
    ) -> Points:
        """The points at five ``conditions``, in the order of the arguments of ``solve``, 1-D and SI;
        ``table_rtol`` is as in ``make_contact``."""
        load, viscosity, diameter, roughness, density = conditions
        contact = make_contact(diameter, roughness, density, parameters, table_rtol)
        film = Film.of(viscosity, roughness, parameters) if has_film(viscosity[0]) else None
        return cls(contact, film, np.log(load))

    @property
    def parameters(self) -> Parameters:
        """Inputs of the model."""
        return self.contact.parameters

    @property
    def shares_load(self) -> bool:
        """Whether the film takes part in the balance: whether W of Eq. 8 holds F_f, not F_t."""
        return self.film is not None and self.parameters.interpretation.film_load.depends_on_shares

    def take(self, chosen) -> Points:
        """The points that an index or mask ``chosen`` picks."""
        film = self.film and self.film.take(chosen)
        return Points(self.contact.take(chosen), film, self.log_load[chosen])

    def forces(self, separation: NDArray, with_areas: bool = False) -> Forces:
        """Eq. 1 at ``separation`` d [m]: F_s (Eqs. 2 and 4) and, where films share the load, F_f of a
        film of thickness d (Eqs. 7 and 8)."""
        solids = self.contact.log_solid_load(separation, with_areas)
        log_solid = solids.value - self.log_load
        noise = solids.noise + self.contact.summits.error + 2.0 * EPSILON * np.abs(self.log_load)
        steepest = np.maximum(solids.steepest, 1.0 / separation)
        rounding = solids.rounding + self.contact.summits.error
        others = noise, solids.slope, *solids[5:9]  # to log_beside
        if not self.shares_load:
            nothing = np.full(separation.shape, -np.inf)
            excess = log_solid, solids.slope, noise
            return Forces(separation, *excess, steepest, rounding, log_solid, nothing, *others)
        log_fluid, film_slope, film_noise = self.log_film_load(separation)
        value, fraction = log_sum(log_solid, log_fluid)
        return Forces(
            separation,
            value,
            fraction * solids.slope + (1.0 - fraction) * film_slope,
            fraction * noise + (1.0 - fraction) * film_noise + 4.0 * EPSILON,
            np.maximum(steepest, np.abs(film_slope)),
            np.maximum(rounding, film_noise),
            log_solid,
            log_fluid,
            *others,
        )

    def log_film_load(self, separation: NDArray) -> tuple[NDArray, NDArray, NDArray]:
        """ln(F_f/F_t) of films as thick as ``separation`` d [m], its slope by d [m-1], and its noise."""
        thickness = separation / self.parameters.ball_radius
        log_parameter, slope = self.film.load_parameter_and_slope(thickness)
        noise = self.film.rounding(log_parameter, 1.0 / slope) * np.abs(slope)
        log_load = log_parameter - log_load_parameter(self.log_load, self.parameters)
        return log_load, slope / separation, noise + INVERSE_ERROR

    def film_separation(self) -> tuple[NDArray, NDArray]:
        """d = R_x H_c [m] of films that carry all of F_t (Eqs. 7 and 8), and its relative rounding."""
        log_parameter = log_load_parameter(self.log_load, self.parameters)
        thickness, slope = self.film.thickness(log_parameter)
        rounding = self.film.rounding(log_parameter, slope / thickness)
        return self.parameters.ball_radius * thickness, rounding
