"""Central film thickness of rough line and point contacts (Eqs. 7 and 8), and its validity.

Eq. 7, with sigma* = sigma/R_x, is the film thickness of smooth bodies times a roughness factor:

    H_c = 3.672 W^(-0.045 kappa^0.18) U^(0.663 kappa^0.025) G^(0.502 kappa^0.064)
              (1 - 0.573 e^(-0.74 kappa))
          (1 + 0.025 sigma*^1.248 V^0.119 W^-0.133 U^-0.884 G^-0.977 kappa^0.081)

The logarithm of each of the two terms is a sum of logarithms, linear in ln W.

Source: Masjedi & Khonsari (2015).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
import scipy  # scipy.special is loaded on first use: many jobs do not need it
from numpy.typing import NDArray

from thirdbody.core.interpolation import HermiteTable
from thirdbody.core.logarithms import EPSILON
from thirdbody.core.parameters import Number, Parameters

# Exponents in the roughness term of Eq. 7: of sigma* and V, and, with a minus sign, of W, U and G.
# The code uses them more than once.  All other numbers of Eq. 7 are in ``Film.of``.
ROUGH_SIGMA, ROUGH_V = 1.248, 0.119
ROUGH_W, ROUGH_U, ROUGH_G = 0.133, 0.884, 0.977
THICKEST = 0.01  # H_c above which Eq. 7 does not describe a film between two bodies
# rounding of a thickness, in EPSILON: a constant, and a factor of the size of the logarithms
ROUNDINGS, ROUNDINGS_PER_SIZE = 8.0, 1.75
INVERSE_STEPS = 6  # of Newton's method: from an error of a factor of 2 in thickness to rounding
# table of the inverse of Eq. 7: range of ln H_c, number of pieces, and error of ln W
INVERSE_RANGE, INVERSE_PIECES, INVERSE_ERROR = (-6.0, 14.0), 2400, 1e-13


def log_load_parameter(log_load: Number, parameters: Parameters) -> Number:
    """ln W [1] for ln F* [1], where W = F/(E_ss R_x^2) (Eq. 8) and F* = F/(A_n E_ss)."""
    return log_load + math.log(parameters.apparent_area / parameters.ball_radius**2)


def has_film(viscosity: NDArray) -> NDArray:
    """Whether there is a film: a kinematic ``viscosity`` [m2/s] of 0 is dry contact."""
    return viscosity > 0.0


def load_of_film(
    separation: NDArray, viscosity: NDArray, roughness: float | NDArray, parameters: Parameters
) -> tuple[NDArray, NDArray]:
    """The load F* [1] of a film as thick as the separation (Eqs. 7 and 8), and d ln F*/dd [m-1].

    Parameters
    ----------
    separation, viscosity : array
        d [m] and nu [m2/s], of shapes that broadcast.
    roughness : array or float
        sigma [m], for each film or for all.
    parameters : Parameters
        Inputs of the model.

    Returns
    -------
    load, slope : array
        Both 0 where there is no film.
    """
    wet = has_film(viscosity)
    film = Film.of(np.where(wet, viscosity, 1.0), roughness, parameters)
    log_parameter, slope = film.log_W_and_slope(separation / parameters.ball_radius)
    load = np.exp(log_parameter - log_load_parameter(0.0, parameters))
    return np.where(wet, load, 0.0), np.where(wet, slope / separation, 0.0)


def film_parameter(
    load: float | NDArray, viscosity: NDArray, roughness: float | NDArray, parameters: Parameters
) -> NDArray:
    """lambda = h_c/sigma [1], with the film of smooth bodies that carries the whole load (Eq. 7).

    H_c of a solution, times R_x over sigma, is another number: the gap that solids hold open too.

    Parameters
    ----------
    load, viscosity, roughness : array or float
        F_t* [1], nu [m2/s] and sigma [m], of shapes that broadcast.
    parameters : Parameters
        Inputs of the model.

    Returns
    -------
    array
        0 where there is no film.

    Examples
    --------
    >>> import thirdbody
    >>> inputs = thirdbody.load_parameters().best
    >>> load, oils = 10.0 / inputs.newtons_per_load, np.array([0.0, 90e-6])
    >>> film_parameter(load, oils, 3e-7, inputs).round(2)
    array([0. , 2.9])
    """
    wet = has_film(viscosity)
    film = Film.of(np.where(wet, viscosity, 1.0), roughness, parameters)
    log_thickness = film.smooth + film.exponents[0] * log_load_parameter(np.log(load), parameters)
    return np.where(wet, np.exp(log_thickness) * parameters.ball_radius / roughness, 0.0)


@dataclass(frozen=True)
class Film:
    """Eq. 7 as a function of the load parameter: H_c = e^(s + a ln W) + e^(r + b ln W).

    The first term is the smooth film, the second the smooth film times the roughness term of Eq. 7.
    ``smooth`` and ``rough`` are s and r, with an element per point.  ``exponents`` are a and b.

    Rounding grows with ``smooth_size``, the sum of the absolute logarithms in s, and with
    ``rough_size``, the sum of the absolute logarithms that r adds.  ``turning_ratio`` is the second
    term over the first at the speed U with the least H_c.  At ``greatest_log_W`` the mean film
    pressure is the softer hardness; Eq. 7 assumes elastic bodies.  All fields are dimensionless.
    """

    smooth: NDArray
    rough: NDArray
    smooth_size: NDArray
    rough_size: NDArray
    exponents: tuple[float, float]
    turning_ratio: float
    greatest_log_W: float

    @classmethod
    def of(cls, viscosity: NDArray, roughness: float | NDArray, parameters: Parameters) -> Film:
        """The film for nu [m2/s], positive, and sigma [m], a scalar or of the same shape.

        Examples
        --------
        >>> import numpy as np, thirdbody
        >>> film = Film.of(np.array([120e-6]), 300e-9, thirdbody.load_parameters().best)
        >>> thickness, slope = film.thickness(np.log(1e-6))
        >>> f"{thickness[0]:.3e}"
        '1.783e-04'
        >>> film.log_W_and_slope(thickness)[0]
        array([-13.81551056])
        """
        kappa = parameters.ellipticity
        ln_G = math.log(parameters.material_parameter)
        ln_V = math.log(parameters.hardness_parameter)
        ln_U_per_nu, ln_nu = math.log(parameters.speed_per_viscosity), np.log(viscosity)
        # Eq. 8 with mu_0 = rho nu
        ln_U, ln_sigma = ln_U_per_nu + ln_nu, np.log(roughness / parameters.ball_radius)
        of_W, of_U, of_G = -0.045 * kappa**0.18, 0.663 * kappa**0.025, 0.502 * kappa**0.064
        # Eq. 7 without the powers of W
        smooth = math.log(3.672 * (1.0 - 0.573 * math.exp(-0.74 * kappa)))
        smooth = smooth + of_U * ln_U + of_G * ln_G
        ln_term = math.log(0.025 * kappa**0.081) + ROUGH_SIGMA * ln_sigma + ROUGH_V * ln_V
        ln_term = ln_term - ROUGH_U * ln_U - ROUGH_G * ln_G
        size_U = abs(ln_U_per_nu) + np.abs(ln_nu)
        rough_size = ROUGH_U * size_U + ROUGH_SIGMA * np.abs(ln_sigma) + ROUGH_V * abs(ln_V)
        # F_f* at which the mean pressure F_f/A_n is the softer hardness
        softer = parameters.softer_hardness / parameters.elastic_modulus_surfaces
        return cls(
            smooth=smooth,
            rough=smooth + ln_term,
            smooth_size=of_U * size_U + of_G * abs(ln_G),
            rough_size=rough_size + ROUGH_G * abs(ln_G),
            exponents=(of_W, of_W - ROUGH_W),
            turning_ratio=of_U / (ROUGH_U - of_U),
            greatest_log_W=log_load_parameter(math.log(softer), parameters),
        )

    def take(self, chosen) -> Film:
        """The film at the points selected by an index or mask ``chosen``."""
        return replace(
            self,
            smooth=self.smooth[chosen],
            rough=self.rough[chosen],
            smooth_size=self.smooth_size[chosen],
            rough_size=self.rough_size[chosen],
        )

    def thickness(self, log_W: float | NDArray) -> tuple[NDArray, NDArray]:
        """H_c [1] (Eq. 7) and dH_c/d ln W [1] at ln W [1], a scalar or an element per point."""
        a, b = self.exponents
        smooth = np.exp(self.smooth + a * log_W)
        rough = np.exp(self.rough + b * log_W)
        return smooth + rough, a * smooth + b * rough  # Eq. 7

    def rounding(self, log_W: float | NDArray, slope: float | NDArray) -> NDArray:
        """Relative rounding error [1] of H_c at ln W [1]; ``slope`` is d ln H_c/d ln W [1].

        H_c is an exponential of logarithms, so that the error grows with their size.
        """
        a, b = self.exponents
        rough_share = (slope - a) / (b - a)  # the second term over H_c
        size = self.smooth_size + rough_share * self.rough_size + np.abs(slope * log_W)
        return EPSILON * (ROUNDINGS + ROUNDINGS_PER_SIZE * size)

    def log_W_and_slope(self, thickness: float | NDArray) -> tuple[NDArray, NDArray]:
        """The inverse of Eq. 7: ln W [1] at a positive ``thickness`` H_c [1], and d ln W/d ln H_c
        [1].

        Relative to the point where both terms of Eq. 7 are equal, all films of the same ellipticity
        have the same curve.  This curve is tabulated.
        """
        a, b = self.exponents
        log_parameter = (self.smooth - self.rough) / (b - a)  # where both terms are equal
        log_thickness = self.smooth + a * log_parameter
        table = _inverse_table(*self.exponents)
        x = np.log(thickness) - log_thickness
        inside = table.covers(x)
        if inside.all():
            value, slope = table(x)
        else:
            value, slope = np.where(inside, table(np.where(inside, x, 0.0)), 0.0)
            value[~inside], slope[~inside] = _inverse(x[~inside], *self.exponents)[:2]
        return value + log_parameter, slope

    def is_meaningful(self, log_W: float | NDArray) -> NDArray:
        """Whether H_c increases with viscosity at ln W [1], and the surfaces can carry the film.

        As U goes to zero, H_c of Eq. 7 grows without bound.  Eq. 7 is not valid where dH_c/dU < 0;
        at kappa = 1 the roughness term there exceeds 3.
        """
        a, b = self.exponents
        turning = (np.log(self.turning_ratio) + self.smooth - self.rough) / (b - a)
        return (log_W > turning) & (log_W <= self.greatest_log_W)


def _inverse(x, a, b):
    """The solution y of e^x = e^(a y) + e^(b y), and its first two derivatives.

    Newton's method is applied to the logarithm.  It starts where a single term equals e^x, so that
    it cannot overshoot.
    """
    y = np.maximum(x / a, x / b)
    for _ in range(INVERSE_STEPS):
        y = y - (np.logaddexp(a * y, b * y) - x) / (b + (a - b) * scipy.special.expit((a - b) * y))
    rough_share = scipy.special.expit((b - a) * y)  # the second term over the sum
    slope = 1.0 / (a + (b - a) * rough_share)
    return y, slope, -rough_share * (1.0 - rough_share) * (b - a) ** 2 * slope**3


@lru_cache(maxsize=64)
def _inverse_table(a, b):
    """A table of ``_inverse`` for the exponents of one ellipticity."""
    return HermiteTable(lambda x: np.stack(_inverse(x, a, b))[None], *INVERSE_RANGE, INVERSE_PIECES)
