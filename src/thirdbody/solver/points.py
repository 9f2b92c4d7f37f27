"""The points to be solved: what is given of them, and the interface that it describes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.model.contact import Contact, SolidLoad
from thirdbody.model.film import EPSILON, INVERSE_ERROR, Film, has_film, log_load_parameter
from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import ParticleLayer, has_particles
from thirdbody.solver.summits import RoughSurfaces


@dataclass(frozen=True)
class Conditions:
    """The five conditions of each point, 1-D arrays of one length.

    Parameters
    ----------
    load : array
        F_t* [1], positive.
    viscosity : array
        Kinematic viscosity [m2/s]; 0 where the interface is dry.
    particle_diameter : array
        x_a [m]; 0 where there are no particles.
    roughness : array
        sigma [m], positive.
    particle_density : array
        eta_a [m-2]; 0 where there are no particles.
    """

    load: NDArray
    viscosity: NDArray
    particle_diameter: NDArray
    roughness: NDArray
    particle_density: NDArray

    @property
    def size(self) -> int:
        """Number of points."""
        return self.load.size

    @property
    def are_lubricated(self) -> NDArray:
        """Whether there is a film, at each point."""
        return has_film(self.viscosity)

    @property
    def have_particles(self) -> NDArray:
        """Whether there are particles, at each point."""
        return has_particles(self.particle_diameter, self.particle_density)

    @property
    def kinds(self) -> NDArray:
        """The kind of each point: 2 if there is a film, and 1 more if there are particles."""
        return 2 * self.are_lubricated + self.have_particles

    def take(self, chosen) -> Conditions:
        """Those of the points that a slice, an index or a mask ``chosen`` picks."""
        return Conditions(*(column[chosen] for column in vars(self).values()))

    def points(self, parameters: Parameters, table_rtol: float | None) -> Points:
        """The interface at points that all have particles or all have none, and all have a film
        or all have none; ``table_rtol`` is as in ``make_contact``."""
        given = self.particle_diameter, self.roughness, self.particle_density
        contact = make_contact(*given, parameters, table_rtol)
        film = None
        if self.are_lubricated[0]:
            film = Film.of(self.viscosity, self.roughness, parameters)
        return Points(contact, film, np.log(self.load))


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
        Relative error for which a table of the summits is good, of one roughness that all points
        share; by default they are integrated.
    """
    particles = None
    if has_particles(particle_diameter[0], particle_density[0]):
        particles = ParticleLayer.of(particle_diameter, roughness, particle_density, parameters)
    surfaces = RoughSurfaces.of(roughness, parameters, table_rtol)
    return Contact(surfaces, particles, parameters)


class Forces(NamedTuple):
    """What solids and film carry together at separations d, each of their shape.

    Attributes
    ----------
    excess : array
        ln((F_s + F_f)/F_t) [1].
    slope : array
        d excess/dd [m-1].
    noise : array
        What rounding and the tables may change in ``excess`` [1].
    steepest : array
        A bound on |d ln v/dd| [m-1] for d and each part v of loads and areas.
    rounding : array
        Relative error that rounding and the tables leave in any such part [1].
    log_solid, log_fluid : array
        ln(F_s/F_t) and ln(F_f/F_t) [1].
    solid_noise : array
        What rounding and the tables may change in ``log_solid`` [1].
    solids : SolidLoad
        That of the contact.
    """

    excess: NDArray
    slope: NDArray
    noise: NDArray
    steepest: NDArray
    rounding: NDArray
    log_solid: NDArray
    log_fluid: NDArray
    solid_noise: NDArray
    solids: SolidLoad


@dataclass(frozen=True)
class Points:
    """Points to be solved, all with or without particles and all with or without a film.

    ``log_load`` is ln F_t* [1], 1-D; ``film`` is None where the interface is dry.
    """

    contact: Contact
    film: Film | None
    log_load: NDArray

    @property
    def parameters(self) -> Parameters:
        """Inputs of the model."""
        return self.contact.parameters

    @property
    def surfaces(self) -> RoughSurfaces:
        """The rough surfaces of the points."""
        return self.contact.summits

    @property
    def shares_load(self) -> bool:
        """Whether the film takes part in the balance: whether W of Eq. 8 holds F_f, not F_t."""
        film_load = self.parameters.readings.film_load
        return self.film is not None and film_load.depends_on_shares

    def take(self, chosen) -> Points:
        """The points that an index or mask ``chosen`` picks."""
        film = self.film and self.film.take(chosen)
        return Points(self.contact.take(chosen), film, self.log_load[chosen])

    def forces(self, separation: NDArray, with_areas: bool = False) -> Forces:
        """Eq. 1 at ``separation`` d [m]: F_s (Eqs. 2 and 4) and, where films share the load, F_f of a
        film of thickness d (Eqs. 7 and 8); ``with_areas`` if those of ``solids`` are wanted too."""
        solids = self.contact.log_solid_load(separation, with_areas)
        log_solid = solids.value - self.log_load
        noise = solids.noise + self.surfaces.error + 2.0 * EPSILON * np.abs(self.log_load)
        steepest = np.maximum(solids.steepest, 1.0 / separation)
        rounding = solids.rounding + self.surfaces.error
        if not self.shares_load:
            nothing = np.full(separation.shape, -np.inf)
            found = log_solid, solids.slope, noise, steepest, rounding, log_solid, nothing
            return Forces(*found, noise, solids)
        log_fluid, film_slope, film_noise = self.log_film_load(separation)
        odds = np.exp(-np.abs(log_solid - log_fluid))
        larger = 1.0 / (1.0 + odds)
        share = np.where(log_solid > log_fluid, larger, odds * larger)  # of the solids
        return Forces(
            np.maximum(log_solid, log_fluid) + np.log1p(odds),
            share * solids.slope + (1.0 - share) * film_slope,
            share * noise + (1.0 - share) * film_noise + 4.0 * EPSILON,
            np.maximum(steepest, np.abs(film_slope)),
            np.maximum(rounding, film_noise),
            log_solid,
            log_fluid,
            noise,
            solids,
        )

    def log_film_load(self, separation: NDArray) -> tuple[NDArray, NDArray, NDArray]:
        """ln(F_f/F_t) of films as thick as ``separation`` d [m], its slope by d [m-1], and what rounding
        may change in it."""
        thickness = separation / self.parameters.ball_radius
        log_parameter, slope = self.film.load_parameter_and_slope(thickness)
        noise = self.film.rounding(log_parameter, 1.0 / slope) * np.abs(slope)
        log_load = log_parameter - log_load_parameter(self.log_load, self.parameters)
        return log_load, slope / separation, noise + INVERSE_ERROR

    def film_separation(self) -> tuple[NDArray, NDArray]:
        """d = R_x H_c [m] of films that carry the whole load (Eqs. 7 and 8), and the relative error
        that rounding leaves in it."""
        log_parameter = log_load_parameter(self.log_load, self.parameters)
        thickness, slope = self.film.thickness(log_parameter)
        rounding = self.film.rounding(log_parameter, slope / thickness)
        return self.parameters.ball_radius * thickness, rounding
