"""Loads and areas of the solids at a separation, and their slopes.

Two rough surfaces are a mean separation d apart, with or without particles between them.  Loads are
dimensionless, F* = F/(A_n E_ss); areas are relative to the apparent area A_n.  Load and area of the
summits, and sums of loads, are logarithms, so that float64 keeps the digits of very small numbers.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.core.logarithms import EPSILON, TINY, WithSlope, log_product, log_sum
from thirdbody.core.parameters import Parameters
from thirdbody.core.particles import ParticleLayer, has_particles, log_bare_fraction
from thirdbody.core.summits import Summits

FARTHEST = 1e60  # limit of t: a larger t changes nothing, and t^2 could overflow
NOTHING = np.log(TINY) - 50.0  # ln F_ss* below which the area underflows too
# rounding of ln F_ss*, in EPSILON: a constant, and factors of the size of the logarithm and of the
# rounding of d
ROUNDINGS, ROUNDINGS_PER_SIZE, ROUNDINGS_OF_D = 24.0, 4.0, 2.0


class ErrorTerms(NamedTuple):
    """Errors of loads and areas at a separation d, in arrays of the shape of d.

    Loads and areas are sums of contributions v of summits and particles.  Contributions that are
    zero in float64 do not count.  The errors are those at an exact d.

    Attributes
    ----------
    steepest : array
        Largest |d ln v/dd| [m-1].
    rounding : array
        Largest relative error of a contribution [1], from rounding and tables.
    noise : array
        Relative error of the sum of loads [1].
    """

    steepest: NDArray
    rounding: NDArray
    noise: NDArray


class SolidState(NamedTuple):
    """Loads and areas of summits and particles at a separation d, in arrays of the shape of d.

    ``log_load`` is ln F_s* [1].  The summits beside the particles have ``log_summit_load``,
    ln F_ss-sa* [1], and ``log_summit_area``, ln(A_ss-sa/A_n) [1], nan if not requested.
    ``particle_area`` is A_sa/A_n [1].  ``coverage`` [1] is the fraction of the interface that
    particles larger than d cover.  The noise in ``errors`` is that of ``log_load``.
    """

    log_load: WithSlope
    log_summit_load: WithSlope
    log_summit_area: WithSlope
    particle_area: WithSlope
    coverage: NDArray
    errors: ErrorTerms


@dataclass(frozen=True)
class Contact:
    """Two rough surfaces and the particles between them, at many points.

    Parameters
    ----------
    summits : Summits
        The summits of both surfaces.
    particles : ParticleLayer or None
        The third bodies; None for two-body contact.
    parameters : Parameters
        Inputs of the model.

    Notes
    -----
    In all methods ``separation`` is the mean separation d [m]; results have its shape.
    """

    summits: Summits
    particles: ParticleLayer | None
    parameters: Parameters

    @classmethod
    def of(
        cls,
        particle_diameter: NDArray,
        roughness: NDArray,
        particle_density: NDArray,
        parameters: Parameters,
        table_rtol: float | None = None,
    ) -> Contact:
        """The contact at points with x_a [m], sigma [m] and eta_a [m-2], 1-D and of equal length.

        All points have particles, or none has.  ``table_rtol`` is the relative error of tables of
        the summits; None, the default, is quadrature without tables.
        """
        particles = None
        if has_particles(particle_diameter[0], particle_density[0]):
            particles = ParticleLayer.of(particle_diameter, roughness, particle_density, parameters)
        summits = Summits.of(roughness, parameters, table_rtol)
        return cls(summits=summits, particles=particles, parameters=parameters)

    def take(self, chosen) -> Contact:
        """The contact at the points selected by an index or mask ``chosen``."""
        particles = self.particles and self.particles.take(chosen)
        return replace(self, summits=self.summits.take(chosen), particles=particles)

    def at(self, separation: NDArray, with_areas: bool = False) -> SolidState:
        """Loads of summits and particles (Eqs. 2 and 4) and the area of the particles (Eq. 5).

        The area of the summits is included only ``with_areas``.
        """
        log_load, log_area = self._summits_alone(separation, with_areas)
        rounding_of_d = np.abs(log_load.slope) * (separation + self.summits.offset)
        size = ROUNDINGS_PER_SIZE * np.abs(log_load.value)
        rounding = EPSILON * (ROUNDINGS + size + ROUNDINGS_OF_D * rounding_of_d)
        if self.particles is None:
            return _without_particles(log_load, log_area, rounding)
        return self._with_particles(self.particles, separation, log_load, log_area, rounding)

    def _summits_alone(self, separation, with_areas):
        """ln F_ss* and ln(A_ss/A_n), the latter nan unless ``with_areas``, as without particles."""
        deviation = self.summits.deviation
        t = np.minimum((separation - self.summits.offset) / deviation, FARTHEST)
        if with_areas:
            (log_load, load_slope), (log_area, area_slope) = self.summits.log_load_and_area(t)
        else:
            log_load, load_slope = self.summits.log_load(t)
            log_area = area_slope = np.full_like(t, np.nan)
        load_slope = load_slope / deviation * (t < FARTHEST)
        return (
            WithSlope(value=log_load, slope=load_slope),
            WithSlope(value=log_area, slope=area_slope / deviation),
        )

    def _with_particles(self, particles, separation, log_load, log_area, rounding):
        """The state with ``particles``: they take load and area from the summits."""
        area, coverage = particles.contact(separation)
        bare_area = log_bare_fraction(coverage)
        # Eq. 4: F_ss-sa is F_ss times the fraction that particles of all sizes leave bare
        log_summits = log_load._replace(value=log_load.value + particles.log_bare)
        log_particles = WithSlope(  # Eqs. 4 and 5: F_sa is the hardness times A_sa
            value=np.log(area.value) + np.log(self.parameters.particle_pressure),
            slope=np.where(area.value > TINY, area.slope / area.value, 0.0),
        )
        log_solids, fraction = log_sum(log_summits, log_particles)  # Eq. 2: F_s = F_ss-sa + F_sa
        rounding = rounding + 8.0 * EPSILON * np.exp(-particles.log_bare)
        area_rounding = particles.rounding(separation, area)
        noise = fraction * rounding + (1.0 - fraction) * area_rounding
        has_load = log_summits.value > NOTHING
        steepest = np.where(has_load, np.abs(log_load.slope) + bare_area.slope, 0.0)
        errors = ErrorTerms(
            steepest=np.maximum(steepest, np.abs(log_particles.slope)),
            rounding=np.maximum(np.where(has_load, rounding, 0.0), area_rounding),
            noise=noise + 4.0 * EPSILON * (1.0 + np.abs(log_solids.value)),
        )
        return SolidState(
            log_load=log_solids,
            log_summit_load=log_summits,
            # Eq. 5: A_ss-sa = A_ss (1 - coverage)
            log_summit_area=log_product(log_area, bare_area),
            particle_area=area,
            coverage=coverage.value,
            errors=errors,
        )


def _without_particles(log_load, log_area, rounding):
    """The state of two-body contact."""
    has_load, nothing = log_load.value > NOTHING, np.zeros_like(log_load.slope)
    errors = ErrorTerms(
        steepest=np.where(has_load, -log_load.slope, 0.0),
        rounding=np.where(has_load, rounding, 0.0),
        noise=rounding,
    )
    return SolidState(
        log_load=log_load,
        log_summit_load=log_load,
        log_summit_area=log_area,
        particle_area=WithSlope(value=nothing, slope=nothing),
        coverage=nothing,
        errors=errors,
    )
