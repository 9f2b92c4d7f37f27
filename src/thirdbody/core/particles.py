"""Third-body particles: load, area and coverage in closed form (Eqs. 4-6).

Sizes are normally distributed, with mean m and standard deviation S, from X_min = 0 to
X_max = m + truncation * S.  Their second moment above a size a is

    c_1 (M(alpha) - M(truncation)),   M = Q(alpha) + (c_2 + c_3 alpha) phi(alpha),
    alpha = (a - m)/S,   c_1 = m^2 + S^2,   c_2 = 2 m S/c_1,   c_3 = S^2/c_1,

where phi and Q are the density and the upper tail of the standard normal distribution.  Below,
*moment* is the second moment over c_1: it is constant below X_min and zero above X_max.  With the
elastic factor e, the area A_sa is proportional to e (moment(d - h_e) - moment(d)) + moment(d).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from statistics import NormalDist

import numpy as np
import scipy  # scipy.special is loaded on first use: many jobs do not need it
from numpy.typing import NDArray

from thirdbody.core.asperity import gauss_legendre
from thirdbody.core.interpolation import Guesses
from thirdbody.core.logarithms import EPSILON, TINY, WithSlope
from thirdbody.core.parameters import Parameters

LARGEST_DIAMETER = 1e100  # limit of x_a [m]: powers of a larger one could overflow
FULL = -700.0  # ln of a bare fraction that counts as zero
INV_SQRT_2PI = 1.0 / np.sqrt(2.0 * np.pi)
LOWEST = -9.0  # alpha below which sizes add nothing to a moment in float64
# width in alpha below the largest size; it is less if phi decays by more than a factor e over it
NEXT_TO_LARGEST = 0.25
NODES, WEIGHTS = gauss_legendre(6)  # exact to rounding over this width
SHAPE_SAMPLES, GUESSES = np.geomspace(1e-5, 1.0, 199), 1001


def mean_and_largest(diameter: float, parameters: Parameters) -> tuple[float, float]:
    """Mean of the sizes and largest size X_max [m], for x_a [m] (Eq. 6).

    Sizes are normal about m, from 0 to X_max, so that their mean is not m.

    Examples
    --------
    >>> import thirdbody
    >>> inputs = thirdbody.load_parameters(spread_ratio=0.4, mean_ratio=0.0, truncation=4.0)
    >>> [round(size, 4) for size in mean_and_largest(1.0, inputs.best)]
    [0.3191, 1.6]
    """
    centre, spread = parameters.sizes(diameter)
    largest = centre + parameters.truncation * spread
    normal = NormalDist(centre, spread)
    part = normal.cdf(largest) - normal.cdf(0.0)
    return centre + spread**2 * (normal.pdf(0.0) - normal.pdf(largest)) / part, largest


@dataclass(frozen=True)
class ParticleLayer:
    """Particles on a surface, with a diameter x_a and a density for each point.

    ``centre`` and ``spread`` are m and S [m] of the size distribution.  If particles meet the plane
    of the summits, at d - y_s, the centre is m + y_s, so that it compares with d.  ``scaled_depth``
    is h_e/S [1].  ``factor`` is pi eta_a p c_1/(H_s1 + H_s2) [Pa-1], with the ``participation`` p.
    The factor times H_s1 and the ``moment`` is the coverage (Eqs. 4 and 5); with H_s2 in place of
    H_s1 it is A_sa/A_n (Eq. 5).  ``log_bare`` is ln of the fraction that all particles leave bare,
    the round bracket of Eq. 4.
    """

    centre: NDArray
    spread: NDArray
    scaled_depth: NDArray
    factor: NDArray
    log_bare: NDArray
    moment: Moment
    parameters: Parameters

    @classmethod
    def of(
        cls, diameter: NDArray, roughness: float | NDArray, density: NDArray, parameters: Parameters
    ) -> ParticleLayer:
        """The layer for x_a [m] and eta_a [m-2], positive, and sigma [m].

        x_a and eta_a have the same shape; sigma has this shape or is a scalar.  Raises
        ``ValueError`` as ``Parameters.check_particles``.

        Examples
        --------
        >>> import numpy as np, thirdbody
        >>> diameter, density = np.array([500e-9]), np.array([1e11])
        >>> inputs = thirdbody.load_parameters().best
        >>> layer = ParticleLayer.of(diameter, 300e-9, density, inputs)
        >>> area, coverage = layer.contact(np.array([500e-9, 900e-9]))
        >>> bool(area.value[0] > area.value[1])
        True
        >>> beyond, _ = layer.contact(layer.reach)
        >>> bool(beyond.value < 1e-12 * area.value[1])
        True
        """
        parameters.check_particles()
        diameter = np.minimum(diameter, LARGEST_DIAMETER)
        mean, spread = parameters.sizes(diameter)
        moment = _moment(*parameters.sizes(1.0), parameters.truncation)
        hardness = parameters.hardness_surface_1 + parameters.hardness_surface_2
        factor = np.pi * parameters.participation / hardness * density * (mean**2 + spread**2)
        every = factor * moment.of_all  # coverage by all sizes, over the hardness
        summit_offset = parameters.surface(roughness).summit_offset
        return cls(
            centre=mean + parameters.particle_plane_height(summit_offset),
            spread=spread,
            scaled_depth=parameters.elastic_depth_ratio * diameter / spread,
            factor=factor,
            log_bare=np.log(_bare_fraction(parameters.hardness_surface_1 * every)),
            moment=moment,
            parameters=parameters,
        )

    def take(self, chosen) -> ParticleLayer:
        """The layer at the points selected by an index or mask ``chosen``."""
        return replace(
            self,
            centre=self.centre[chosen],
            spread=self.spread[chosen],
            scaled_depth=self.scaled_depth[chosen],
            factor=self.factor[chosen],
            log_bare=self.log_bare[chosen],
        )

    @property
    def reach(self) -> NDArray:
        """Separation d [m] beyond which no particle touches.

        It is X_max + h_e, plus y_s if particles meet the plane of the summits.
        """
        return self.centre + (self.parameters.truncation + self.scaled_depth) * self.spread

    @property
    def covers_all(self) -> NDArray:
        """Whether particles cover the whole interface in Eq. 4."""
        return self.log_bare < FULL

    def contact(self, separation: NDArray) -> tuple[WithSlope, WithSlope]:
        """Area and coverage of the particles that touch at ``separation`` d [m] (Eq. 5).

        Returns A_sa/A_n [1], and the fraction [1] of the interface that particles larger than d
        cover.
        """
        alpha, elastic = (separation - self.centre) / self.spread, self.parameters.elastic_factor

        def weighted(above, touching):
            return (1.0 - elastic) * above + elastic * touching  # the square bracket of Eq. 5

        # of sizes above d and above d - h_e
        moments, slopes = self.moment(np.array([alpha, alpha - self.scaled_depth]))
        area_factor = self.factor * self.parameters.hardness_surface_2
        area = WithSlope(
            value=area_factor * weighted(*moments),
            slope=area_factor / self.spread * weighted(*slopes),
        )
        covering_factor = self.factor * self.parameters.hardness_surface_1
        coverage = WithSlope(
            value=covering_factor * moments[0],
            slope=covering_factor / self.spread * slopes[0],
        )
        return area, coverage

    def rounding(self, separation: NDArray, area: WithSlope) -> NDArray:
        """Relative rounding error [1] of the ``area`` from ``contact`` at ``separation`` d [m].

        It is 0 where no particle touches.
        """
        terms = (8.0 + self.moment.largest**2) * self.moment.cancellation * area.value
        lengths = separation + self.centre + self.scaled_depth * self.spread
        rounding_of_d = 2.0 * np.abs(area.slope) * lengths
        touch = area.value > 0.0
        # TINY for the digits lost below it; dividing by inf is faster than by 0
        return EPSILON * ((terms + rounding_of_d + TINY) / np.where(touch, area.value, np.inf))


class Moment:
    """M(alpha) minus M at X_max, for a ``mean`` and a ``spread`` of sizes in any unit.

    ``smallest`` and ``largest`` are alpha of X_min and of X_max.
    """

    def __init__(self, mean: float, spread: float, largest: float):
        square = mean**2 + spread**2
        self.constant, self.linear = 2.0 * mean * spread / square, spread**2 / square  # c_2 and c_3
        self.smallest, self.largest = -mean / spread, largest
        self.near_largest = largest - min(NEXT_TO_LARGEST, 1.0 / largest)
        self.of_largest = float(self._untruncated(np.array([largest]))[0][0])
        nearest = max(self.near_largest, self.smallest)
        # how much the moment, a difference, magnifies the rounding of M at most
        of_nearest, of_all = self(np.array([nearest, -np.inf]))[0].tolist()
        self.cancellation, self.of_all = 1.0 + 2.0 * self.of_largest / of_nearest, of_all

    def __call__(self, alpha: NDArray) -> tuple[NDArray, NDArray]:
        """The moment and its slope d/dalpha [1] at an array ``alpha``.

        Near the largest size the slope is integrated, because a difference would lose digits.
        """
        clipped = np.minimum(np.maximum(alpha, self.smallest), self.largest)
        value, slope = self._untruncated(clipped)
        moment = np.maximum(value - self.of_largest, 0.0)
        within = (alpha > self.smallest) & (alpha < self.largest)
        near = np.flatnonzero(within & (alpha > self.near_largest))
        if near.size:
            length = self.largest - alpha.reshape(-1)[near]
            slopes, *_ = self._slope(self.largest - length * NODES[:, None])
            moment.reshape(-1)[near] = -length * (WEIGHTS[:, None] * slopes).sum(0)
        return moment, slope * within

    @cached_property
    def inverse(self) -> Guesses:
        """A table of alpha [1] over ln of the moment [1]."""
        lowest = max(self.smallest, LOWEST)
        alpha = self.largest - SHAPE_SAMPLES * (self.largest - lowest)
        return Guesses(np.log(self(alpha)[0]), alpha, GUESSES)

    def _untruncated(self, alpha):
        """M(alpha) and dM/dalpha."""
        slope, polynomial, density = self._slope(alpha)
        return scipy.special.ndtr(-alpha) + polynomial * density, slope

    def _slope(self, alpha):
        """dM/dalpha, c_2 + c_3 alpha and phi_a(alpha) of Eq. 6."""
        density = INV_SQRT_2PI * np.exp(-0.5 * alpha * alpha)
        polynomial = self.constant + self.linear * alpha
        return -density * (1.0 - self.linear + polynomial * alpha), polynomial, density


_moment = lru_cache(maxsize=64)(Moment)


def log_bare_fraction(coverage: WithSlope) -> WithSlope:
    """ln of the fraction [1] that a ``coverage`` [1] leaves bare.

    Where particles cover everything it is below ``FULL``, with a slope of 0.
    """
    bare = _bare_fraction(coverage.value)
    slope = np.where(bare == TINY, 0.0, -coverage.slope) / bare
    return WithSlope(value=np.log(bare), slope=slope)


def _bare_fraction(coverage):
    """1 - coverage, or ``TINY`` where particles cover everything."""
    bare = 1.0 - coverage
    return np.where(bare <= EPSILON, TINY, bare)


def first_yield_depth(parameters: Parameters) -> float:
    """Depth h_e of the elastic zone over x_a [1], if it ends where surfaces yield under a particle.

    The paper describes h_e by the interference of a particle with surface 1 and with surface 2, and
    prints no value. At first yield each is (3 pi k H/(4 E))^2 R, as for a summit (Zhao, Maietta &
    Chang 2000), with the radius R = x_a/2 of the particle. The sum of both is k^2/8 of the elastic
    factor of Eq. 4.

    Parameters
    ----------
    parameters : Parameters
        Of which the moduli, the hardnesses and k, ``yield_pressure_ratio``, count.

    Examples
    --------
    >>> import thirdbody
    >>> round(first_yield_depth(thirdbody.load_parameters().best), 5)
    0.00177
    """
    return parameters.yield_pressure_ratio**2 * parameters.elastic_factor / 8.0


def has_particles(diameter: NDArray, density: NDArray) -> NDArray:
    """Whether particles of ``diameter`` [m] and ``density`` [m-2] cover any area in float64."""
    return diameter * diameter * density > TINY


def separation_carrying(log_area: float | NDArray, layer: ParticleLayer) -> NDArray:
    """Approximate separation d [m] at which particles alone have the area ``log_area``,
    ln(A_sa/A_n) [1].

    It is the larger of two separations: at the first the sizes above d alone have this area, at the
    second the sizes above d - h_e.  It is minus infinity if all particles together have less.
    """
    elastic = layer.parameters.elastic_factor
    log_moment = log_area - np.log(layer.factor * layer.parameters.hardness_surface_2)
    of_all = np.log(layer.moment.of_all)
    logs = (log_moment - np.log(weight) for weight in (1.0 - elastic, elastic))
    alpha, shifted = (np.where(x <= of_all, layer.moment.inverse(x), -np.inf) for x in logs)
    return layer.centre + layer.spread * np.maximum(alpha, shifted + layer.scaled_depth)
