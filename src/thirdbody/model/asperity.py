"""Rough surface against rough surface: one asperity, then a Gaussian population of summits.

Source: Zhao, Maietta & Chang (2000), J. Tribol. 122:86; the paper takes F_ss and A_ss from it.
Lengths of the population are in units of the summits' standard deviation: t = (d - y_s)/sigma_s
is the separation from the summit plane, w = omega/sigma_s an interference.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from scipy.special import erfcx

from thirdbody.model.parameters import Parameters, Surface

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


class Weights(NamedTuple):
    """What summits of interference w contribute to a quantity: ``elastic`` w^``power``, then
    ``elastoplastic``(w/w_1, growth of the area) w, at last ``plastic`` w."""

    elastic: float
    power: float
    elastoplastic: Callable
    plastic: float


@dataclass(frozen=True)
class SummitPopulation:
    """Load and area of a Gaussian population of equal summits, per nominal area, or of one for
    each point: the first two fields are then arrays.

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
        return self._logarithms(t, self._load_weights)[0]

    def log_area(self, t):
        """ln(A_ss/A_n) and its slope at summit separations ``t`` [1]."""
        return self._logarithms(t, self._area_weights)[0]

    def log_load_and_area(self, t):
        """What ``log_load`` and ``log_area`` return, for little more than one of them costs."""
        return self._logarithms(t, self._load_weights, self._area_weights)

    @cached_property
    def _load_weights(self) -> Weights:
        hertz = 4.0 / 3.0 * self.summit_parameter * np.sqrt(self.sharpness)
        full = np.pi * self.summit_parameter * self.hardness_ratio

        def elastoplastic(ratio, growth):
            pressure = pressure_fraction(ratio, self.yield_ratio, self.plastic_ratio)
            return _over_nodes(full) * growth * pressure

        return Weights(hertz, 1.5, elastoplastic, 2.0 * full)

    @cached_property
    def _area_weights(self) -> Weights:
        full = np.pi * self.summit_parameter
        return Weights(full, 1.0, lambda ratio, growth: _over_nodes(full) * growth, 2.0 * full)

    def _logarithms(self, t, *quantities: Weights):
        """ln of the summed contributions to each quantity and its slope; all sums carry
        exp(max(t, 0)^2/2)."""
        t = np.asarray(t, dtype=float)
        reach = np.where(  # beyond it the summits' weight is negligible
            t > 0.0,
            2.0 * NEGLIGIBLE / (np.abs(t) + np.hypot(t, np.sqrt(2.0 * NEGLIGIBLE))),
            np.sqrt(2.0 * NEGLIGIBLE) - t,
        )
        w_1 = self.yield_interference
        w_2 = w_1 * self.plastic_ratio
        elastic = _elastic_sums(t, np.minimum(w_1, reach), quantities)
        between = _elastoplastic_sums(
            t, w_1, np.clip(reach, w_1, w_2), self.plastic_ratio, quantities
        )
        plastic = _plastic_sums(t, w_2, quantities)
        found = []
        for parts in zip(elastic, between, plastic, strict=True):
            total, slope = map(sum, zip(*parts, strict=True))
            total = np.maximum(total, np.finfo(float).tiny)
            value = np.log(total / SQRT_2PI) - 0.5 * np.maximum(t, 0.0) ** 2
            found.append((value, slope / total))
        return found


def _weight(t, w):
    """exp(-(t+w)^2/2) over exp(-max(t, 0)^2/2), without cancellation for t > 0."""
    return np.exp(-w * (t + 0.5 * w) - 0.5 * np.minimum(t, 0.0) ** 2)


def _over_nodes(values):
    """``values`` of the points, or one for all, to be combined with those at the nodes of each."""
    return np.asarray(values)[..., None]


def _gauss_legendre(count):
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return 0.5 * (nodes + 1.0), 0.5 * weights


# Errors below 1e-12 for t > -LOWEST and any material; half of the nodes would do for t > 0.
ELASTIC_NODES = _gauss_legendre(48)
ELASTOPLASTIC_NODES = _gauss_legendre(48)


def _elastic_sums(t, end, quantities):
    """elastic * integral of w^power over w in (0, end), and its slope, of each quantity;
    w = end u^2 makes half powers smooth."""
    u, weights = ELASTIC_NODES
    w = _over_nodes(end) * u**2
    decay, tail = _weight(_over_nodes(t), w), _over_nodes(t) + w
    for quantity in quantities:
        terms = 2.0 * u * weights * w**quantity.power * decay
        scale = quantity.elastic * end
        yield scale * terms.sum(-1), -scale * (terms * tail).sum(-1)


def _elastoplastic_sums(t, start, end, plastic_ratio, quantities):
    """Integral of elastoplastic * w over w in (start, end), and its slope, of each quantity;
    w = v^2 evens out the logarithm."""
    u, weights = ELASTOPLASTIC_NODES
    width = np.sqrt(end) - np.sqrt(start)
    root = _over_nodes(np.sqrt(start)) + _over_nodes(width) * u
    w = root**2
    decay, tail = _weight(_over_nodes(t), w), _over_nodes(t) + w
    ratio, measure = w / _over_nodes(start), 2.0 * weights * root * w
    growth = area_growth(ratio, plastic_ratio)
    for quantity in quantities:
        terms = measure * quantity.elastoplastic(ratio, growth) * decay
        yield width * terms.sum(-1), -width * (terms * tail).sum(-1)


def _plastic_sums(t, start, quantities):
    """plastic * integral of w over w above start, phi(t+start) - t Q(t+start), and its slope, of
    each quantity."""
    tail = t + start
    phi = _weight(t, start)
    beyond = phi * np.sqrt(0.5 * np.pi) * erfcx(tail / np.sqrt(2.0))
    for quantity in quantities:
        factor = quantity.plastic
        yield factor * (phi - t * beyond), -factor * (start * phi + beyond)
