"""What is known of the solids at a given separation: their loads, their areas and the slopes.

Two rough surfaces are held a mean separation d apart, with particles between them or none.  Loads
are dimensionless, F* = F/(A_n E_ss), areas relative to the apparent area A_n.  The summits' load
and area, and the balance of loads, are logarithms: so the tail of the summits keeps its digits.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import EPSILON, TINY, VANISHED, ParticleLayer, log_bare_share

FARTHEST = 1e60  # t beyond which nothing changes, and float64 would not hold its square
NOTHING = VANISHED - 50.0  # ln of a load F_ss* that has no area either


class Summits(Protocol):
    """What a contact asks of the summits of the two surfaces.

    ``log_load`` and ``log_area`` map summit separations t = (d - y_s)/sigma_s [1] to ln F_ss* and
    ln(A_ss/A_n), each as a pair of value and slope d/dt, ``log_load_and_area`` to both; ``offset`` y_s [m] and ``deviation``
    sigma_s [m] are scalars or have one element for each point.
    """

    @property
    def offset(self) -> ArrayLike: ...

    @property
    def deviation(self) -> ArrayLike: ...

    def log_load(self, t: NDArray) -> tuple[NDArray, NDArray]: ...

    def log_area(self, t: NDArray) -> tuple[NDArray, NDArray]: ...

    def log_load_and_area(self, t: NDArray) -> tuple: ...

    def take(self, chosen) -> Summits: ...


class SolidLoad(NamedTuple):
    """What summits and particles bear together at a separation d, of the shape of d.

    Attributes
    ----------
    value : array
        ln F_s* [1].
    slope : array
        d ln F_s*/dd [m-1].
    steepest : array
        A bound on |d ln v/dd| [m-1] for each v that summits and particles have of load and area; a
        part that is zero in float64 does not count.
    noise : array
        What rounding may change in ``value`` [1], but for that of d itself.
    rounding : array
        Relative error that rounding leaves in any such v [1], but for that of d itself.
    touching : tuple of array or None
        What ``ParticleLayer.contact`` returns there; None without particles.
    log_area : array or None
        ln(A_ss/A_n), were there no particles; None if it was not asked for.
    """

    value: NDArray
    slope: NDArray
    steepest: NDArray
    noise: NDArray
    rounding: NDArray
    touching: tuple | None
    log_area: NDArray | None


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

    def summit_separation(self, separation: NDArray) -> NDArray:
        """Separation t [1] from the plane of the summits, in their standard deviations."""
        t = (separation - self.summits.offset) / self.summits.deviation
        return np.minimum(t, FARTHEST)

    def log_solid_load(self, separation: NDArray, with_areas: bool = False) -> SolidLoad:
        """Load that summits and particles carry together at ``separation`` d [m]; ``with_areas`` if
        ``areas`` are wanted there too, which then take less time."""
        t = self.summit_separation(separation)
        log_area = None
        if with_areas:
            (log_summits, slope, *_), (log_area, *_) = self.summits.log_load_and_area(t)
        else:
            log_summits, slope = self.summits.log_load(t)
        slope = np.where(t < FARTHEST, slope / self.summits.deviation, 0.0)
        placed = EPSILON * np.abs(slope) * (np.abs(separation) + np.abs(self.summits.offset))
        rounded = EPSILON * (24.0 + 4.0 * np.abs(log_summits)) + 2.0 * placed
        if self.particles is None:
            steepest = np.where(log_summits > NOTHING, -slope, 0.0)
            rounding = np.where(log_summits > NOTHING, rounded, 0.0)
            return SolidLoad(log_summits, slope, steepest, rounded, rounding, None, log_area)
        touching = self.particles.contact(separation)
        area, area_slope, *coverage = touching
        log_bare, bare_slope = self.particles.log_bare_load(*coverage)
        log_beside = log_summits + log_bare  # Eq. 4: F_ss-sa = F_ss (1 - coverage)
        log_particles = np.log(area) + np.log(self.parameters.particle_pressure)  # Eqs. 4 and 5
        particle_slope = np.where(area > TINY, area_slope / area, 0.0)
        value, share = _log_sum(log_beside, log_particles)  # Eq. 2: F_s = F_ss-sa + F_sa
        log_room, room_slope = log_bare_share(*coverage)  # Eq. 5
        rounded = rounded + 8.0 * EPSILON * np.exp(-np.minimum(log_room, log_bare))
        rounded_area = self.particles.rounding(separation, area, area_slope)
        return SolidLoad(
            value,
            share * (slope + bare_slope) + (1.0 - share) * particle_slope,
            np.maximum(
                np.where(log_beside > NOTHING, np.abs(slope) + room_slope, 0.0),
                np.abs(particle_slope),
            ),
            share * rounded + (1.0 - share) * rounded_area + 4.0 * EPSILON * (1.0 + np.abs(value)),
            np.maximum(np.where(log_beside > NOTHING, rounded, 0.0), rounded_area),
            touching,
            log_area,
        )

    def areas(self, separation: NDArray, known: SolidLoad | None = None) -> tuple[NDArray, NDArray]:
        """Real contact areas of particles and, beside them, of summits.

        Parameters
        ----------
        separation : array
            Mean separation d [m].
        known : SolidLoad, optional
            What ``log_solid_load`` returns there with areas, if it is known already.

        Returns
        -------
        particles : array
            A_sa/A_n [1].
        log_summits : array
            ln(A_ss-sa/A_n) [1].
        """
        if known is None:
            known = self.log_solid_load(separation, with_areas=True)
        log_summits = known.log_area
        if self.particles is None:
            return np.zeros_like(log_summits), log_summits
        area, _, *coverage = known.touching
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


def greatest_single_load(parameters: Parameters) -> float:
    """F_t* [1] up to which no more than one separation balances it, where there are particles.

    F_s falls with d, but for two reasons.  Elastic particles of a factor above 1 bear more than
    plastic ones: so F_s may rise anywhere.  And where contacting particles alone take room from the
    summits, F_ss (1 - coverage) may rise with d.  Particles of a coverage c bear at least
    u (H_s2/E_ss) c, where u is the weight of the sizes above d, so that F_s cannot rise unless
    F_ss* > u H_s2/E_ss, and is itself above that there.
    """
    limits, coverage = parameters.readings.elastic_limits, parameters.readings.coverage_limits
    weight, _ = limits.weights(parameters.elastic_factor)
    if not 0.0 <= weight <= 1.0:
        return 0.0
    if not coverage.contacting:
        return np.inf
    return weight * parameters.hardness_surface_2 / parameters.elastic_modulus_surfaces
