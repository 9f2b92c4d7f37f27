"""What is known of the solids at a given separation: their loads, their areas and the slopes.

Two rough surfaces are held a mean separation d apart, with particles between them or none.  Loads
are dimensionless, F* = F/(A_n E_ss), areas relative to the apparent area A_n.  The summits' load
and area, and the balance of loads, are logarithms: so the tail of the summits keeps its digits.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import FULL, ParticleLayer, log_bare_share

TINY = np.finfo(float).tiny


class Summits(Protocol):
    """What a contact asks of the summits of the two surfaces.

    ``log_load`` and ``log_area`` map summit separations t = (d - y_s)/sigma_s [1] to ln F_ss* and
    ln(A_ss/A_n), each as a pair of value and slope d/dt; ``offset`` y_s [m] and ``deviation``
    sigma_s [m] are scalars or have one element for each point.
    """

    @property
    def offset(self) -> ArrayLike: ...

    @property
    def deviation(self) -> ArrayLike: ...

    def log_load(self, t: NDArray) -> tuple[NDArray, NDArray]: ...

    def log_area(self, t: NDArray) -> tuple[NDArray, NDArray]: ...

    def take(self, chosen) -> Summits: ...


@dataclass(frozen=True)
class Contact:
    """Two rough surfaces and the particles between them, at many points.

    Parameters
    ----------
    summits : Summits
        Load and area of the summits in two-body contact.
    particles : ParticleLayer or None
        The third bodies; None where there are none (two-body contact).
    parameters : Parameters
        Inputs of the model.

    Notes
    -----
    ``separation`` is the mean separation d [m] in all methods; what they return has its shape.
    """

    summits: Summits
    particles: ParticleLayer | None
    parameters: Parameters

    def take(self, chosen) -> Contact:
        """The contact at the points that an index or mask ``chosen`` picks."""
        particles = self.particles and self.particles.take(chosen)
        return replace(self, summits=self.summits.take(chosen), particles=particles)

    @property
    def particle_pressure(self) -> float:
        """F_sa*/(A_sa/A_n) [1]: particles press with the hardness of surface 1 (Eqs. 4 and 5)."""
        return self.parameters.hardness_surface_1 / self.parameters.elastic_modulus_surfaces

    def summit_separation(self, separation: NDArray) -> NDArray:
        """Separation t [1] from the plane of the summits, in their standard deviations."""
        return (separation - self.summits.offset) / self.summits.deviation

    def log_solid_load(self, separation: NDArray) -> tuple[NDArray, NDArray, NDArray]:
        """Load that summits and particles bear together.

        Parameters
        ----------
        separation : array
            Mean separation d [m].

        Returns
        -------
        value : array
            ln F_s* [1].
        slope : array
            d ln F_s*/dd [m-1].
        steepest : array
            The steepest of the slopes of its parts, d ln F_ss*/dd and d ln F_sa*/dd [m-1], which
            bounds how fast any share of the load changes; a part that is zero in float64 does not
            count.
        """
        log_summits, slope = self.summits.log_load(self.summit_separation(separation))
        slope = slope / self.summits.deviation
        if self.particles is None:
            return log_summits, slope, np.where(log_summits > FULL, slope, 0.0)
        area, area_slope, *coverage = self.particles.contact(separation)
        log_bare, bare_slope = self.particles.log_bare_load(*coverage)
        log_beside = log_summits + log_bare  # Eq. 4: F_ss-sa = F_ss (1 - coverage)
        slope = slope + bare_slope
        log_particles = np.log(area) + np.log(self.particle_pressure)  # Eqs. 4 and 5
        particle_slope = np.where(area > TINY, area_slope / area, 0.0)
        value, share = _log_sum(log_beside, log_particles)  # Eq. 2: F_s = F_ss-sa + F_sa
        return (
            value,
            share * slope + (1.0 - share) * particle_slope,
            np.minimum(np.where(log_beside > FULL, slope, 0.0), particle_slope),
        )

    def areas(self, separation: NDArray, touching: tuple | None = None) -> tuple[NDArray, NDArray]:
        """Real contact areas of particles and, beside them, of summits.

        Parameters
        ----------
        separation : array
            Mean separation d [m].
        touching : tuple, optional
            What ``ParticleLayer.contact`` returns there, if it is known already.

        Returns
        -------
        particles : array
            A_sa/A_n [1].
        log_summits : array
            ln(A_ss-sa/A_n) [1].
        """
        log_summits, _ = self.summits.log_area(self.summit_separation(separation))
        if self.particles is None:
            return np.zeros_like(log_summits), log_summits
        area, _, *coverage = touching or self.particles.contact(separation)
        log_bare, _ = log_bare_share(*coverage)
        return area, log_summits + log_bare  # Eq. 5: A_ss-sa = A_ss (1 - coverage)

    def odds_slope(self, separation: NDArray) -> NDArray:
        """How the particles' area changes with d [m-1], seen against that of the summits.

        Returns
        -------
        array
            dA_sa/dd - A_sa d ln A_ss-sa/dd over A_n.  It has the sign of the slope of A_sa/A_ss-sa,
            hence of A_sa,t*, but is finite where no summit touches; negative where no particle
            touches.
        """
        _, summit_slope = self.summits.log_area(self.summit_separation(separation))
        area, area_slope, *coverage = self.particles.contact(separation)
        _, bare_slope = log_bare_share(*coverage)
        summit_slope = summit_slope / self.summits.deviation + bare_slope
        return np.where(area > 0.0, area_slope - area * summit_slope, -TINY)


def _log_sum(log_first, log_second):
    """ln of the sum of two loads from their logarithms, and the share of the first in it."""
    excess = log_first - log_second
    odds = np.exp(-np.abs(excess))  # of the smaller load to the larger
    share = np.where(excess > 0.0, 1.0, odds) / (1.0 + odds)
    return np.maximum(log_first, log_second) + np.log1p(odds), share
