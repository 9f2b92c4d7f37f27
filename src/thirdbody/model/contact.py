"""What is known of the solids at a given separation: their loads, their areas and the slopes.

Two rough surfaces are held a mean separation d apart, with particles between them or none.  Loads
are dimensionless, F* = F/(A_n E_ss), areas relative to the apparent area A_n.  The summits' load
and area, and the balance of loads, are logarithms: so the tail of the summits keeps its digits.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import EPSILON, TINY, ParticleLayer, log_bare_fraction

FARTHEST = 1e60  # t beyond which nothing changes, and float64 would not hold its square
NOTHING = np.log(TINY) - 50.0  # ln of a load F_ss* that has no area either


class SolidLoad(NamedTuple):
    """What summits and particles carry together at a separation d: arrays of its shape.

    ``value`` is ln F_s* [1] and ``slope`` its derivative by d [m-1].  ``steepest`` bounds |d ln v/dd|
    [m-1] of each part v of loads and areas that is not zero in float64.  Rounding, except that of d
    itself, may change ``value`` by ``noise`` [1] and any such v by ``rounding`` [1], relative.
    ``area`` is A_sa/A_n [1], ``area_slope`` its derivative [m-1], and ``coverage`` [1] that of the
    particles larger than d.  Of the summits beside the particles, ``log_load_beside`` is ln F_ss-sa*
    [1] and ``log_beside`` ln(A_ss-sa/A_n) [1], with their slopes [m-1]; None if not asked for.
    """

    value: NDArray
    slope: NDArray
    steepest: NDArray
    noise: NDArray
    rounding: NDArray
    area: NDArray
    area_slope: NDArray
    coverage: NDArray
    log_beside: NDArray | None
    beside_slope: NDArray | None
    log_load_beside: NDArray
    load_beside_slope: NDArray


@dataclass(frozen=True)
class Contact:
    """Two rough surfaces and the particles between them, at many points.

    Parameters
    ----------
    summits : RoughSurfaces
        Their ``log_load`` maps summit separations t = (d - y_s)/sigma_s [1] to ln F_ss* and its slope
        d/dt, ``log_load_and_area`` to ln(A_ss/A_n) and its slope as well; ``offset`` is y_s and
        ``deviation`` sigma_s [m].
    particles : ParticleLayer or None
        The third bodies; None where there are none (two-body contact).
    parameters : Parameters
        Inputs of the model.

    Notes
    -----
    ``separation`` is the mean separation d [m] in all methods; what they return has its shape.
    """

    summits: Any
    particles: ParticleLayer | None
    parameters: Parameters

    def take(self, chosen) -> Contact:
        """The contact at the points that an index or mask ``chosen`` picks."""
        particles = self.particles and self.particles.take(chosen)
        return replace(self, summits=self.summits.take(chosen), particles=particles)

    def log_solid_load(self, separation: NDArray, with_areas: bool = False) -> SolidLoad:
        """Loads of summits and particles (Eqs. 2 and 4), and their areas (Eq. 5) if asked for."""
        t = (separation - self.summits.offset) / self.summits.deviation
        t = np.minimum(t, FARTHEST)
        log_area = area_fall = None
        if with_areas:
            (log_summits, slope), (log_area, area_fall) = self.summits.log_load_and_area(t)
            area_fall = area_fall / self.summits.deviation
        else:
            log_summits, slope = self.summits.log_load(t)
        slope = np.where(t < FARTHEST, slope / self.summits.deviation, 0.0)
        placed = EPSILON * np.abs(slope) * (np.abs(separation) + np.abs(self.summits.offset))
        rounded = EPSILON * (24.0 + 4.0 * np.abs(log_summits)) + 2.0 * placed
        if self.particles is None:
            counts, nothing = log_summits > NOTHING, np.zeros_like(slope)
            limits = np.where(counts, -slope, 0.0), rounded, np.where(counts, rounded, 0.0)
            beside = log_area, area_fall, log_summits, slope
            return SolidLoad(log_summits, slope, *limits, nothing, nothing, nothing, *beside)
        area, area_slope, *coverage = self.particles.contact(separation)
        room = log_bare_fraction(*coverage)  # Eq. 5: A_ss-sa = A_ss (1 - coverage)
        log_bare, bare_slope = self.particles.log_bare_load(room)
        log_beside = log_summits + log_bare  # Eq. 4: F_ss-sa = F_ss (1 - coverage)
        log_particles = np.log(area) + np.log(self.parameters.particle_pressure)  # Eqs. 4 and 5
        particle_slope = np.where(area > TINY, area_slope / area, 0.0)
        value, fraction = log_sum(log_beside, log_particles)  # Eq. 2: F_s = F_ss-sa + F_sa
        log_room, room_slope = room
        rounded = rounded + 8.0 * EPSILON * np.exp(-np.minimum(log_room, log_bare))
        rounded_area = self.particles.rounding(separation, area, area_slope)
        noise = fraction * rounded + (1.0 - fraction) * rounded_area
        counts = log_beside > NOTHING
        return SolidLoad(
            value,
            fraction * (slope + bare_slope) + (1.0 - fraction) * particle_slope,
            np.maximum(np.where(counts, np.abs(slope) + room_slope, 0.0), np.abs(particle_slope)),
            noise + 4.0 * EPSILON * (1.0 + np.abs(value)),
            np.maximum(np.where(counts, rounded, 0.0), rounded_area),
            area,
            area_slope,
            coverage[0],
            log_area + log_room if with_areas else None,
            area_fall + room_slope if with_areas else None,
            log_beside,
            slope + bare_slope,
        )


def log_sum(log_first: NDArray, log_second: NDArray) -> tuple[NDArray, NDArray]:
    """ln of the sum of two loads from their logarithms, and the fraction of the first in it."""
    excess = log_first - log_second
    odds = np.exp(-np.abs(excess))  # of the smaller load to the larger
    fraction = np.where(excess > 0.0, 1.0, odds) / (1.0 + odds)
    return np.maximum(log_first, log_second) + np.log1p(odds), fraction


def greatest_single_load(parameters: Parameters) -> float:
    """F_t* [1] up to which no more than one separation balances it, where there are particles.

    F_s falls with d, with two exceptions.  Elastic particles of a factor above 1 carry more than
    plastic ones: so F_s may rise anywhere.  And where contacting particles alone take room from the
    summits, F_ss (1 - coverage) may rise with d.  Particles of a coverage c carry at least
    u (H_s2/E_ss) c, where u is the weight of the sizes above d, so that F_s cannot rise unless
    F_ss* > u H_s2/E_ss, and is itself above that there.
    """
    weight, _ = parameters.elastic_weights
    if not 0.0 <= weight <= 1.0:
        return 0.0
    if not parameters.interpretation.coverage_limits.contacting:
        return np.inf
    return weight * parameters.hardness_surface_2 / parameters.elastic_modulus_surfaces
