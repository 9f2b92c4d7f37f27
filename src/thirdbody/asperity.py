"""Rough surface against rough surface: one asperity, then a Gaussian population of summits.

Source: Zhao, Maietta & Chang (2000), J. Tribol. 122:86; the paper takes F_ss and A_ss from it.
Lengths of the population are in units of the summits' standard deviation: t = (d - y_s)/sigma_s
is the separation from the summit plane, w = omega/sigma_s an interference.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.special import erfcx

from thirdbody.parameters import Parameters, Surface

# Summits whose weight is below exp(-NEGLIGIBLE) of the largest do not matter in float64.
NEGLIGIBLE = 40.0
SQRT_2PI = np.sqrt(2.0 * np.pi)


def asperity_load_and_area(interference, radius, modulus, hardness, yield_ratio, plastic_ratio):
    """Load [N] and area [m2] of one asperity pressed by ``interference`` omega [m].

    ``interference`` broadcasts with ``radius`` R [m]; ``modulus`` E [Pa], ``hardness`` H [Pa],
    ``yield_ratio`` k [1] and ``plastic_ratio`` omega_2/omega_1 [1] are scalars.  An asperity out
    of contact (omega <= 0) gives zero.  Source: Zhao, Maietta & Chang (2000).
    """
    omega = np.maximum(interference, 0.0)
    omega_1 = (0.75 * np.pi * yield_ratio * hardness / modulus) ** 2 * radius
    ratio = omega / omega_1
    pressure = hardness * pressure_fraction(ratio, yield_ratio, plastic_ratio)
    area = np.pi * radius * omega * area_growth(ratio, plastic_ratio)
    elastic = omega < omega_1
    hertz = 4.0 / 3.0 * modulus * np.sqrt(radius) * omega**1.5
    return np.where(elastic, hertz, area * pressure), area


def area_growth(ratio, plastic_ratio):
    """A/(pi R omega) at interference ``ratio`` = omega/omega_1: 1 elastic, 2 plastic."""
    if plastic_ratio == 1.0:
        return np.where(ratio > 1.0, 2.0, 1.0)
    u = np.clip((ratio - 1.0) / (plastic_ratio - 1.0), 0.0, 1.0)
    return 1.0 - 2.0 * u**3 + 3.0 * u**2


def pressure_fraction(ratio, yield_ratio, plastic_ratio):
    """F/(A H) at interference ``ratio`` = omega/omega_1 from first yield on: k, at last 1."""
    if plastic_ratio == 1.0:
        return np.where(ratio > 1.0, 1.0, yield_ratio)
    within = np.clip(ratio, 1.0, plastic_ratio)
    return yield_ratio + (1.0 - yield_ratio) * np.log(within) / np.log(plastic_ratio)


@dataclass(frozen=True)
class SummitPopulation:
    """Load and area of a Gaussian population of equal summits, per nominal area.

    ``log_load(t)`` is ln(F_ss/(A_n E_ss)), ``log_area(t)`` is ln(A_ss/A_n); each returns the
    value and its slope d/dt, both of the shape of ``t``, by Gauss-Legendre quadrature over the
    elastic and elastoplastic summits and in closed form over the plastic ones.
    """

    summit_parameter: float  # eta_s R sigma_s
    sharpness: float  # sigma_s/R
    hardness_ratio: float  # H/E_ss
    yield_ratio: float  # k
    plastic_ratio: float  # omega_2/omega_1

    @classmethod
    def of(cls, surface: Surface, parameters: Parameters) -> SummitPopulation:
        """The population that ``surface`` and the materials describe."""
        return cls(
            surface.summit_density * surface.summit_radius * surface.summit_deviation,
            surface.summit_deviation / surface.summit_radius,
            parameters.hardness_surface_2 / parameters.elastic_modulus_surfaces,
            parameters.yield_pressure_ratio,
            parameters.plastic_interference_ratio,
        )

    @property
    def yield_interference(self) -> float:
        """w_1 = omega_1/sigma_s [1]."""
        return (0.75 * np.pi * self.yield_ratio * self.hardness_ratio) ** 2 / self.sharpness

    def log_load(self, t):
        """ln(F_ss/(A_n E_ss)) and its slope at summit separations ``t`` [1]."""
        return self._logarithm(t, *self._load_weights)

    def log_area(self, t):
        """ln(A_ss/A_n) and its slope at summit separations ``t`` [1]."""
        return self._logarithm(t, *self._area_weights)

    @cached_property
    def _load_weights(self):
        """Elastic w^1.5, elastoplastic and plastic factors of the load."""
        hertz = 4.0 / 3.0 * self.summit_parameter * np.sqrt(self.sharpness)
        full = np.pi * self.summit_parameter * self.hardness_ratio

        def elastoplastic(ratio):
            return (
                full
                * area_growth(ratio, self.plastic_ratio)
                * pressure_fraction(ratio, self.yield_ratio, self.plastic_ratio)
            )

        return hertz, 1.5, elastoplastic, 2.0 * full

    @cached_property
    def _area_weights(self):
        """Elastic w, elastoplastic and plastic factors of the area."""
        full = np.pi * self.summit_parameter
        return full, 1.0, lambda r: full * area_growth(r, self.plastic_ratio), 2.0 * full

    def _logarithm(self, t, elastic, power, elastoplastic, plastic):
        """ln of the summed contributions and its slope; all sums carry exp(max(t, 0)^2/2)."""
        t = np.asarray(t, dtype=float)
        reach = np.where(  # beyond it the summits' weight is negligible
            t > 0.0,
            2.0 * NEGLIGIBLE / (np.abs(t) + np.hypot(t, np.sqrt(2.0 * NEGLIGIBLE))),
            np.sqrt(2.0 * NEGLIGIBLE) - t,
        )
        w_1 = self.yield_interference
        w_2 = w_1 * self.plastic_ratio
        total, slope = _elastic_sum(t, np.minimum(w_1, reach), elastic, power)
        for part in (
            _elastoplastic_sum(t, w_1, np.clip(reach, w_1, w_2), elastoplastic),
            _plastic_sum(t, w_2, plastic),
        ):
            total = total + part[0]
            slope = slope + part[1]
        total = np.maximum(total, np.finfo(float).tiny)
        return np.log(total / SQRT_2PI) - 0.5 * np.maximum(t, 0.0) ** 2, slope / total


def _weight(t, w):
    """exp(-(t+w)^2/2) over exp(-max(t, 0)^2/2), without cancellation for t > 0."""
    return np.exp(-w * (t + 0.5 * w) - 0.5 * np.minimum(t, 0.0) ** 2)


def _gauss_legendre(count):
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return 0.5 * (nodes + 1.0), 0.5 * weights


# Errors below 1e-12 for t > -LOWEST and any material; half of the nodes would do for t > 0.
ELASTIC_NODES = _gauss_legendre(48)
ELASTOPLASTIC_NODES = _gauss_legendre(48)


def _elastic_sum(t, end, factor, power):
    """factor * integral of w^power over w in (0, end); w = end u^2 makes half powers smooth."""
    u, weights = ELASTIC_NODES
    w = end[..., None] * u**2
    terms = 2.0 * u * weights * w**power * _weight(t[..., None], w)
    scale = factor * end
    return scale * terms.sum(-1), -scale * (terms * (t[..., None] + w)).sum(-1)


def _elastoplastic_sum(t, start, end, factor):
    """Integral of factor(w/start) w over w in (start, end); w = v^2 evens out the logarithm."""
    u, weights = ELASTOPLASTIC_NODES
    root = np.sqrt(start) + (np.sqrt(end) - np.sqrt(start))[..., None] * u
    w = root**2
    width = np.sqrt(end) - np.sqrt(start)
    terms = 2.0 * weights * root * w * factor(w / start) * _weight(t[..., None], w)
    return width * terms.sum(-1), -width * (terms * (t[..., None] + w)).sum(-1)


def _plastic_sum(t, start, factor):
    """factor * integral of w over w above start: phi(t+start) - t Q(t+start)."""
    tail = t + start
    phi = _weight(t, start)
    beyond = phi * np.sqrt(0.5 * np.pi) * erfcx(tail / np.sqrt(2.0))
    return factor * (phi - t * beyond), -factor * (start * phi + beyond)
