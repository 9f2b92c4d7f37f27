"""What the library is measured against: how such models are first written, done with care.

``NestedRoots`` takes one ``quad`` an integral and one ``brentq`` an unknown, point by point.
``ElementwiseRoots`` solves arrays with ``scipy.optimize.elementwise.find_root`` on Gauss-Legendre
nodes.  Both give the variables of ``points.VARIABLES`` and nan where they find no solution.
"""

from __future__ import annotations

import importlib.util
import json
import math
from types import SimpleNamespace
from typing import NamedTuple

import numpy as np
from scipy.optimize import brentq, elementwise
from scipy.special import expit, log_expit

from benchmarks.points import VARIABLES
from thirdbody.data.conditions import DIMENSIONS
from thirdbody.model.asperity import SummitPopulation, asperity_load_and_area
from thirdbody.model.contact import Contact
from thirdbody.model.film import Film
from thirdbody.model.particles import ParticleLayer
from thirdbody.solver.points import Points

LOGIT_ENDS = -50.0, 50.0  # of L_s: shares of the load down to 2e-22
GAP_ENDS = 0.0, 40.0  # of d/sigma where nothing but summits can touch
ROUNDING = 1e-15  # no bracket gets narrower, relatively
CHUNK = 4096  # points solved together: what is fastest
TAIL = 9.0  # summits rarer than exp(-TAIL^2/2) of the densest do not matter


def load_plain_model(path):
    """The module of plain equations at ``path``: integrals by ``quad``, nothing vectorised."""
    specification = importlib.util.spec_from_file_location("plain_model", path)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


class NestedRoots:
    """The plain equations, solved for the separation and, within, for the load of the film.

    Its integrals are good to 1e-11; relative tolerances of the roots cannot be looser, as the
    tails multiply the error of d by (d/sigma)^2.
    """

    TOLERANCE = {"xtol": 1e-300, "rtol": 1e-14, "maxiter": 500}

    def __init__(self, plain, parameters):
        self.plain = plain
        self.parameters = parameters

    def solve(self, **conditions):
        """The variables at points of 1-D arrays of ``conditions``, as attributes."""
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
        """Where solids bear next to nothing [m]: no summit and no particle reaches so far."""
        mean, spread = self.plain.size_distribution(model, point)
        return max(10.0 * point.roughness, mean + model["truncation"] * spread)

    def _film_load(self, separation, model, point):
        """F_f* of a film as thick as ``separation`` d [m]: the inner root, in its logarithm."""

        def excess(log_load):
            return math.log(self.plain.film_separation(log_load, model, point) / separation)

        return math.exp(brentq(excess, -700.0, 700.0, **self.TOLERANCE))


class NodeSum:
    """ln of a load or an area of the summits as a sum over nodes ``w`` [1] of fixed interference.

    exp(-(t+w)^2/2) is exp(-t^2/2) exp(-w(t+w/2)), so that a node costs one exponential.
    """

    def __init__(self, w, weights):
        self.w, self.weights = w, weights * np.exp(-0.5 * w**2)

    def __call__(self, t):
        """Value and, which no bracketed root needs, a slope of zero, at ``t`` [1]."""
        total = np.exp(np.multiply.outer(-t, self.w)) @ self.weights
        return np.log(total) - 0.5 * t * t, 0.0


def node_sums(surface, parameters, counts=(8, 22, 16)):
    """``NodeSum`` of ln(F_ss/(A_n E_ss)) and of ln(A_ss/A_n) for the summits of ``surface``.

    ``counts`` of nodes over elastic, elastoplastic and plastic summits: 1e-10 for t from -1 to 6.
    """
    first = SummitPopulation.of(surface, parameters).yield_interference
    last = first * parameters.plastic_interference_ratio
    # w = r^2 makes the 3/2 power of first contact and the logarithm smooth
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
    """Summits of one surface by node sums, as ``thirdbody.model.contact`` asks for them."""

    offset: float  # y_s [m]
    deviation: float  # sigma_s [m]
    log_load: NodeSum
    log_area: NodeSum

    def take(self, chosen):
        """The same surface under any of the points."""
        return self


class ElementwiseRoots:
    """Arrays of points of one kind on one surface: ``find_root`` for the logit of L_s, or d/sigma
    where there is no film.

    Films in the reading that W in Eq. 7 is of the total load have no root to find: nan.
    """

    def __init__(self, parameters, roughness, rtol):
        surface = parameters.surface(roughness)
        self.parameters = parameters
        self.roughness = roughness
        self.summits = NodeSummits(
            surface.summit_offset, surface.summit_deviation, *node_sums(surface, parameters)
        )
        self.tolerances = {"xatol": 0.1 * rtol, "xrtol": ROUNDING, "fatol": 0.0, "frtol": 0.0}

    def solve(self, **conditions):
        """The variables at points of 1-D arrays of ``conditions``, as attributes."""
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
        """Values of the variables in order."""
        scale = self.roughness

        def shares(points, x):
            """d [m] and ln L_s for the unknown ``x``."""
            if points.film is None:
                return scale * x, np.zeros_like(x)
            return points.film_separation(log_expit(-x))[0], log_expit(x)

        def residual(x, index):
            some = points.take(index)
            separation, log_solid = shares(some, x)
            return some.contact.log_solid_load(separation)[0] - some.log_load - log_solid

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
        """Ends between which the unknown lies."""
        if points.film is not None:
            return LOGIT_ENDS
        low, high = GAP_ENDS
        particles = points.contact.particles
        if particles is None:
            return low, high
        return low, np.maximum(particles.reach / self.roughness, high)
