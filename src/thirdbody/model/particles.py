"""Third particles between the surfaces: load, area and coverage in closed form (Eqs. 4-6).

Every reading of the size distribution phi_a gives the second moment above a size a as

    T(alpha) = c_1 M(alpha),   M = Q(alpha) + (c_2 + c_3 alpha) phi(alpha),   alpha = (a - m)/S,

with phi and Q the density and upper tail of the standard normal distribution, so that
I(a, b) = T(alpha) - T(beta).  The readings differ in m, S, c_1, c_2, c_3 alone, of which c_2 and c_3
are the same for all particles of a reading.  Particles end at X_max = m + truncation * S, so M is
never needed deep in the tail.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.special import ndtr

from thirdbody.model.parameters import Parameters

FULL = -700.0  # logarithm of a share that is none
INV_SQRT_2PI = 1.0 / np.sqrt(2.0 * np.pi)


@dataclass(frozen=True)
class SizeLaw:
    """One reading of phi_a: m, S [m], c_1 [m2]; c_2, c_3 and alpha of the smallest size."""

    mean: np.ndarray
    spread: np.ndarray
    square: np.ndarray
    constant: float
    linear: float
    smallest: float


def _uncentred(diameter, roughness, parameters) -> SizeLaw:
    """Eq. 6 as printed: m = 0, S = sigma_a; sizes from X_min = 0."""
    spread = parameters.spread_ratio * diameter
    return SizeLaw(np.zeros_like(spread), spread, spread**2, 0.0, 1.0, 0.0)


def _centred(diameter, roughness, parameters) -> SizeLaw:
    """N(m, sigma_a^2) about the mean diameter, as the text speaks of x_a; sizes from X_min = 0."""
    mean, spread = parameters.mean_ratio, parameters.spread_ratio
    square = mean**2 + spread**2
    return SizeLaw(
        mean * diameter,
        spread * diameter,
        square * diameter**2,
        2.0 * mean * spread / square,
        spread**2 / square,
        -mean / spread,
    )


def _gap_convolved(diameter, roughness, parameters) -> SizeLaw:
    """Particles of all sizes meet the local gap: its spread joins that of the sizes."""
    mean = parameters.mean_ratio * diameter
    spread = np.hypot(parameters.spread_ratio * diameter, parameters.gap_ratio * roughness)
    square = (1.0 + parameters.spread_ratio**2) * diameter**2
    return SizeLaw(mean, spread, square, 0.0, 0.0, -np.inf)


SIZE_DISTRIBUTIONS = {
    "uncentred": _uncentred,
    "centred": _centred,
    "gap_convolved": _gap_convolved,
}
# Limits of the elastic integral as multiples of h_e about d: as printed, and physically.
ELASTIC_LIMITS = {"printed": (-1.0, 0.0), "physical": (0.0, 1.0)}


@dataclass(frozen=True)
class ParticleLayer:
    """Particles of given mean diameter and density on a surface; array fields share one shape."""

    mean: np.ndarray  # m [m]
    spread: np.ndarray  # S [m]
    depth: np.ndarray  # h_e/S [1]
    share: np.ndarray  # pi eta_a p c_1/(H_s1 + H_s2) [Pa-1]: times hardness and M of the interface
    log_bare: np.ndarray  # ln of the share that all sizes leave bare, if Eq. 4 counts them
    law: tuple[float, float]  # c_2, c_3
    largest: float  # M at X_max
    parameters: Parameters

    @classmethod
    def of(cls, diameter, roughness, density, parameters: Parameters) -> ParticleLayer:
        """Layer of particles: ``diameter`` x_a [m], ``density`` eta_a [m-2], ``roughness`` [m].

        Arrays of one shape, but ``roughness`` may be a scalar; ``diameter`` and ``density`` positive.
        """
        sizes = SIZE_DISTRIBUTIONS[parameters.size_distribution](diameter, roughness, parameters)
        law = sizes.constant, sizes.linear
        largest = float(_moment(parameters.truncation, *law)[0])
        hardness = parameters.hardness_surface_1 + parameters.hardness_surface_2
        share = np.pi * parameters.participation / hardness * density * sizes.square
        depth = parameters.elastic_depth_ratio * diameter / sizes.spread
        log_bare = np.zeros_like(share)
        if parameters.coverage_limits == "printed":
            every = 1.0  # without a smallest or largest size
            if np.isfinite(sizes.smallest):
                every = float(_moment(sizes.smallest, *law)[0]) - largest
            log_bare = np.log(_bare_share(parameters.hardness_surface_1 * every * share))
        return cls(sizes.mean, sizes.spread, depth, share, log_bare, law, largest, parameters)

    def take(self, chosen) -> ParticleLayer:
        """The layer at the points that an index or mask ``chosen`` picks."""
        columns = self.mean, self.spread, self.depth, self.share, self.log_bare
        picked = (column[chosen] for column in columns)
        return ParticleLayer(*picked, self.law, self.largest, self.parameters)

    @property
    def reach(self):
        """Separation [m] beyond which no particle touches: X_max + h_e."""
        return self.mean + (self.parameters.truncation + self.depth) * self.spread

    def contact(self, separation):
        """Area and coverage of the particles that touch at ``separation`` d [m] (Eq. 5).

        Returns A_sa/A_n [1], its slope d/dd [m-1], the share of the interface under particles
        larger than d [1] and its slope [m-1], each of the shape of ``separation``.
        """
        alpha = (separation - self.mean) / self.spread
        touching = self._truncated(alpha)
        low, high = (
            touching if limit == 0.0 else self._truncated(alpha + limit * self.depth)
            for limit in ELASTIC_LIMITS[self.parameters.elastic_limits]
        )
        beyond = touching[0] - self.largest
        elastic = self.parameters.elastic_factor
        area_factor = self.share * self.parameters.hardness_surface_2
        load_factor = self.share * self.parameters.hardness_surface_1
        return (
            area_factor * (elastic * (low[0] - high[0]) + beyond),
            area_factor / self.spread * (elastic * (low[1] - high[1]) + touching[1]),
            load_factor * beyond,
            load_factor / self.spread * touching[1],
        )

    def log_bare_load(self, coverage, slope):
        """ln of the share of the summits' load that Eq. 4 leaves them, and its slope [m-1].

        ``coverage`` and ``slope`` are those of ``contact``; Eq. 4 as printed takes all sizes.
        """
        if self.parameters.coverage_limits == "contacting":
            return log_bare_share(coverage, slope)
        return self.log_bare, 0.0

    def leave_no_room(self, coverage):
        """Whether a coverage of Eqs. 4-5 reaches 1 where that of ``contact`` is ``coverage``.

        The coverage of Eq. 5 counts the particles larger than d, that of Eq. 4 at least those.
        """
        if self.parameters.coverage_limits == "contacting":
            return 1.0 - coverage <= np.finfo(float).eps
        return self.log_bare < FULL

    def _truncated(self, alpha):
        """M and dM/dalpha with ``alpha`` held at the truncation."""
        truncation = self.parameters.truncation
        value, slope = _moment(np.minimum(alpha, truncation), *self.law)
        return value, np.where(alpha < truncation, slope, 0.0)


def _moment(alpha, constant, linear):
    """M(alpha) and dM/dalpha for c_2 and c_3."""
    phi = INV_SQRT_2PI * np.exp(-0.5 * alpha * alpha)
    polynomial = constant + linear * alpha
    return ndtr(-alpha) + polynomial * phi, -phi * (1.0 - linear + polynomial * alpha)


def log_bare_share(coverage, slope):
    """ln(1 - coverage) and its slope; below ``FULL`` where particles cover everything."""
    bare = _bare_share(coverage)
    covers = bare == np.finfo(bare.dtype).tiny
    return np.log(bare), np.where(covers, 0.0, -slope) / bare


def _bare_share(coverage):
    """1 - coverage, or next to nothing where particles cover everything."""
    bare = 1.0 - coverage
    return np.where(bare <= np.finfo(float).eps, np.finfo(bare.dtype).tiny, bare)


def has_particles(diameter, density):
    """Whether particles of ``diameter`` [m] and ``density`` [m-2] cover more than float64's zero."""
    return diameter**2 * density > np.finfo(float).tiny


def separation_bearing(area, layer: ParticleLayer):
    """Separation d [m] at which particles alone have about ``area`` A_sa/A_n [1]; a first guess.

    Read off one sampled curve, which all diameters and densities share but for the elastic depth.
    """
    return layer.mean + layer.spread * np.interp(
        area / layer.share, *sampled_contact(layer.parameters)
    )


def sampled_contact(parameters: Parameters):
    """Increasing areas A_sa/A_n over ``share`` [Pa], and alpha there; for first guesses."""
    same = np.ones_like(SHAPE_SAMPLES)
    unit = ParticleLayer.of(same, same, same, parameters)
    alpha = parameters.truncation + unit.depth
    alpha = alpha - SHAPE_SAMPLES * (parameters.truncation + 2.0 * unit.depth + 6.0)
    return unit.contact(unit.mean + alpha * unit.spread)[0] / unit.share, alpha


def unit_moment(parameters: Parameters):
    """The function of alpha that M and its slope are for all particles of a reading."""
    one = np.ones(1)
    sizes = SIZE_DISTRIBUTIONS[parameters.size_distribution](one, one, parameters)
    return lambda alpha: _moment(alpha, sizes.constant, sizes.linear)


SHAPE_SAMPLES = np.concatenate([[0.0], np.geomspace(1e-5, 1.0, 199)])
