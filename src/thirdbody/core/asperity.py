"""Rough surface against rough surface: a single asperity, and a Gaussian population of summits.

The paper takes F_ss and A_ss from Zhao, Maietta & Chang (2000), J. Tribol. 122:86.  An asperity
with interference omega first yields at omega_1 and is fully plastic from omega_2 on.  The interface
has eta_s summits per square metre, with normally distributed heights z (first half of Eq. 6):

    F_ss/A_n = eta_s * integral of F(omega) phi(z),   A_ss/A_n = eta_s * integral of A(omega) phi(z)

over all z above d - y_s, with omega = z - (d - y_s).  The height z is measured from the plane of
the summits, which lies y_s above the mean plane, and d is the separation of the mean planes.  With
the standard deviation sigma_s of the heights as the unit of length, both integrals depend only on
t = (d - y_s)/sigma_s, and the interference is w = omega/sigma_s.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.core.logarithms import TINY
from thirdbody.core.parameters import Parameters, Surface


def area_growth(ratio: float | NDArray, plastic_ratio: float) -> NDArray:
    """A/(pi R omega) [1] of an asperity: 1 while elastic, 2 when fully plastic.

    ``ratio`` is omega/omega_1 [1], ``plastic_ratio`` omega_2/omega_1 [1].
    """
    if plastic_ratio == 1.0:
        return np.where(ratio > 1.0, 2.0, 1.0)
    u = np.minimum(np.maximum((ratio - 1.0) / (plastic_ratio - 1.0), 0.0), 1.0)
    return 1.0 + u * u * (3.0 - 2.0 * u)


def pressure_fraction(ratio: float | NDArray, yield_ratio: float, plastic_ratio: float) -> NDArray:
    """F/(A H) [1] of a yielding asperity: k at first yield, 1 when fully plastic.

    ``ratio`` is omega/omega_1 [1], ``yield_ratio`` k [1], ``plastic_ratio`` omega_2/omega_1 [1].
    """
    if plastic_ratio == 1.0:
        return np.where(ratio > 1.0, 1.0, yield_ratio)
    within = np.minimum(np.maximum(ratio, 1.0), plastic_ratio)
    return yield_ratio + (1.0 - yield_ratio) * np.log(within) / np.log(plastic_ratio)


def gauss_legendre(count: int) -> tuple[NDArray, NDArray]:
    """``count`` Gauss-Legendre nodes and weights [1] on the interval from 0 to 1, each 1-D."""
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return 0.5 * (nodes + 1.0), 0.5 * weights


# Errors of ln F_ss and ln A_ss are below 4e-14 for any material.
NODES, WEIGHTS = gauss_legendre(48)
# Beyond this v the height density is below exp(-37) of its maximum: negligible in float64.
WIDEST = np.sqrt(2.0 * 37.0)
# Summits deeper than this below the mean height are a fraction of 6e-16 of all.  In a wider range
# the nodes would be too far apart.
DEEPEST = 8.0
ELASTIC, ELASTOPLASTIC, PLASTIC = range(3)  # indices into arrays of nodes


class _Nodes(NamedTuple):
    """Summits at the quadrature nodes, in arrays of shape (..., 3, nodes).

    ``above`` is max(t, 0), of the shape of t.  A summit at the height t + w, with the interference
    w, has the density e^(-above^2/2) e^(-v (above + v/2)) of Eq. 6, where ``v`` = w + min(t, 0).
    ``area`` is A/(pi R sigma_s) times the second factor and the quadrature weight.  It lacks the
    first factor, which would underflow at a large t.  ``pressure`` is F/(A H).  All are [1].
    """

    above: NDArray
    v: NDArray
    area: NDArray
    pressure: NDArray


@dataclass(frozen=True)
class SummitPopulation:
    """Load and area of a Gaussian population of equal summits, per apparent area.

    Elastic, elastoplastic and plastic summits have separate integrals, by Gauss-Legendre
    quadrature.  The fields, all [1], are scalars, or arrays with an element per point.

    Examples
    --------
    >>> import thirdbody
    >>> parameters = thirdbody.load_parameters().best
    >>> summits = SummitPopulation.of(parameters.surface(300e-9), parameters)
    >>> log_load, slope = summits.log_load([0.0, 3.0, 100.0])
    >>> bool((slope < 0.0).all()), bool(log_load[2] < -5000.0)
    (True, True)
    """

    scaled_density: float | NDArray  # eta_s R sigma_s
    sharpness: float | NDArray  # sigma_s/R
    hardness_ratio: float  # H/E_ss
    yield_ratio: float  # k
    plastic_ratio: float  # omega_2/omega_1

    @classmethod
    def of(cls, surface: Surface, parameters: Parameters) -> SummitPopulation:
        """The population of a ``surface`` with the materials of ``parameters``."""
        density_radius = surface.summit_density * surface.summit_radius
        return cls(
            scaled_density=density_radius * surface.summit_deviation,
            sharpness=surface.summit_deviation / surface.summit_radius,
            hardness_ratio=parameters.softer_hardness / parameters.elastic_modulus_surfaces,
            yield_ratio=parameters.yield_pressure_ratio,
            plastic_ratio=parameters.plastic_interference_ratio,
        )

    def take(self, chosen) -> SummitPopulation:
        """The populations of the points selected by an index or mask ``chosen``."""
        return replace(
            self,
            scaled_density=np.asarray(self.scaled_density)[chosen],
            sharpness=np.asarray(self.sharpness)[chosen],
        )

    @property
    def yield_interference(self) -> float | NDArray:
        """w_1 = omega_1/sigma_s [1]."""
        return (0.75 * np.pi * self.yield_ratio * self.hardness_ratio) ** 2 / self.sharpness

    def log_load(self, t: float | NDArray) -> tuple[NDArray, NDArray]:
        """ln(F_ss/(A_n E_ss)) of all summits [1], and its derivative with respect to the separation
        ``t`` [1]."""
        nodes = self._nodes(t)
        return self._logarithm(nodes, nodes.area * nodes.pressure, self.hardness_ratio)[:2]

    def log_load_and_area(self, t: float | NDArray) -> NDArray:
        """ln F_ss* and ln(A_ss/A_n), with the first two derivatives with respect to ``t``: shape
        (2, 3, ...)."""
        nodes = self._nodes(t)
        load = self._logarithm(nodes, nodes.area * nodes.pressure, self.hardness_ratio)
        return np.stack([load, self._logarithm(nodes, nodes.area, 1.0)])

    def pressure(self, ratio: float | NDArray) -> NDArray:
        """F/(A H) [1] of a summit at omega/omega_1 = ``ratio`` [1]."""
        yielding = pressure_fraction(ratio, self.yield_ratio, self.plastic_ratio)
        return np.where(ratio < 1.0, self.yield_ratio * np.sqrt(ratio), yielding)

    def _nodes(self, t):
        """The summits at the quadrature nodes for each separation ``t`` [1]."""
        t = np.asarray(t, dtype=float)
        above, below = np.maximum(t, 0.0), np.minimum(t, 0.0)
        w_1 = np.asarray(self.yield_interference)
        start = np.maximum(-below - DEEPEST, 0.0)
        end = WIDEST**2 / (above + np.hypot(above, WIDEST)) - below
        changes = w_1[..., None] * [0.0, 1.0, self.plastic_ratio, np.inf]
        # the variable of integration is the square root of w, in which half powers of w are smooth
        edges = np.sqrt(np.minimum(np.maximum(changes, start[..., None]), end[..., None]))
        width = (edges[..., 1:] - edges[..., :-1])[..., None]
        sqrt_w = edges[..., :-1, None] + width * NODES
        w = sqrt_w * sqrt_w
        v = w + below[..., None, None]
        weight = np.exp(-v * (above[..., None, None] + 0.5 * v))
        area = weight * w * sqrt_w * (2.0 * width * WEIGHTS)  # dw = 2 sqrt(w) d(sqrt(w))
        ratio = w[..., ELASTOPLASTIC, :] / w_1[..., None]
        area[..., ELASTOPLASTIC, :] *= area_growth(ratio, self.plastic_ratio)
        area[..., PLASTIC, :] *= 2.0
        pressure = np.ones_like(w)
        elastic = self.yield_ratio / np.sqrt(w_1)[..., None]
        pressure[..., ELASTIC, :] = elastic * sqrt_w[..., ELASTIC, :]
        yielding = pressure_fraction(ratio, self.yield_ratio, self.plastic_ratio)
        pressure[..., ELASTOPLASTIC, :] = yielding
        return _Nodes(above=above, v=v, area=area, pressure=pressure)

    def _logarithm(self, nodes, terms, unit):
        """ln of the sum of ``terms`` times pi eta_s R sigma_s times ``unit``, and two derivatives.

        ``unit`` is H/E_ss for a load and 1 for an area.
        """
        # with all nodes on a single axis the sum at a point does not depend on other points
        above, shape = nodes.above, (*nodes.above.shape, 3 * NODES.size)
        terms, v = terms.reshape(shape), nodes.v.reshape(shape)
        total = np.maximum(terms.sum(-1), TINY)
        moments = terms * v
        mean = moments.sum(-1) / total
        moments *= v
        square = moments.sum(-1) / total
        # sqrt(pi/2) is pi over the sqrt(2 pi) of Eq. 6
        value = np.log(total * (unit * np.sqrt(0.5 * np.pi))) + np.log(self.scaled_density)
        return value - 0.5 * above**2, -(above + mean), square - mean**2 - 1.0
