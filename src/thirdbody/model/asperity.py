"""Rough surface against rough surface: one asperity, then a Gaussian population of summits.

The paper takes F_ss and A_ss from Zhao, Maietta & Chang (2000), J. Tribol. 122:86.  An asperity
pressed by omega yields first at omega_1 and is fully plastic from omega_2 on; the interface has
eta_s summits in a square metre, whose heights z are normal (first half of Eq. 6):

    F_ss/A_n = eta_s * integral of F(omega) phi(z),   A_ss/A_n = eta_s * integral of A(omega) phi(z)

over all z above d, with omega = z - d and both heights counted from the plane of the summits.  In
units of their standard deviation, the population is a function of the separation
t = (d - y_s)/sigma_s alone; an interference is w = omega/sigma_s there.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
import scipy  # of which special is loaded when it is first used: many jobs never do
from numpy.typing import ArrayLike, NDArray

from thirdbody.model.computed_once import computed_once
from thirdbody.model.parameters import Parameters, Surface

# Summits whose weight is below exp(-NEGLIGIBLE) of the largest do not matter in float64.
NEGLIGIBLE = 40.0
SQRT_2PI = np.sqrt(2.0 * np.pi)


def asperity_load_and_area(
    interference: ArrayLike,
    radius: ArrayLike,
    modulus: float,
    hardness: float,
    yield_ratio: float,
    plastic_ratio: float,
) -> tuple[NDArray, NDArray]:
    """Load and contact area of one asperity.

    Parameters
    ----------
    interference, radius : array_like
        omega and R [m], which broadcast.
    modulus, hardness : float
        E and H [Pa].
    yield_ratio : float
        k [1]: mean pressure at first yield over the hardness.
    plastic_ratio : float
        omega_2/omega_1 [1], at least 1.

    Returns
    -------
    load, area : array
        F [N] and A [m2], zero where the asperity is out of contact (omega <= 0).

    References
    ----------
    Zhao, Maietta & Chang (2000), J. Tribol. 122:86.

    Examples
    --------
    A fully plastic asperity bears its hardness on twice the area of an elastic one.

    >>> import math
    >>> load, area = asperity_load_and_area(1e-5, 30e-6, 112e9, 5e9, 0.4, 54.0)
    >>> round(float(load / area / 5e9), 12), round(float(area / (math.pi * 30e-6 * 1e-5)), 12)
    (1.0, 2.0)
    """
    omega = np.maximum(interference, 0.0)
    omega_1 = (0.75 * np.pi * yield_ratio * hardness / modulus) ** 2 * radius
    ratio = omega / omega_1
    pressure = hardness * pressure_fraction(ratio, yield_ratio, plastic_ratio)
    area = np.pi * radius * omega * area_growth(ratio, plastic_ratio)
    elastic = omega < omega_1
    hertz = 4.0 / 3.0 * modulus * np.sqrt(radius) * omega**1.5
    return np.where(elastic, hertz, area * pressure), area


def area_growth(ratio: ArrayLike, plastic_ratio: float) -> NDArray:
    """A/(pi R omega) [1] of an asperity: 1 while elastic, 2 when fully plastic.

    ``ratio`` is omega/omega_1 [1], ``plastic_ratio`` omega_2/omega_1 [1].
    """
    if plastic_ratio == 1.0:
        return np.where(ratio > 1.0, 2.0, 1.0)
    u = np.clip((ratio - 1.0) / (plastic_ratio - 1.0), 0.0, 1.0)
    return 1.0 + u * u * (3.0 - 2.0 * u)


def pressure_fraction(ratio: ArrayLike, yield_ratio: float, plastic_ratio: float) -> NDArray:
    """F/(A H) [1] of an asperity that yields: k at first yield, 1 when fully plastic.

    ``ratio`` is omega/omega_1 [1], ``yield_ratio`` k [1], ``plastic_ratio`` omega_2/omega_1 [1].
    """
    if plastic_ratio == 1.0:
        return np.where(ratio > 1.0, 1.0, yield_ratio)
    within = np.clip(ratio, 1.0, plastic_ratio)
    return yield_ratio + (1.0 - yield_ratio) * np.log(within) / np.log(plastic_ratio)


class Weights(NamedTuple):
    """What a summit of interference w contributes to a load or an area.

    ``elastic`` w^``power`` up to w_1, then ``elastoplastic``(w/w_1, growth of the area) w, and
    ``plastic`` w from w_2 on.
    """

    elastic: float
    power: float
    elastoplastic: Callable
    plastic: float


@dataclass(frozen=True)
class SummitPopulation:
    """Load and area of a Gaussian population of equal summits, per apparent area.

    The first two fields are scalars, or arrays with a population for each point.
    ``SummitPopulation.of`` makes the population of a surface.

    Attributes
    ----------
    summit_parameter : float or array
        eta_s R sigma_s [1].
    sharpness : float or array
        sigma_s/R [1].
    hardness_ratio : float
        H/E_ss [1].
    yield_ratio, plastic_ratio : float
        k and omega_2/omega_1 [1].

    Notes
    -----
    Elastic and elastoplastic summits are summed by Gauss-Legendre quadrature, plastic ones in
    closed form.

    Examples
    --------
    >>> import thirdbody
    >>> parameters = thirdbody.load_parameters()
    >>> summits = SummitPopulation.of(parameters.surface(300e-9), parameters)
    >>> log_load, slope = summits.log_load([0.0, 3.0, 100.0])
    >>> bool((slope < 0.0).all()), bool(log_load[2] < -5000.0)
    (True, True)
    """

    summit_parameter: float | NDArray
    sharpness: float | NDArray
    hardness_ratio: float
    yield_ratio: float
    plastic_ratio: float

    @classmethod
    def of(cls, surface: Surface, parameters: Parameters) -> SummitPopulation:
        """The population that ``surface`` and the materials describe."""
        return cls(
            surface.summit_density * surface.summit_radius * surface.summit_deviation,
            surface.summit_deviation / surface.summit_radius,
            parameters.softer_hardness / parameters.elastic_modulus_surfaces,
            parameters.yield_pressure_ratio,
            parameters.plastic_interference_ratio,
        )

    @classmethod
    def of_unit(cls, yield_interference: float | NDArray, materials: tuple) -> SummitPopulation:
        """The population of w_1 [1] whose eta_s R sigma_s is 1.

        ``materials`` are the last three fields.  Loads and areas of any population are eta_s R sigma_s
        times those of one such, which depend on w_1 and t alone.
        """
        unit = cls(1.0, 1.0, *materials)
        return replace(unit, sharpness=unit.yield_interference / yield_interference)

    @property
    def materials(self) -> tuple[float, float, float]:
        """H/E_ss, k and omega_2/omega_1 [1]."""
        return self.hardness_ratio, self.yield_ratio, self.plastic_ratio

    @property
    def yield_interference(self) -> float | NDArray:
        """w_1 = omega_1/sigma_s [1]."""
        return (0.75 * np.pi * self.yield_ratio * self.hardness_ratio) ** 2 / self.sharpness

    def log_load(self, t: ArrayLike) -> tuple[NDArray, NDArray]:
        """Load of all summits.

        Parameters
        ----------
        t : array_like
            Separation (d - y_s)/sigma_s [1], of the shape of the points.

        Returns
        -------
        log_load, slope : array
            ln(F_ss/(A_n E_ss)) and its derivative by t [1].
        """
        return self._logarithms(t, self._load_weights)[0]

    def log_area(self, t: ArrayLike) -> tuple[NDArray, NDArray]:
        """Contact area of all summits.

        Parameters
        ----------
        t : array_like
            Separation (d - y_s)/sigma_s [1], of the shape of the points.

        Returns
        -------
        log_area, slope : array
            ln(A_ss/A_n) and its derivative by t [1].
        """
        return self._logarithms(t, self._area_weights)[0]

    def log_load_and_area(self, t: ArrayLike) -> list[tuple[NDArray, NDArray]]:
        """What ``log_load`` and ``log_area`` return, for little more than one of them costs."""
        return self._logarithms(t, self._load_weights, self._area_weights)

    @computed_once
    def _load_weights(self) -> Weights:
        hertz = 4.0 / 3.0 * self.summit_parameter * np.sqrt(self.sharpness)
        full = np.pi * self.summit_parameter * self.hardness_ratio

        def elastoplastic(ratio, growth):
            pressure = pressure_fraction(ratio, self.yield_ratio, self.plastic_ratio)
            return _over_nodes(full) * growth * pressure

        return Weights(hertz, 1.5, elastoplastic, 2.0 * full)

    @computed_once
    def _area_weights(self) -> Weights:
        full = np.pi * self.summit_parameter
        return Weights(full, 1.0, lambda ratio, growth: _over_nodes(full) * growth, 2.0 * full)

    def _logarithms(self, t, *quantities: Weights):
        """ln of the sum over all summits and its slope, of each quantity.

        The largest weight of a summit, exp(-max(t, 0)^2/2), is left out of the sums and enters as a
        logarithm: so a tail far beyond float64 keeps its digits.
        """
        t = np.asarray(t, dtype=float)
        w_1 = self.yield_interference
        w_2 = w_1 * self.plastic_ratio
        reach = _reach(t)
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


def _reach(t):
    """The w beyond which summits' weight is negligible: (t + w)^2 = max(t, 0)^2 + 2 NEGLIGIBLE."""
    return np.where(
        t > 0.0,
        2.0 * NEGLIGIBLE / (np.abs(t) + np.hypot(t, np.sqrt(2.0 * NEGLIGIBLE))),
        np.sqrt(2.0 * NEGLIGIBLE) - t,
    )


def _weight(t, w):
    """exp(-(t+w)^2/2) over its largest value exp(-max(t, 0)^2/2), which cancels nothing for t > 0."""
    return np.exp(-w * (t + 0.5 * w) - 0.5 * np.minimum(t, 0.0) ** 2)


def _over_nodes(values):
    """``values`` of the points, or one for all, with an axis for the nodes of each point."""
    return np.asarray(values)[..., None]


def gauss_legendre(count: int) -> tuple[NDArray, NDArray]:
    """``count`` nodes and weights [1] of the interval from 0 to 1, each 1-D."""
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return 0.5 * (nodes + 1.0), 0.5 * weights


# Errors below 1e-12 for t > -5 and any material; half of the nodes would do for t > 0.
ELASTIC_NODES = gauss_legendre(48)
ELASTOPLASTIC_NODES = gauss_legendre(48)


def _elastic_sums(t, end, quantities):
    """Sum over elastic summits, those of w from 0 to ``end``, and its slope, of each quantity.

    The integral of ``elastic`` w^``power``; w = end u^2 makes half powers smooth.
    """
    u, weights = ELASTIC_NODES
    decay = _weight(_over_nodes(t), _over_nodes(end) * u**2)
    for quantity in quantities:
        measure = 2.0 * weights * u ** (2.0 * quantity.power + 1.0)
        scale = quantity.elastic * end ** (quantity.power + 1.0)
        terms = decay * measure
        total, farther = terms.sum(-1), (terms * u**2).sum(-1)
        yield scale * total, -scale * (t * total + end * farther)


def _elastoplastic_sums(t, start, end, plastic_ratio, quantities):
    """Sum over summits of w from ``start`` w_1 to ``end``, and its slope, of each quantity.

    The integral of ``elastoplastic`` w; w = root^2 evens out the logarithm in the pressure.
    """
    u, weights = ELASTOPLASTIC_NODES
    width = np.sqrt(end) - np.sqrt(start)
    root = _over_nodes(np.sqrt(start)) + _over_nodes(width) * u
    w = root**2
    decay = _weight(_over_nodes(t), w)
    ratio, measure = w / _over_nodes(start), 2.0 * weights * root * w * decay
    growth = area_growth(ratio, plastic_ratio)
    for quantity in quantities:
        terms = measure * quantity.elastoplastic(ratio, growth)
        total, farther = terms.sum(-1), (terms * w).sum(-1)
        yield width * total, -width * (t * total + farther)


def _plastic_sums(t, start, quantities):
    """Sum over plastic summits, those of w above ``start`` w_2, and its slope, of each quantity.

    The integral of ``plastic`` w is phi(t + w_2) - t Q(t + w_2), with phi and Q the density and
    upper tail of the standard normal distribution.
    """
    tail = t + start
    phi = _weight(t, start)
    beyond = phi * np.sqrt(0.5 * np.pi) * scipy.special.erfcx(tail / np.sqrt(2.0))
    for quantity in quantities:
        factor = quantity.plastic
        yield factor * (phi - t * beyond), -factor * (start * phi + beyond)
