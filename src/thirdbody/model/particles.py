"""Third particles between the surfaces: load, area and coverage in closed form (Eqs. 4-6).

Every reading of the size distribution phi_a gives the second moment above a size a as

    T(alpha) = c_1 M(alpha),   M = Q(alpha) + (c_2 + c_3 alpha) phi(alpha),   alpha = (a - m)/S,

with phi and Q the density and upper tail of the standard normal distribution, so that
I(a, b) = T(alpha) - T(beta).  The readings differ in m, S, c_1, c_2, c_3 alone, of which c_2 and c_3
are the same for all particles of a reading: the fields of ``SizeLaw``.  Particles end at
X_max = m + truncation * S, so M is never needed deep in the tail.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import ndtr

from thirdbody.model.parameters import Parameters
from thirdbody.model.readings import SizeLaw

FULL = -700.0  # logarithm of a share that is none
INV_SQRT_2PI = 1.0 / np.sqrt(2.0 * np.pi)


@dataclass(frozen=True)
class ParticleLayer:
    """Particles on a surface: one mean diameter and density for each point.

    Array fields have the shape of the points.  ``ParticleLayer.of`` makes a layer from diameters
    and densities.

    Attributes
    ----------
    mean, spread : array
        m and S [m] of the size distribution.
    depth : array
        h_e/S [1].
    share : array
        pi eta_a p c_1/(H_s1 + H_s2) [Pa-1]: times the hardness of a surface and M it is the share
        of the interface that particles take (Eqs. 4 and 5).
    log_bare : array
        ln of the share of the interface that the particles of Eq. 4 leave bare, where they are the
        same at every separation; else 0.
    law : tuple of float
        c_2 and c_3.
    largest : float
        M at X_max.
    parameters : Parameters
        All inputs of the model.
    """

    mean: NDArray
    spread: NDArray
    depth: NDArray
    share: NDArray
    log_bare: NDArray
    law: tuple[float, float]
    largest: float
    parameters: Parameters

    @classmethod
    def of(
        cls, diameter: NDArray, roughness: ArrayLike, density: NDArray, parameters: Parameters
    ) -> ParticleLayer:
        """Make the layer of particles of given mean diameters and densities.

        Parameters
        ----------
        diameter, density : array
            x_a [m] and eta_a [m-2], positive and of one shape.
        roughness : array_like
            sigma [m], a scalar or of the same shape.
        parameters : Parameters
            All inputs of the model.

        Returns
        -------
        ParticleLayer

        Examples
        --------
        >>> import numpy as np, thirdbody
        >>> diameter, density = np.array([500e-9]), np.array([1e11])
        >>> inputs = thirdbody.load_parameters()
        >>> layer = ParticleLayer.of(diameter, 300e-9, density, inputs)
        >>> area, slope, coverage, coverage_slope = layer.contact(np.array([100e-9, 300e-9]))
        >>> bool(area[0] > area[1])
        True
        >>> bool(layer.contact(layer.reach)[0] < 1e-12 * area[1])
        True
        """
        sizes = parameters.readings.size_distribution.law(diameter, roughness, parameters)
        law = sizes.constant, sizes.linear
        largest = float(_moment(parameters.truncation, *law)[0])
        hardness = parameters.hardness_surface_1 + parameters.hardness_surface_2
        share = np.pi * parameters.participation / hardness * density * sizes.square
        depth = parameters.elastic_depth_ratio * diameter / sizes.spread
        log_bare = np.zeros_like(share)
        if not parameters.readings.coverage_limits.contacting:
            every = _moment_of_all(sizes, largest)
            log_bare = np.log(_bare_share(parameters.hardness_surface_1 * every * share))
        return cls(sizes.mean, sizes.spread, depth, share, log_bare, law, largest, parameters)

    def take(self, chosen) -> ParticleLayer:
        """The layer at the points that an index or mask ``chosen`` picks."""
        columns = self.mean, self.spread, self.depth, self.share, self.log_bare
        picked = (column[chosen] for column in columns)
        return ParticleLayer(*picked, self.law, self.largest, self.parameters)

    @property
    def reach(self) -> NDArray:
        """Separation [m] beyond which no particle touches: X_max + h_e."""
        return self.mean + (self.parameters.truncation + self.depth) * self.spread

    def contact(self, separation: NDArray) -> tuple[NDArray, NDArray, NDArray, NDArray]:
        """Area and coverage of the particles that touch (Eq. 5).

        Parameters
        ----------
        separation : array
            d [m], of the shape of the points.

        Returns
        -------
        area, area_slope : array
            A_sa/A_n [1] and its derivative by d [m-1].
        coverage, coverage_slope : array
            Share of the interface under particles larger than d [1] and its derivative [m-1].
        """
        side = self.parameters.readings.elastic_limits.side
        alpha = (separation - self.mean) / self.spread
        touching, touching_slope = self._truncated(alpha)
        shifted, shifted_slope = self._truncated(alpha + side * self.depth)
        beyond = touching - self.largest  # I(d, X_max) over c_1
        elastic = (
            self.parameters.elastic_factor * side
        )  # the sign makes I(d, d + side h_e) positive
        area_factor = self.share * self.parameters.hardness_surface_2
        load_factor = self.share * self.parameters.hardness_surface_1
        return (
            area_factor * (elastic * (touching - shifted) + beyond),  # Eq. 5
            area_factor
            / self.spread
            * (elastic * (touching_slope - shifted_slope) + touching_slope),
            load_factor * beyond,
            load_factor / self.spread * touching_slope,
        )

    def log_bare_load(self, coverage: NDArray, slope: NDArray) -> tuple[NDArray, ArrayLike]:
        """What particles leave of the summits' load: the bracket of Eq. 4.

        Parameters
        ----------
        coverage, slope : array
            Coverage [1] and its slope [m-1], as ``contact`` returns them.

        Returns
        -------
        log_share, slope : array
            ln of the share of the load that is left [1] and its derivative by d [m-1].
        """
        if self.parameters.readings.coverage_limits.contacting:
            return log_bare_share(coverage, slope)
        return self.log_bare, 0.0

    def leave_no_room(self, coverage: NDArray) -> NDArray:
        """Whether particles cover the whole interface, in Eq. 4 or in Eq. 5.

        ``coverage`` [1] is that of ``contact``, of the particles larger than d; Eq. 4 counts at
        least those.
        """
        if self.parameters.readings.coverage_limits.contacting:
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


def _moment_of_all(sizes: SizeLaw, largest):
    """I(X_min, X_max) over c_1 [1]; all of I where no size is the smallest, nor then the largest."""
    if not np.isfinite(sizes.smallest):
        return 1.0
    return float(_moment(sizes.smallest, sizes.constant, sizes.linear)[0]) - largest


def log_bare_share(coverage: NDArray, slope: NDArray) -> tuple[NDArray, NDArray]:
    """ln of the share that a coverage leaves bare, and its slope.

    Parameters
    ----------
    coverage, slope : array
        Share of the interface under particles [1] and its derivative by d [m-1].

    Returns
    -------
    log_share, slope : array
        ln(1 - coverage) [1] and its derivative [m-1]; below ``FULL`` and 0 where particles cover
        everything.
    """
    bare = _bare_share(coverage)
    covers = bare == np.finfo(bare.dtype).tiny
    return np.log(bare), np.where(covers, 0.0, -slope) / bare


def _bare_share(coverage):
    """1 - coverage, or next to nothing where particles cover everything."""
    bare = 1.0 - coverage
    return np.where(bare <= np.finfo(float).eps, np.finfo(bare.dtype).tiny, bare)


def has_particles(diameter: ArrayLike, density: ArrayLike) -> NDArray:
    """Whether particles of ``diameter`` [m] and ``density`` [m-2] cover more than float64's zero."""
    return diameter**2 * density > np.finfo(float).tiny


def separation_bearing(area: ArrayLike, layer: ParticleLayer) -> NDArray:
    """About the separation d [m] at which particles alone have the ``area`` A_sa/A_n [1].

    A first guess, read off one sampled curve: all diameters and densities share it, but for the
    elastic depth.
    """
    return layer.mean + layer.spread * np.interp(
        area / layer.share, *sampled_contact(layer.parameters)
    )


def sampled_contact(parameters: Parameters) -> tuple[NDArray, NDArray]:
    """Increasing areas A_sa/A_n over ``ParticleLayer.share`` [Pa], and alpha there [1]."""
    same = np.ones_like(SHAPE_SAMPLES)
    unit = ParticleLayer.of(same, same, same, parameters)
    alpha = parameters.truncation + unit.depth
    alpha = alpha - SHAPE_SAMPLES * (parameters.truncation + 2.0 * unit.depth + 6.0)
    return unit.contact(unit.mean + alpha * unit.spread)[0] / unit.share, alpha


def unit_moment(parameters: Parameters) -> Callable[[NDArray], tuple[NDArray, NDArray]]:
    """The function of alpha that gives M and its slope, for all particles of a reading."""
    one = np.ones(1)
    sizes = parameters.readings.size_distribution.law(one, one, parameters)
    return lambda alpha: _moment(alpha, sizes.constant, sizes.linear)


SHAPE_SAMPLES = np.concatenate([[0.0], np.geomspace(1e-5, 1.0, 199)])
