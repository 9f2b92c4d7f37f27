"""Loads and areas of the solids at a given separation, and their slopes.

Two rough surfaces are a mean separation d apart, with or without particles between them.  Loads are
dimensionless, F* = F/(A_n E_ss); areas are relative to the apparent area A_n.  Summit load and
area, and sums of loads, are kept as logarithms, so that the tail of the summits keeps its digits.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import EPSILON, TINY, ParticleLayer, log_bare_fraction

FARTHEST = 1e60  # limit of t: nothing changes beyond it, and t^2 could overflow
NOTHING = np.log(TINY) - 50.0  # ln of a load F_ss* whose area is zero too


class SolidLoad(NamedTuple):
    """Load and area of summits and particles at a separation d: arrays of its shape.

    ``value`` is ln F_s* [1] and ``slope`` its derivative d/dd [m-1]. |d ln v/dd| [m-1] is at most
    ``steepest`` for each contribution v to loads and areas that is not zero in float64.  Rounding,
    except in d itself, changes ``value`` by at most ``noise`` [1], and each such v by at most
    ``rounding`` [1], relative.  ``area`` is A_sa/A_n [1], ``area_slope`` its derivative [m-1], and
    ``coverage`` [1] the fraction covered by particles larger than d.  For the summits beside the
    particles, ``log_load_beside`` is ln F_ss-sa* [1] and ``log_beside`` ln(A_ss-sa/A_n) [1], with
    their slopes [m-1]; the area is None if not requested.
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
        The third bodies; None for two-body contact.
    parameters : Parameters
        Inputs of the model.

    Notes
    -----
    In all methods ``separation`` is the mean separation d [m]; results have its shape.
    """

    summits: Any
    particles: ParticleLayer | None
    parameters: Parameters

    def take(self, chosen) -> Contact:
        """The contact at the points selected by an index or mask ``chosen``."""
        particles = self.particles and self.particles.take(chosen)
        return replace(self, summits=self.summits.take(chosen), particles=particles)

    def log_solid_load(self, separation: NDArray, with_areas: bool = False) -> SolidLoad:
        """Loads of summits and particles (Eqs. 2 and 4), and their areas (Eq. 5) if requested."""
        t = (separation - self.summits.offset) / self.summits.deviation
        t = np.minimum(t, FARTHEST)
        log_area = log_area_slope = None
        if with_areas:
            (log_summits, slope), (log_area, log_area_slope) = self.summits.log_load_and_area(t)
            log_area_slope = log_area_slope / self.summits.deviation
        else:
            log_summits, slope = self.summits.log_load(t)
        slope = slope / self.summits.deviation * (t < FARTHEST)
        rounding_of_d = np.abs(slope) * (separation + self.summits.offset)
        rounding = EPSILON * (24.0 + 4.0 * np.abs(log_summits) + 2.0 * rounding_of_d)
        if self.particles is None:
            has_load, zero = log_summits > NOTHING, np.zeros_like(slope)
            limits = np.where(has_load, -slope, 0.0), rounding, np.where(has_load, rounding, 0.0)
            beside = log_area, log_area_slope, log_summits, slope
            return SolidLoad(log_summits, slope, *limits, zero, zero, zero, *beside)
        area, area_slope, *coverage = self.particles.contact(separation)
        bare_area = log_bare_fraction(*coverage)  # Eq. 5: A_ss-sa = A_ss (1 - coverage)
        log_bare, bare_slope = self.particles.log_bare_load(bare_area)
        log_beside = log_summits + log_bare  # Eq. 4: F_ss-sa = F_ss (1 - coverage)
        log_particles = np.log(area) + np.log(self.parameters.particle_pressure)  # Eqs. 4 and 5
        particle_slope = np.where(area > TINY, area_slope / area, 0.0)
        value, fraction = log_sum(log_beside, log_particles)  # Eq. 2: F_s = F_ss-sa + F_sa
        log_bare_area, bare_area_slope = bare_area
        rounding = rounding + 8.0 * EPSILON * np.exp(-np.minimum(log_bare_area, log_bare))
        area_rounding = self.particles.rounding(separation, area, area_slope)
        noise = fraction * rounding + (1.0 - fraction) * area_rounding
        has_load = log_beside > NOTHING
        steepest = np.where(has_load, np.abs(slope) + bare_area_slope, 0.0)
        return SolidLoad(
            value,
            fraction * (slope + bare_slope) + (1.0 - fraction) * particle_slope,
            np.maximum(steepest, np.abs(particle_slope)),
            noise + 4.0 * EPSILON * (1.0 + np.abs(value)),
            np.maximum(np.where(has_load, rounding, 0.0), area_rounding),
            area,
            area_slope,
            coverage[0],
            log_area + log_bare_area if with_areas else None,
            log_area_slope + bare_area_slope if with_areas else None,
            log_beside,
            slope + bare_slope,
        )


def log_sum(log_first: NDArray, log_second: NDArray) -> tuple[NDArray, NDArray]:
    """ln of the sum of two loads given as logarithms, and the fraction of the first in the sum."""
    excess = log_first - log_second
    odds = np.exp(-np.abs(excess))  # smaller load over the larger
    fraction = np.where(excess > 0.0, 1.0, odds) / (1.0 + odds)
    return np.maximum(log_first, log_second) + np.log1p(odds), fraction


def greatest_single_load(parameters: Parameters) -> float:
    """F_t* [1] up to which the force balance has at most one root, with particles.

    F_s decreases with d, with two exceptions.  If the elastic factor is above 1, elastic particles
    carry more than plastic ones, and F_s may increase anywhere.  If only contacting particles
    reduce the summit load, F_ss (1 - coverage) may increase with d.  Particles of coverage c carry
    at least u (H_s2/E_ss) c, where u is the weight of sizes above d.  F_s can then increase only
    where F_ss* > u H_s2/E_ss, and F_s* exceeds this value there.
    """
    weight, _ = parameters.elastic_weights
    if not 0.0 <= weight <= 1.0:
        return 0.0
    if not parameters.interpretation.coverage_limits.contacting:
        return np.inf
    return weight * parameters.hardness_surface_2 / parameters.elastic_modulus_surfaces
