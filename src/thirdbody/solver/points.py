"""The points to solve, and the forces at each for a given separation (Eq. 1)."""

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
    """The solids of points that are either all with or all without particles.

    Parameters
    ----------
    particle_diameter, roughness, particle_density : array
        x_a [m], sigma [m] and eta_a [m-2], 1-D and of one length.
    parameters : Parameters
        Inputs of the model.
    table_rtol : float, optional
        Relative error of the summit tables; by default the summits are integrated.
    """
    particles = None
    if has_particles(particle_diameter[0], particle_density[0]):
        particles = ParticleLayer.of(particle_diameter, roughness, particle_density, parameters)
    surfaces = RoughSurfaces.of(roughness, parameters, table_rtol)
    return Contact(surfaces, particles, parameters)


class Forces(NamedTuple):
    """Forces of solids and film at separations d: arrays of the shape of d.

    ``excess`` is ln((F_s + F_f)/F_t) [1], ``slope`` its derivative d/dd [m-1], and ``noise`` its
    error from rounding and tables.  ``steepest`` bounds |d ln v/dd| [m-1] of d and of each
    contribution v to loads and areas; ``rounding`` is their relative error from rounding and
    tables.  ``log_solid`` and ``log_fluid`` are ln(F_s/F_t) and ln(F_f/F_t) [1]; ``solid_noise`` is
    the noise of the first.  The others are as in ``SolidLoad``.
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
    """Points to solve: all with or all without particles, and all with or all without a film.

    ``film`` is None for dry contact; ``log_load`` is ln F_t* [1], 1-D.
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
        """Whether the film is part of the force balance: whether W of Eq. 8 contains F_f, not F_t."""
        return self.film is not None and self.parameters.interpretation.film_load.depends_on_shares

    def take(self, chosen) -> Points:
        """The points selected by an index or mask ``chosen``."""
        film = self.film and self.film.take(chosen)
        return Points(self.contact.take(chosen), film, self.log_load[chosen])

    def forces(self, separation: NDArray, with_areas: bool = False) -> Forces:
        """Eq. 1 at ``separation`` d [m]: F_s (Eqs. 2 and 4) and, where films share the load, F_f of a
        film of thickness d (Eqs. 7 and 8)."""
        solids = self.contact.log_solid_load(separation, with_areas)
        excess = log_solid = solids.value - self.log_load
        noise = solids.noise + self.contact.summits.error + 2.0 * EPSILON * np.abs(self.log_load)
        slope, solid_noise, log_fluid = solids.slope, noise, np.full(excess.shape, -np.inf)
        steepest = np.maximum(solids.steepest, 1.0 / separation)
        rounding = solids.rounding + self.contact.summits.error
        if self.shares_load:
            log_fluid, film_slope, film_noise = self.log_film_load(separation)
            excess, fraction = log_sum(log_solid, log_fluid)
            slope = fraction * slope + (1.0 - fraction) * film_slope
            noise = fraction * noise + (1.0 - fraction) * film_noise + 4.0 * EPSILON
            steepest = np.maximum(steepest, np.abs(film_slope))
            rounding = np.maximum(rounding, film_noise)
        solid = log_solid, log_fluid, solid_noise, solids.slope
        areas = solids.area, solids.area_slope, solids.coverage, solids.log_beside
        return Forces(separation, excess, slope, noise, steepest, rounding, *solid, *areas)

    def log_film_load(self, separation: NDArray) -> tuple[NDArray, NDArray, NDArray]:
        """ln(F_f/F_t) of films as thick as ``separation`` d [m], its slope d/dd [m-1], and its noise."""
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
