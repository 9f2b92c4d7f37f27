"""Two simpler ways to solve the model, which the library is compared with.

They are how such models are usually written, done with care.  ``NestedRoots`` solves point by
point: each integral by ``scipy.integrate.quad``, each unknown by ``scipy.optimize.brentq``.
``ElementwiseRoots`` solves arrays of points by ``scipy.optimize.elementwise.find_root``, with
integrals over Gauss-Legendre nodes.  Both give ``points.VARIABLES``, nan where they find no solution.
"""

from __future__ import annotations

import importlib.util
import json
import math
from collections.abc import Sequence
from os import PathLike
from types import ModuleType, SimpleNamespace
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import brentq, elementwise
from scipy.special import expit, log_expit

from benchmarks.points import VARIABLES
from thirdbody.data.conditions import DIMENSIONS
from thirdbody.model.asperity import SummitPopulation, area_growth, pressure_fraction
from thirdbody.model.contact import Contact
from thirdbody.model.film import Film
from thirdbody.model.parameters import Parameters, Surface
from thirdbody.model.particles import ParticleLayer
from thirdbody.solver.points import Points

LOGIT_ENDS = -50.0, 50.0  # of ln(L_s/(1 - L_s)): shares of the load down to 2e-22
GAP_ENDS = 0.0, 40.0  # of d/sigma where nothing but summits can touch
ROUNDING = 1e-15  # least relative width of a bracket
CHUNK = 4096  # points solved together; other numbers take more time
TAIL = 9.0  # summits higher than so many standard deviations are left out


def asperity_load_and_area(omega, radius, modulus, hardness, yield_ratio, plastic_ratio):
    """F [N] and A [m2] of one asperity that is pressed by omega [m] (Zhao, Maietta & Chang 2000)."""
    omega = np.maximum(omega, 0.0)
    ratio = omega / ((0.75 * np.pi * yield_ratio * hardness / modulus) ** 2 * radius)
    area = np.pi * radius * omega * area_growth(ratio, plastic_ratio)
    hertz = 4.0 / 3.0 * modulus * np.sqrt(radius) * omega**1.5
    yielding = area * hardness * pressure_fraction(ratio, yield_ratio, plastic_ratio)
    return np.where(ratio < 1.0, hertz, yielding), area


def load_plain_model(path: str | PathLike) -> ModuleType:
    """Import the plain equations: integrals by ``quad``, nothing vectorised.

    Parameters
    ----------
    path : path
        The file ``verification/plain_model.py``, which belongs to no package.
    """
    specification = importlib.util.spec_from_file_location("plain_model", path)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


class NestedRoots:
    """The plain equations, solved by a root within a root.

    The outer unknown is the separation d; for each d that is tried, the load of the film is found
    by another root.  Integrals are good to 1e-11.  The tolerance of the roots has to be as tight as
    it is, because an error of d makes one in the loads that is up to (d/sigma)^2 times as large.

    Parameters
    ----------
    plain : module
        The equations, as ``load_plain_model`` returns them.
    parameters : Parameters
        Inputs of the model.

    Examples
    --------
    In the root of the repository:

    >>> from thirdbody import load_parameters, solve
    >>> inputs = load_parameters()
    >>> points = {"load": [1e-5], "viscosity": 0.0, "particle_diameter": 300e-9}
    >>> points |= {"roughness": 300e-9, "particle_density": 1e11}
    >>> plain = load_plain_model("verification/plain_model.py")
    >>> found = NestedRoots(plain, inputs).solve(**points)
    >>> library = solve(**points, parameters=inputs)
    >>> np.allclose(found.total_contact_area, library.total_contact_area, rtol=1e-9, atol=0.0)
    True
    """

    TOLERANCE = {"xtol": 1e-300, "rtol": 1e-14, "maxiter": 500}

    def __init__(self, plain: ModuleType, parameters: Parameters):
        self.plain = plain
        self.parameters = parameters

    def solve(self, **conditions: ArrayLike) -> SimpleNamespace:
        """Solve points.

        Parameters
        ----------
        **conditions : array_like
            The five conditions of ``thirdbody.solve`` by name, in its units; together they
            broadcast to shape (n,).

        Returns
        -------
        SimpleNamespace
            ``VARIABLES`` as attributes, shape (n,); nan for points without a solution.
        """
        columns = np.broadcast_arrays(*(conditions[name] for name in DIMENSIONS))
        solved = [self._solve_one(*map(float, point)) for point in zip(*columns, strict=True)]
        return SimpleNamespace(**dict(zip(VARIABLES, np.array(solved).T, strict=True)))

    def _solve_one(self, load, viscosity, diameter, roughness, density):
        surface = self.parameters.surface(roughness)
        point = self.plain.Point(
            load,
            viscosity,
            diameter,
            roughness,
            density,
            surface.summit_density,
            surface.summit_radius,
            surface.summit_deviation,
            surface.summit_offset,
        )
        model = json.loads(self.parameters.as_attribute([roughness]))
        try:
            separation, solid, fluid = self._balance(model, point)
            there = self.plain.state(separation, model, point)
        except (ValueError, ArithmeticError):  # no change of sign, or none in float64
            return [math.nan] * len(VARIABLES)
        areas = there.total_area, there.particle_ratio, there.summit_ratio
        return [*areas, solid, fluid, separation, separation / model["R_x"]]

    def _balance(self, model, point):
        """d [m], L_s and L_f."""
        load = point.load

        def solid(d):
            return math.exp(self.plain.log_solid_load(d, model, point))

        if not point.dry and not self.parameters.readings.film_load.depends_on_shares:
            d = self.plain.film_separation(math.log(load), model, point)
            share = solid(d) / load
            if share < 1.0:
                return d, share, 1.0 - share
            point = point._replace(viscosity=0.0)  # thinner than the dry gap, it bears nothing

        def excess(d):
            fluid = 0.0 if point.dry else self._film_load(d, model, point)
            return solid(d) + fluid - load

        high = self._farthest(model, point)
        while excess(high) > 0.0:
            high *= 2.0
        d = brentq(excess, 1e-3 * point.roughness, high, **self.TOLERANCE)
        fluid = 0.0 if point.dry else self._film_load(d, model, point)
        return d, solid(d) / load, fluid / load

    def _farthest(self, model, point):
        """A separation [m] at which neither summits nor particles bear a load worth counting."""
        mean, spread = self.plain.size_distribution(model, point)
        return max(10.0 * point.roughness, mean + model["truncation"] * spread)

    def _film_load(self, separation, model, point):
        """F_f* [1] under which the film is as thick as ``separation`` d [m]: the inner root."""

        def excess(log_load):
            return math.log(self.plain.film_separation(log_load, model, point) / separation)

        return math.exp(brentq(excess, -700.0, 700.0, **self.TOLERANCE))


class NodeSum:
    """ln of a load or an area of the summits, as a sum over summits of fixed interferences.

    With t = (d - y_s)/sigma_s and the interference w sigma_s of a summit, the density of its height
    is exp(-(t + w)^2/2) = exp(-t^2/2) exp(-w t) exp(-w^2/2): each node costs one exponential.

    Parameters
    ----------
    w : array, shape (nodes,)
        Interferences over sigma_s [1].
    weights : array, shape (nodes,)
        Load or area of the summits of each interference [1].
    """

    def __init__(self, w: NDArray[np.float64], weights: NDArray[np.float64]):
        self.w, self.weights = w, weights * np.exp(-0.5 * w**2)

    def __call__(self, t: NDArray[np.float64]) -> tuple[NDArray[np.float64], float]:
        """The logarithm [1] at t [1], and zero in the place of its slope, which is not needed."""
        total = np.exp(np.multiply.outer(-t, self.w)) @ self.weights
        return np.log(total) - 0.5 * t * t, 0.0


def node_sums(
    surface: Surface, parameters: Parameters, counts: Sequence[int] = (8, 22, 16)
) -> tuple[NodeSum, NodeSum]:
    """Sums over Gauss-Legendre nodes for the summits of a surface.

    Parameters
    ----------
    surface : Surface
        The surface.
    parameters : Parameters
        Inputs of the model.
    counts : sequence of int
        Numbers of nodes for elastic, elastoplastic and plastic summits; those of the default are
        good to 1e-10 for t from -1 to 6.

    Returns
    -------
    log_load, log_area : NodeSum
        ln(F_ss/(A_n E_ss)) and ln(A_ss/A_n).
    """
    first = SummitPopulation.of(surface, parameters).yield_interference
    last = first * parameters.plastic_interference_ratio
    # In r, w = r^2, the 3/2 power of elastic summits and the elastoplastic logarithm are smooth.
    edges = np.sqrt(np.minimum([0.0, first, last, last + TAIL], TAIL))
    w, weights = [], []
    for low, high, count in zip(edges, edges[1:], counts, strict=False):
        nodes, node_weights = np.polynomial.legendre.leggauss(count)
        root = low + 0.5 * (high - low) * (nodes + 1.0)
        w.append(root**2)
        weights.append((high - low) * node_weights * root)
    w, weights = np.concatenate(w), np.concatenate(weights)
    load, area = asperity_load_and_area(
        w * surface.summit_deviation,
        surface.summit_radius,
        parameters.elastic_modulus_surfaces,
        parameters.hardness_surface_2,
        parameters.yield_pressure_ratio,
        parameters.plastic_interference_ratio,
    )
    weights *= surface.summit_density / np.sqrt(2.0 * np.pi)
    return NodeSum(w, weights * load / parameters.elastic_modulus_surfaces), NodeSum(
        w, weights * area
    )


class NodeSummits(NamedTuple):
    """Summits of one surface, with what ``thirdbody.model.contact.Contact`` asks of summits.

    Attributes
    ----------
    offset, deviation : float
        y_s and sigma_s [m].
    log_load, log_area : NodeSum
        ln(F_ss/(A_n E_ss)) and ln(A_ss/A_n).
    """

    offset: float
    deviation: float
    log_load: NodeSum
    log_area: NodeSum

    def take(self, chosen: object) -> NodeSummits:
        """The summits under some of the points: the same, as all points are on one surface."""
        return self


class ElementwiseRoots:
    """Arrays of points on one surface, solved by ``scipy.optimize.elementwise.find_root``.

    The unknown is ln(L_s/(1 - L_s)), or d/sigma where there is no film.  All points must be of one
    kind: with or without a film, with or without particles.  In the reading in which the load in
    W (Eq. 8) is the total load, lubricated points have no root to find; they give nan.

    Parameters
    ----------
    parameters : Parameters
        Inputs of the model.
    roughness : float
        sigma [m] of the surface.
    rtol : float
        Relative error asked for [1].

    Examples
    --------
    >>> from thirdbody import load_parameters
    >>> loads = np.array([1e-6, 1e-5])
    >>> held = {"viscosity": 0.0, "particle_diameter": 300e-9}
    >>> held |= {"roughness": 300e-9, "particle_density": 1e11}
    >>> solved = ElementwiseRoots(load_parameters(), 300e-9, 1e-6).solve(load=loads, **held)
    >>> bool(solved.separation[0] > solved.separation[1])
    True
    """

    def __init__(self, parameters: Parameters, roughness: float, rtol: float):
        surface = parameters.surface(roughness)
        self.parameters = parameters
        self.roughness = roughness
        self.summits = NodeSummits(
            surface.summit_offset, surface.summit_deviation, *node_sums(surface, parameters)
        )
        self.tolerances = {"xatol": 0.1 * rtol, "xrtol": ROUNDING, "fatol": 0.0, "frtol": 0.0}

    def solve(self, **conditions: ArrayLike) -> SimpleNamespace:
        """Solve points.

        Parameters
        ----------
        **conditions : array_like
            The five conditions of ``thirdbody.solve`` by name, in its units; together they
            broadcast to shape (n,).

        Returns
        -------
        SimpleNamespace
            ``VARIABLES`` as attributes, shape (n,); nan for points without a solution.
        """
        columns = np.broadcast_arrays(*(conditions[name] for name in DIMENSIONS))
        with np.errstate(all="ignore"):
            parts = [
                self._solve_some(
                    self._points(*(column[start : start + CHUNK] for column in columns))
                )
                for start in range(0, columns[0].size, CHUNK)
            ]
        values = (np.concatenate(values) for values in zip(*parts, strict=True))
        return SimpleNamespace(**dict(zip(VARIABLES, values, strict=True)))

    def _points(self, load, viscosity, diameter, roughness, density):
        layer = film = None
        if diameter[0] > 0.0 and density[0] > 0.0:
            layer = ParticleLayer.of(diameter, roughness, density, self.parameters)
        if viscosity[0] > 0.0:
            film = Film.of(viscosity, roughness, self.parameters)
        return Points(Contact(self.summits, layer, self.parameters), film, np.log(load))

    def _solve_some(self, points):
        """Values of ``VARIABLES``, in their order."""
        scale = self.roughness

        def shares(points, x):
            """Separation d [m] and ln L_s at the unknown ``x``."""
            if points.film is None:
                return scale * x, np.zeros_like(x)
            return points.film_separation(log_expit(-x))[0], log_expit(x)

        def residual(x, index):
            some = points.take(index)
            separation, log_solid = shares(some, x)
            return some.contact.log_solid_load(separation).value - some.log_load - log_solid

        found = elementwise.find_root(
            residual,
            self._ends(points),
            args=(np.arange(points.log_load.size),),
            tolerances=self.tolerances,
        )
        explicit = (
            points.film is not None and not self.parameters.readings.film_load.depends_on_shares
        )
        x = np.where(found.success & (not explicit), found.x, np.nan)
        separation, log_solid = shares(points, x)
        particles, log_summits = points.contact.areas(separation)
        odds = np.log(particles) - log_summits
        fluid = np.zeros_like(x) if points.film is None else expit(-x)
        total = particles + np.exp(log_summits)
        film = separation / self.parameters.ball_radius
        return total, expit(odds), expit(-odds), np.exp(log_solid), fluid, separation, film

    def _ends(self, points):
        """Least and greatest value that the unknown may have."""
        if points.film is not None:
            return LOGIT_ENDS
        low, high = GAP_ENDS
        particles = points.contact.particles
        if particles is None:
            return low, high
        return low, np.maximum(particles.reach / self.roughness, high)
