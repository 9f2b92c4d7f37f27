"""The points to be solved: what is given of them, and the interface that it describes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.model.contact import Contact
from thirdbody.model.film import INVERSE_STEPS, Film, has_film, log_load_parameter
from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import ParticleLayer, has_particles
from thirdbody.solver.surfaces import RoughSurfaces


class Axis(NamedTuple):
    """The values of a condition, float64 in SI; the least and the greatest, 1 and 0 if there is none."""

    values: NDArray
    least: float
    greatest: float

    @classmethod
    def of(cls, values: NDArray) -> Axis:
        """The axis of an array of values."""
        ends = (values.min(), values.max()) if values.size else (1.0, 0.0)
        return cls(values, *ends)


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

    def kinds(self, axes: Mapping[str, Axis] | None = None) -> NDArray | int:
        """The kind of each point, or of all: 2 if there is a film, and 1 more if there are particles.

        ``axes`` are those from which the conditions were taken, by their names: their ends may tell of
        all points at once what else takes a look at each.
        """

        def whether(there_is, *names):
            if axes is not None:
                least = there_is(*[axes[name].least for name in names])
                if least == there_is(*[axes[name].greatest for name in names]):
                    return int(least)
            return there_is(*(getattr(self, name) for name in names)).view(np.int8)

        three_body = whether(has_particles, "particle_diameter", "particle_density")
        return 2 * whether(has_film, "viscosity") + three_body

    def take(self, chosen) -> Conditions:
        """Those of the points that a slice, an index or a mask ``chosen`` picks."""
        return Conditions(*(column[chosen] for column in vars(self).values()))

    def points(
        self, parameters: Parameters, table_rtol: float | None, shared: bool | None = None
    ) -> Points:
        """The interface at points that all have particles or all have none, and all have a film
        or all have none; ``table_rtol`` and ``shared`` are as in ``make_contact``."""
        given = self.particle_diameter, self.roughness, self.particle_density
        contact = make_contact(*given, parameters, table_rtol, shared)
        film = None
        if self.are_lubricated[0]:
            film = Film.of(self.viscosity, self.roughness, parameters)
        return Points(contact, film, np.log(self.load))


def make_contact(
    particle_diameter: NDArray,
    roughness: NDArray,
    particle_density: NDArray,
    parameters: Parameters,
    table_rtol: float | None,
    shared: bool | None = None,
) -> Contact:
    """The solids of points that all have particles or all have none.

    Parameters
    ----------
    particle_diameter, roughness, particle_density : array
        x_a [m], sigma [m] and eta_a [m-2], 1-D and of one length.
    parameters : Parameters
        Inputs of the model.
    table_rtol : float or None
        Relative error for which tables of the summits are good; None: by quadrature.
    shared : bool, optional
        Whether surfaces share tables; by default if they are many.
    """
    particles = None
    if has_particles(particle_diameter[0], particle_density[0]):
        particles = ParticleLayer.of(particle_diameter, roughness, particle_density, parameters)
    surfaces = RoughSurfaces.of(roughness, parameters, table_rtol, shared)
    return Contact(surfaces, particles, parameters)


@dataclass(frozen=True)
class Points:
    """Points to be solved, all with or without particles and all with or without a film.

    ``log_load`` is ln F_t* [1], 1-D; ``film`` is None where the interface is dry; ``near`` are separations
    [m] that another way has found and could not promise, nan where it found none, or None.
    """

    contact: Contact
    film: Film | None
    log_load: NDArray
    near: NDArray | None = None

    @property
    def parameters(self) -> Parameters:
        """Inputs of the model."""
        return self.contact.parameters

    @property
    def surfaces(self) -> RoughSurfaces:
        """The rough surfaces of the points."""
        return self.contact.summits

    def take(self, chosen) -> Points:
        """The points that an index or mask ``chosen`` picks."""
        film = self.film and self.film.take(chosen)
        near = None if self.near is None else self.near[chosen]
        return Points(self.contact.take(chosen), film, self.log_load[chosen], near)

    def film_separation(self, log_fluid_fraction):
        """d = R_x H_c [m] where the film bears the share L_f of the load, dd/d ln L_f [m], and the
        relative error that rounding leaves in d [1]."""
        log_parameter = self.log_load_parameter(log_fluid_fraction)
        thickness, slope = self.film.thickness(log_parameter)
        rounding = self.film.rounding(log_parameter, thickness, slope)
        return (
            self.parameters.ball_radius * thickness,
            self.parameters.ball_radius * slope,
            rounding,
        )

    def log_film_load(self, separation, steps=INVERSE_STEPS):
        """ln of the load over F_t under which the film is as thick as ``separation`` d [m]; ``steps``
        are those of ``Film.load_parameter``."""
        thickness = separation / self.parameters.ball_radius
        return self.film.load_parameter(thickness, steps) - self.log_load_parameter(0.0)

    def log_load_parameter(self, log_fluid_fraction):
        """ln W of the share L_f of the load (Eq. 8)."""
        return log_load_parameter(self.log_load + log_fluid_fraction, self.parameters)
