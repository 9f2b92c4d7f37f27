"""Third particles between the surfaces: load, area and coverage in closed form (Eqs. 4-6).

Every reading of the size distribution phi_a gives the second moment above a size a as

    T(alpha) = c_1 Q(alpha) + (c_2 + c_3 alpha) phi(alpha),   alpha = (a - m)/S,

with phi and Q the density and upper tail of the standard normal distribution, so that
I(a, b) = T(alpha) - T(beta).  The readings differ in m, S, c_1, c_2, c_3 alone.  Particles end at
X_max = m + truncation * S, so T is never needed deep in the tail.
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np
from scipy.special import ndtr

from thirdbody.parameters import Parameters

INV_SQRT_2PI = 1.0 / np.sqrt(2.0 * np.pi)


def _uncentred(diameter, roughness, parameters):
    """Eq. 6 as printed: m = 0, S = sigma_a."""
    spread = parameters.spread_ratio * diameter
    return np.zeros_like(spread), spread, spread**2, np.zeros_like(spread), spread**2


def _centred(diameter, roughness, parameters):
    """N(m, sigma_a^2) about the mean diameter, as the text speaks of x_a."""
    mean, spread = parameters.mean_ratio * diameter, parameters.spread_ratio * diameter
    return mean, spread, mean**2 + spread**2, 2.0 * mean * spread, spread**2


def _gap_convolved(diameter, roughness, parameters):
    """Particles of all sizes meet the local gap: its spread joins that of the sizes."""
    mean = parameters.mean_ratio * diameter
    spread = np.hypot(parameters.spread_ratio * diameter, parameters.gap_ratio * roughness)
    square = (1.0 + parameters.spread_ratio**2) * diameter**2
    return mean, spread, square, np.zeros_like(spread), np.zeros_like(spread)


SIZE_DISTRIBUTIONS = {
    "uncentred": _uncentred,
    "centred": _centred,
    "gap_convolved": _gap_convolved,
}


def _printed_limits(alpha, depth):
    """Limits (d - h_e, d) of the elastic integral as printed."""
    return alpha - depth, alpha


def _physical_limits(alpha, depth):
    """Limits (d, d + h_e): particles barely larger than the gap."""
    return alpha, alpha + depth


ELASTIC_LIMITS = {"printed": _printed_limits, "physical": _physical_limits}


@dataclass(frozen=True)
class ParticleLayer:
    """Particles of given mean diameter and density on a surface; fields share one shape.

    ``factor`` pi eta_a p/(H_s1 + H_s2) [m-2 Pa-1] multiplies a second moment and a hardness.
    """

    mean: np.ndarray  # m [m]
    spread: np.ndarray  # S [m]
    tail: np.ndarray  # c_1 [m2]
    constant: np.ndarray  # c_2 [m2]
    linear: np.ndarray  # c_3 [m2]
    depth: np.ndarray  # h_e/S [1]
    factor: np.ndarray
    parameters: Parameters

    @classmethod
    def of(cls, diameter, roughness, density, parameters: Parameters) -> ParticleLayer:
        """Layer of particles: ``diameter`` x_a [m], ``density`` eta_a [m-2], ``roughness`` [m].

        Arrays of one shape, ``diameter`` and ``density`` positive.
        """
        law = SIZE_DISTRIBUTIONS[parameters.size_distribution]
        mean, spread, tail, constant, linear = law(diameter, roughness, parameters)
        hardness = parameters.hardness_surface_1 + parameters.hardness_surface_2
        factor = np.pi * density * parameters.participation / hardness
        depth = parameters.elastic_depth_ratio * diameter / spread
        return cls(mean, spread, tail, constant, linear, depth, factor, parameters)

    def take(self, chosen) -> ParticleLayer:
        """The layer at the points that an index or mask ``chosen`` picks."""
        columns = {
            field.name: getattr(self, field.name)[chosen]
            for field in fields(self)
            if field.name != "parameters"
        }
        return ParticleLayer(**columns, parameters=self.parameters)

    @property
    def reach(self):
        """Separation [m] beyond which no particle touches: X_max + h_e."""
        return self.mean + (self.parameters.truncation + self.depth) * self.spread

    def _moment(self, alpha):
        """T(alpha) and dT/dalpha [m2], with alpha held below the truncation."""
        below = alpha < self.parameters.truncation
        alpha = np.minimum(alpha, self.parameters.truncation)
        phi = INV_SQRT_2PI * np.exp(-0.5 * alpha**2)
        polynomial = self.constant + self.linear * alpha
        value = self.tail * ndtr(-alpha) + polynomial * phi
        slope = -phi * (self.tail - self.linear + polynomial * alpha)
        return value, np.where(below, slope, 0.0)

    def _largest(self):
        """T at X_max [m2]."""
        return self._moment(np.full_like(self.spread, self.parameters.truncation))[0]

    def area(self, separation):
        """A_sa/A_n [1] at ``separation`` d [m] and its slope d/dd [m-1] (Eq. 5)."""
        alpha = (separation - self.mean) / self.spread
        limits = ELASTIC_LIMITS[self.parameters.elastic_limits](alpha, self.depth)
        (low, low_slope), (high, high_slope) = (self._moment(limit) for limit in limits)
        beyond, beyond_slope = (low, low_slope) if limits[0] is alpha else (high, high_slope)
        elastic = self.parameters.elastic_factor
        factor = self.factor * self.parameters.hardness_surface_2
        value = factor * (elastic * (low - high) + (beyond - self._largest()))
        slope = factor * (elastic * (low_slope - high_slope) + beyond_slope) / self.spread
        return value, slope

    def contact_coverage(self, separation):
        """Share of the interface under particles above ``separation`` [1], slope [m-1] (Eq. 5)."""
        value, slope = self._moment((separation - self.mean) / self.spread)
        factor = self.factor * self.parameters.hardness_surface_1
        return factor * (value - self._largest()), factor * slope / self.spread

    def total_coverage(self):
        """Share of the interface under particles of all sizes, X_min = 0 to X_max [1] (Eq. 4)."""
        factor = self.factor * self.parameters.hardness_surface_1
        if self.parameters.size_distribution == "gap_convolved":
            return factor * self.tail
        return factor * (self._moment(-self.mean / self.spread)[0] - self._largest())

    def load_coverage(self, separation):
        """Coverage that Eq. 4 takes off the load of the summits, and its slope [m-1]."""
        if self.parameters.coverage_limits == "contacting":
            return self.contact_coverage(separation)
        total = self.total_coverage()
        return total, np.zeros_like(total)
