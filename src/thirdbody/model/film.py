"""Central film thickness of rough line and point contacts (Eqs. 7 and 8), and where it holds.

Eq. 7, with sigma* = sigma/R_x, is the thickness of the film between smooth bodies times what
roughness makes of it:

    H_c = 3.672 W^(-0.045 kappa^0.18) U^(0.663 kappa^0.025) G^(0.502 kappa^0.064)
              (1 - 0.573 e^(-0.74 kappa))
          (1 + 0.025 sigma*^1.248 V^0.119 W^-0.133 U^-0.884 G^-0.977 kappa^0.081)

so that ln H_c of either term is a sum of logarithms, and a straight line over ln W.

Source: Masjedi & Khonsari (2015).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import scipy  # of which special is loaded when it is first used: many jobs never do
from numpy.typing import ArrayLike, NDArray

from thirdbody.model.interpolation import HermiteTable
from thirdbody.model.parameters import Parameters

EPSILON = np.finfo(float).eps
ROUGHNESS_EXPONENT = 1.248  # the power of sigma/R_x in the roughness term,
ROUGHNESS_SPEED_EXPONENT = 0.884  # that of 1/U
ROUGHNESS_LOAD_EXPONENT = -0.133  # and that of W
THICKEST = 0.01  # H_c of what is still a film between two bodies
# of a thickness, in EPSILON: a few, and those of logarithms, exponents and their products
ROUNDINGS, ROUNDINGS_PER_SIZE = 8.0, 1.75
INVERSE_STEPS = 6  # leave nothing of an error that starts below a factor of 2 in thickness
# the table of the inverse of Eq. 7: range in ln H_c, seen from where both terms are equal, and error
INVERSE_RANGE, INVERSE_ERROR = (-6.0, 14.0), 2e-13


def log_load_parameter(log_load: ArrayLike, parameters: Parameters) -> NDArray:
    """ln W [1], W = F/(E_ss R_x^2) (Eq. 8), of a load F.

    Parameters
    ----------
    log_load : array_like
        ln F* [1], F* = F/(A_n E_ss).
    parameters : Parameters
        All inputs of the model.
    """
    return log_load + np.log(parameters.apparent_area / parameters.ball_radius**2)


def greatest_film_load(parameters: Parameters) -> float:
    """F_f* [1] under which a film presses on all of the interface as hard as the softer surface is.

    Eq. 7 is of bodies that yield to a film as elastic ones do: no more than this do they bear of it.
    """
    return parameters.softer_hardness / parameters.elastic_modulus_surfaces


def has_film(viscosity: ArrayLike) -> NDArray:
    """Whether there is a film where the kinematic ``viscosity`` is so much [m2/s]."""
    return viscosity > 0.0


@dataclass(frozen=True)
class Film:
    """Eq. 7 as a function of the load parameter: H_c = e^(s + a ln W) + e^(r + b ln W).

    The first term is the smooth film, the second what roughness adds to it.  ``Film.of`` makes a
    film from viscosity and roughness.

    Attributes
    ----------
    smooth, rough : array
        s and r [1], of the shape of the points.
    smooth_exponent, rough_exponent : float
        a and b [1].
    smooth_size, rough_size : array
        How large the logarithms are together whose sum is s, and those that r adds to it [1]:
        rounding grows with them.
    turning_ratio : float
        Ratio of the second term to the first where H_c is least over the speed U [1].
    greatest : float
        ln W [1] under ``greatest_film_load``.
    """

    smooth: NDArray
    rough: NDArray
    smooth_size: NDArray
    rough_size: NDArray
    smooth_exponent: float
    rough_exponent: float
    turning_ratio: float
    greatest: float

    @classmethod
    def of(cls, viscosity: NDArray, roughness: ArrayLike, parameters: Parameters) -> Film:
        """Make the film of an oil between rough surfaces.

        Parameters
        ----------
        viscosity : array
            Kinematic viscosity nu [m2/s], positive.
        roughness : array_like
            sigma [m], a scalar or of the same shape.
        parameters : Parameters
            All inputs of the model.

        Returns
        -------
        Film

        Examples
        --------
        >>> import numpy as np, thirdbody
        >>> film = Film.of(np.array([120e-6]), 300e-9, thirdbody.load_parameters())
        >>> thickness, slope = film.thickness(np.log(1e-6))
        >>> f"{thickness[0]:.3e}"
        '1.783e-04'
        >>> film.load_parameter(thickness)
        array([-13.81551056])
        """
        law = _law_of(parameters)
        ln_viscosity, ln_sigma = np.log(viscosity), np.log(roughness / parameters.ball_radius)
        ln_U = law.ln_speed + ln_viscosity
        # Eq. 7, all but W of the smooth film
        smooth = law.smooth + law.speed_exponent * ln_U + law.smooth_material
        rough = smooth + (  # Eq. 7, all but W of the roughness term
            law.rough
            + ROUGHNESS_EXPONENT * ln_sigma
            + law.rough_hardness
            - ROUGHNESS_SPEED_EXPONENT * ln_U
            - law.rough_material
        )
        speed_size = abs(law.ln_speed) + np.abs(ln_viscosity)
        materials_size = abs(law.rough_hardness) + abs(law.rough_material)
        return cls(
            smooth,
            rough,
            law.speed_exponent * speed_size + abs(law.smooth_material),
            ROUGHNESS_SPEED_EXPONENT * speed_size
            + (ROUGHNESS_EXPONENT * np.abs(ln_sigma) + materials_size),
            law.load_exponent,
            law.load_exponent + ROUGHNESS_LOAD_EXPONENT,
            law.speed_exponent / (ROUGHNESS_SPEED_EXPONENT - law.speed_exponent),
            law.greatest,
        )

    def take(self, chosen) -> Film:
        """The film at the points that an index or mask ``chosen`` picks."""
        return Film(
            self.smooth[chosen],
            self.rough[chosen],
            self.smooth_size[chosen],
            self.rough_size[chosen],
            self.smooth_exponent,
            self.rough_exponent,
            self.turning_ratio,
            self.greatest,
        )

    def thickness(self, log_load_parameter: ArrayLike) -> tuple[NDArray, NDArray]:
        """Film thickness under a load (Eq. 7).

        Parameters
        ----------
        log_load_parameter : array_like
            ln W [1], W = F/(E_ss R_x^2) (Eq. 8); a scalar or of the shape of the points.

        Returns
        -------
        thickness, slope : array
            H_c [1] and dH_c/d ln W [1].
        """
        smooth = np.exp(self.smooth + self.smooth_exponent * log_load_parameter)
        rough = np.exp(self.rough + self.rough_exponent * log_load_parameter)
        # Eq. 7
        return smooth + rough, self.smooth_exponent * smooth + self.rough_exponent * rough

    def rounding(self, log_load_parameter: ArrayLike, fall: ArrayLike) -> NDArray:
        """Relative error [1] that rounding leaves in H_c: the more, the larger logarithms of which it
        is the exponential.

        Parameters
        ----------
        log_load_parameter : array_like
            ln W [1].
        fall : array_like
            d ln H_c/d ln W [1] there.
        """
        rough = (fall - self.smooth_exponent) / ROUGHNESS_LOAD_EXPONENT  # the second term's share
        size = self.smooth_size + rough * self.rough_size + np.abs(fall * log_load_parameter)
        return EPSILON * (ROUNDINGS + ROUNDINGS_PER_SIZE * size)

    def crossing(self) -> tuple[NDArray, NDArray]:
        """Where both terms of Eq. 7 are equal: ln W there, and ln of each term [1].

        Seen from there, all films of one ellipticity are the same curve.
        """
        log_parameter = (self.smooth - self.rough) / (self.rough_exponent - self.smooth_exponent)
        return log_parameter, self.smooth + self.smooth_exponent * log_parameter

    def load_parameter(self, thickness: ArrayLike) -> NDArray:
        """Load under which the film has a given thickness: the inverse of ``thickness``.

        Parameters
        ----------
        thickness : array_like
            H_c [1], positive; a scalar or of the shape of the points.

        Returns
        -------
        array
            ln W [1].
        """
        return self.load_parameter_and_slope(thickness)[0]

    def load_parameter_and_slope(self, thickness: ArrayLike) -> tuple[NDArray, NDArray]:
        """What ``load_parameter`` returns, and d ln W/d ln H_c [1] there.

        Seen from where both terms of Eq. 7 are equal, all films of one ellipticity are the same
        curve: it is read off a table.
        """
        log_parameter, log_thickness = self.crossing()
        table = _inverse_table(self.smooth_exponent, self.rough_exponent)
        x = np.log(thickness) - log_thickness
        inside = table.covers(x)
        if inside.all():
            value, slope = table(x)
        else:
            value, slope = np.where(inside, table(np.where(inside, x, 0.0)), 0.0)
            exponents = self.smooth_exponent, self.rough_exponent
            value[~inside], slope[~inside] = _inverse(x[~inside], *exponents)[:2]
        return value + log_parameter, slope

    def is_meaningful(self, log_load_parameter: ArrayLike) -> NDArray:
        """Whether H_c rises with viscosity under the load ln W [1], as that of any oil does, and the
        surfaces are hard enough to bear it (``greatest_film_load``).

        Eq. 7 lets the film grow without bound as U goes to zero: where dH_c/dU < 0 it has lost its
        meaning.  At kappa = 1 that is where the roughness term exceeds 3.
        """
        return (log_load_parameter > self.turning()) & (log_load_parameter <= self.greatest)

    def turning(self) -> NDArray:
        """ln W [1] below which H_c falls with viscosity."""
        excess = np.log(self.turning_ratio) + self.smooth - self.rough
        return excess / ROUGHNESS_LOAD_EXPONENT


def _inverse(x, a, b):
    """y of e^x = e^(a y) + e^(b y), and its first two derivatives.

    Newton's method on the logarithm, which is convex; it starts where one term is e^x by itself, so
    that it cannot overshoot.
    """
    y = np.maximum(x / a, x / b)
    for _ in range(INVERSE_STEPS):
        y = y - (np.logaddexp(a * y, b * y) - x) / (b + (a - b) * scipy.special.expit((a - b) * y))
    rough = scipy.special.expit((b - a) * y)  # the share of the second term
    slope = 1.0 / (a + (b - a) * rough)
    return y, slope, -rough * (1.0 - rough) * (b - a) ** 2 * slope**3


@lru_cache(maxsize=64)
def _inverse_table(a, b):
    """``_inverse`` as a table, for the exponents of one ellipticity."""
    return HermiteTable(lambda x: np.stack(_inverse(x, a, b))[None], *INVERSE_RANGE, INVERSE_ERROR)


class _Law(NamedTuple):
    """What is the same in Eq. 7 at all conditions [1]: logarithms of factors, and exponents."""

    ln_speed: float  # U over the viscosity
    smooth: float
    smooth_material: float
    rough: float
    rough_hardness: float
    rough_material: float  # of 1/G
    load_exponent: float  # in the smooth film, as the next
    speed_exponent: float
    greatest: float


@lru_cache(maxsize=256)
def _law_of(parameters: Parameters) -> _Law:
    kappa = parameters.ellipticity
    ln_G, ln_V = math.log(parameters.material_parameter), math.log(parameters.hardness_parameter)
    return _Law(
        ln_speed=math.log(parameters.speed_per_viscosity),
        smooth=math.log(3.672 * (1.0 - 0.573 * math.exp(-0.74 * kappa))),
        smooth_material=0.502 * kappa**0.064 * ln_G,
        rough=math.log(0.025 * kappa**0.081),
        rough_hardness=0.119 * ln_V,
        rough_material=0.977 * ln_G,
        load_exponent=-0.045 * kappa**0.18,
        speed_exponent=0.663 * kappa**0.025,
        greatest=float(log_load_parameter(math.log(greatest_film_load(parameters)), parameters)),
    )
