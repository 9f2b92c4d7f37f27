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

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.model.parameters import Parameters, Surface

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
    Elastic, elastoplastic and plastic summits are each summed by Gauss-Legendre quadrature.

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

    def take(self, chosen) -> SummitPopulation:
        """The populations of the points that an index or mask ``chosen`` picks."""
        columns = self.summit_parameter[chosen], self.sharpness[chosen]
        return replace(self, summit_parameter=columns[0], sharpness=columns[1])

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
        return self._logarithm(*self._sums(t, False), np.pi * self.hardness_ratio)[:2]

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
        return self._logarithm(*self._sums(t, True), np.pi)[:2]

    def log_load_and_area(self, t: ArrayLike) -> NDArray:
        """ln F_ss* and ln(A_ss/A_n), each with its first two derivatives by ``t``: an array of the
        shape (2, 3, ...)."""
        load = self._logarithm(*self._sums(t, False), np.pi * self.hardness_ratio)
        return np.stack([load, self._logarithm(*self._sums(t, True), np.pi)])

    def _sums(self, t, of_area):
        """max(t, 0), and sums over all summits of A/(pi R sigma_s), or of F/(pi R sigma_s H), times 1, v
        and v^2, where v = w + min(t, 0).

        The largest weight of a summit, exp(-max(t, 0)^2/2), is left out of the sums: so a tail far
        beyond float64 keeps its digits.
        """
        t = np.asarray(t, dtype=float)
        above, below = np.maximum(t, 0.0), np.minimum(t, 0.0)
        w_1 = self.yield_interference
        w_2 = w_1 * self.plastic_ratio
        start = np.maximum(-below - WIDEST, 0.0)
        end = WIDEST**2 / (above + np.hypot(above, WIDEST)) - below
        sums = 0.0
        for law, first, last in (
            (self._elastic, 0.0, w_1),
            (self._elastoplastic, w_1, w_2),
            (self._plastic, w_2, np.inf),
        ):
            # w = root^2 makes half powers smooth
            low = np.sqrt(np.clip(first, start, end))
            width = np.sqrt(np.clip(last, start, end)) - low
            root = low[..., None] + width[..., None] * NODES
            w = root * root
            v = w + below[..., None]
            terms = np.exp(-v * (above[..., None] + 0.5 * v)) * w * root
            terms *= law(w / np.asarray(w_1)[..., None], of_area)
            powers = np.stack([np.ones_like(v), v, v * v])
            sums = sums + 2.0 * width * np.einsum("...i,k...i,i->k...", terms, powers, WEIGHTS)
        return above, sums

    def softness(self, ratio: ArrayLike) -> NDArray:
        """F/(pi R omega H) [1] of a summit at omega/omega_1 = ``ratio`` [1]."""
        yielding = area_growth(ratio, self.plastic_ratio)
        yielding = yielding * pressure_fraction(ratio, self.yield_ratio, self.plastic_ratio)
        return np.where(ratio < 1.0, self.yield_ratio * np.sqrt(ratio), yielding)

    def _elastic(self, ratio, of_area):
        """A/(pi R omega), or F/(pi R omega H), at omega/omega_1 up to 1."""
        return 1.0 if of_area else self.yield_ratio * np.sqrt(ratio)

    def _elastoplastic(self, ratio, of_area):
        growth = area_growth(ratio, self.plastic_ratio)
        if of_area:
            return growth
        return growth * pressure_fraction(ratio, self.yield_ratio, self.plastic_ratio)

    def _plastic(self, ratio, of_area):
        return 2.0

    def _logarithm(self, above, sums, unit):
        """ln of the ``sums`` in a ``unit`` of eta_s R sigma_s, and its first two derivatives by t."""
        total = np.maximum(sums[0], np.finfo(float).tiny)
        mean, square = sums[1] / total, sums[2] / total
        value = np.log(total * (unit / SQRT_2PI)) + np.log(self.summit_parameter)
        return value - 0.5 * above**2, -(above + mean), square - mean**2 - 1.0


def gauss_legendre(count: int) -> tuple[NDArray, NDArray]:
    """``count`` nodes and weights [1] of the interval from 0 to 1, each 1-D."""
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return 0.5 * (nodes + 1.0), 0.5 * weights


# Errors of ln F_ss and ln A_ss are below 1e-12 for any material.
NODES, WEIGHTS = gauss_legendre(48)
# Summits whose weight is below exp(-40) of the largest do not matter in float64: in v beyond this.
WIDEST = np.sqrt(2.0 * 40.0)
