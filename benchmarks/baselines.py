"""Two simpler solvers of the model, beside which the library is measured.

``NestedRoots`` takes point by point: integrals by ``scipy.integrate.quad``, roots by ``brentq``.  ``ElementwiseRoots``
takes arrays: integrals by Gauss-Legendre nodes, roots by ``scipy.optimize.elementwise.find_root``.  Both give
``points.VARIABLES``, nan where they find no solution, and share no code with the library.
"""

import importlib.util
import json
import math
from os import PathLike
from types import ModuleType, SimpleNamespace

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import elementwise
from scipy.special import erfc, expit, log_expit

import thirdbody as tb
from benchmarks.points import VARIABLES
from thirdbody.data.attributes import model_attribute
from thirdbody.variables import DIMENSIONS

CHUNK = 4096  # points solved together
NODES = 8, 22, 16  # for elastic, elastoplastic, plastic summits: 1e-10 for d/sigma_s from -1 to 6
TAIL = 9.0  # standard deviations, beyond which summits are left out
LOGIT_ENDS = -50.0, 50.0  # of ln(L_s/L_f)


def load_plain_model(path: str | PathLike) -> ModuleType:
    """Import ``verification/plain_model.py``, which belongs to no package."""
    specification = importlib.util.spec_from_file_location("plain_model", path)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def _model(parameters, roughness):
    """Inputs of the model by their keys in datasets, for a surface of this roughness."""
    model = json.loads(model_attribute(parameters, [roughness]))
    return {name: value[0] if isinstance(value, list) else value for name, value in model.items()}


class NestedRoots:
    """The plain equations of ``verification/plain_model.py``, one point after the other."""

    def __init__(self, plain: ModuleType, parameters: tb.Parameters):
        self.plain = plain
        self.parameters = parameters

    def solve(self, **conditions: ArrayLike) -> SimpleNamespace:
        """``VARIABLES`` of points, shape (n,); arguments as of ``thirdbody.solve``, one-dimensional."""
        columns = np.broadcast_arrays(*(conditions[name] for name in DIMENSIONS))
        solved = [self._solve_one(*map(float, point)) for point in zip(*columns, strict=True)]
        return SimpleNamespace(**dict(zip(VARIABLES, np.array(solved).T, strict=True)))

    def _solve_one(self, *conditions):
        model = _model(self.parameters, conditions[3])
        summits = (model[name] for name in ("eta_s", "R", "sigma_s", "y_s"))
        found = self.plain.solve(model, self.plain.Point(*conditions, *summits))
        if found.state is None:
            return [math.nan] * len(VARIABLES)
        areas = found.state.total_area, found.state.particle_ratio, found.state.summit_ratio
        film = found.separation / model["R_x"]
        return [*areas, found.solid_fraction, found.fluid_fraction, found.separation, film]


class ElementwiseRoots:
    """Arrays of points on one surface, all of one class, solved by ``find_root``.

    The unknown is d/sigma, or ln(L_s/L_f) where the film of F_f carries a part of the load.
    """

    def __init__(self, parameters: tb.Parameters, roughness: float, rtol: float):
        self.sigma = roughness
        self.model = model = SimpleNamespace(**_model(parameters, roughness))
        self.hardness = min(model.H_s1, model.H_s2) / model.E_ss
        self.tolerances = {"xatol": 0.1 * rtol, "xrtol": 1e-15, "fatol": 0.0, "frtol": 0.0}
        self.w, self.loads, self.areas = self._summit_nodes()

    def _summit_nodes(self):
        """Interferences over sigma_s, and what the summits of each carry and touch at t = 0."""
        model = self.model
        first = (0.75 * np.pi * model.k * self.hardness) ** 2 * model.R / model.sigma_s
        last = first * model.omega_ratio
        edges = np.sqrt(np.minimum([0.0, first, last, last + TAIL], TAIL))  # w = r^2: smooth
        w, weights = [], []
        for low, high, count in zip(edges, edges[1:], NODES, strict=False):
            nodes, node_weights = np.polynomial.legendre.leggauss(count)
            root = low + 0.5 * (high - low) * (nodes + 1.0)
            w.append(root**2)
            weights.append((high - low) * node_weights * root)
        w = np.concatenate(w)
        u = np.clip((w - first) / max(last - first, 1e-300), 0.0, 1.0)
        area = np.pi * w * (1.0 + u * u * (3.0 - 2.0 * u))
        ahead = np.log(last / np.clip(w, first, last)) / max(math.log(model.omega_ratio), 1e-300)
        pressure = self.hardness * (1.0 - (1.0 - model.k) * ahead)
        load = area * np.where(w < first, self.hardness * model.k * np.sqrt(w / first), pressure)
        weight = np.concatenate(weights) * np.exp(-0.5 * w**2) / math.sqrt(2.0 * np.pi)
        weight *= model.eta_s * model.R * model.sigma_s
        return w, weight * load, weight * area

    def solve(self, **conditions: ArrayLike) -> SimpleNamespace:
        """``VARIABLES`` of points, shape (n,); arguments as of ``thirdbody.solve``, one-dimensional."""
        columns = np.broadcast_arrays(*(conditions[name] for name in DIMENSIONS))
        starts = range(0, columns[0].size, CHUNK)
        with np.errstate(all="ignore"):
            parts = [self._solve_some(*(each[i : i + CHUNK] for each in columns)) for i in starts]
        values = (np.concatenate(values) for values in zip(*parts, strict=True))
        return SimpleNamespace(**dict(zip(VARIABLES, values, strict=True)))

    def _solve_some(self, load, viscosity, diameter, _, density):
        wet = viscosity[0] > 0.0
        by_shares = wet and self.model.film_load == "fluid"
        given = load, viscosity, diameter, density

        def gap(x, load, viscosity):
            return self._film(load * expit(-x), viscosity) if by_shares else self.sigma * x

        def residual(x, load, viscosity, diameter, density):
            solid = log_expit(x) if by_shares else 0.0
            loads = self._log_solid_load(gap(x, load, viscosity), diameter, density)
            return loads - np.log(load) - solid

        _, _, largest = self._sizes(diameter)
        reach = (largest + self.model.h_e_ratio * diameter) / self.sigma
        ends = LOGIT_ENDS if by_shares else (0.0, np.maximum(reach, 40.0))
        found = elementwise.find_root(residual, ends, args=given, tolerances=self.tolerances)
        x = np.where(found.success, found.x, np.nan)
        d = gap(x, load, viscosity)
        solid, fluid = np.ones_like(x), np.zeros_like(x)
        if by_shares:
            solid, fluid = expit(x), expit(-x)
        elif wet:  # a film of the total load has one thickness
            d = np.maximum(d, self._film(load, viscosity))
            solid = np.exp(self._log_solid_load(d, diameter, density)) / load
            fluid = 1.0 - solid
        particles, covered = self._particles(d, diameter, density)
        summits = np.exp(self._log_summits(d, self.areas)) * (1.0 - covered)
        total = particles + summits
        return total, particles / total, summits / total, solid, fluid, d, d / self.model.R_x

    def _log_summits(self, d, weights):
        """ln of what summits carry, or touch, with phi(t + w) = phi(t) exp(-w t) exp(-w^2/2)."""
        t = (d - self.model.y_s) / self.model.sigma_s
        return np.log(np.exp(np.multiply.outer(-t, self.w)) @ weights) - 0.5 * t * t

    def _log_solid_load(self, d, diameter, density):
        """ln F_s* (Eq. 4)."""
        area, _ = self._particles(d, diameter, density)
        _, covered = self._particles(np.full_like(d, -np.inf), diameter, density)  # all sizes
        summits = self._log_summits(d, self.loads) + np.log1p(-covered)
        return np.logaddexp(summits, np.log(area * self.model.H_s1 / self.model.E_ss))

    def _particles(self, d, diameter, density):
        """A_sa* and what particles above d cover (Eqs. 4 and 5)."""
        model = self.model
        d = d - (model.y_s if model.particle_plane == "summit" else 0.0)
        h_e = model.h_e_ratio * diameter
        squares = (model.H_s1 / model.E_sa) ** 2 + (model.H_s2 / model.E_ss) ** 2
        elastic = 2.25 * np.pi**2 * squares * self._moment(d - h_e, d, diameter)
        moment = elastic + self._moment(d, np.inf, diameter)
        number = np.pi * model.participation * density / (model.H_s1 + model.H_s2)
        covered = number * model.H_s1 * self._moment(d, np.inf, diameter)
        return number * model.H_s2 * moment, covered

    def _sizes(self, diameter):
        """Mean, spread and largest size of phi_a (Eq. 6)."""
        model = self.model
        mean, spread = model.mean_ratio * diameter, model.sigma_a_ratio * diameter
        return mean, spread, mean + model.truncation * spread

    def _moment(self, low, high, diameter):
        """Second moment of the sizes from ``low`` to ``high``."""
        if diameter[0] == 0.0:
            return np.zeros_like(low)
        mean, spread, largest = self._sizes(diameter)
        low = np.maximum(low, 0.0)
        a, b = ((np.minimum(end, largest) - mean) / spread for end in (low, high))
        fraction = 0.5 * (erfc(a / math.sqrt(2.0)) - erfc(b / math.sqrt(2.0)))
        at_a, at_b = (
            (2.0 * mean + spread * end) * np.exp(-0.5 * end * end) / math.sqrt(2.0 * np.pi)
            for end in (a, b)
        )
        return np.maximum((mean**2 + spread**2) * fraction + spread * (at_a - at_b), 0.0)

    def _film(self, load, viscosity):
        """h [m] of a film under the load F* (Eq. 7)."""
        model, kappa = self.model, self.model.kappa
        W, U = load * model.A_n / model.R_x**2, model.U_per_viscosity * viscosity
        smooth = 3.672 * W ** (-0.045 * kappa**0.18) * U ** (0.663 * kappa**0.025)
        smooth *= model.G ** (0.502 * kappa**0.064) * (1.0 - 0.573 * math.exp(-0.74 * kappa))
        rough = 0.025 * (self.sigma / model.R_x) ** 1.248 * model.V**0.119 * kappa**0.081
        rough = rough * W**-0.133 * U**-0.884 * model.G**-0.977
        return model.R_x * smooth * (1.0 + rough)
