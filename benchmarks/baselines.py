"""Plain solvers of the model, beside which the library is measured.

``NestedRoots`` goes point by point, with the equations of ``verification/plain_model.py``: integrals by
``scipy.integrate.quad``, roots by ``brentq``.  ``ArrayRoots`` has the same equations on arrays: integrals by
Gauss-Legendre quadrature, roots by ``scipy.optimize.elementwise.find_root``.
"""

import importlib.util
import json
import math
from os import PathLike
from types import ModuleType, SimpleNamespace

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize.elementwise import find_root

import thirdbody as tb
from benchmarks.points import SMALLEST, VARIABLES
from thirdbody.attributes import model_attribute
from thirdbody.variables import DIMENSIONS


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
        """``VARIABLES`` of points, shape (n,), nan where there is no solution; arguments as of
        ``thirdbody.solve``, one-dimensional."""
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


NODES, WEIGHTS = np.polynomial.legendre.leggauss(32)
NEARLY_ALL = 0.99  # L_f; beyond it, 1 - L_f has fewer digits than the load that solids bear
NEGLIGIBLE = 80.0  # exp(-80) of the greatest weight is nothing in float64
FAINTEST = -700.0  # ln F_f/F_t; nothing beside what the solids bear
FARTHEST = 20.0  # sigma_s; no summit is as high


class ArrayRoots:
    """The same equations on arrays of points, all with or all without oil."""

    def __init__(self, parameters: tb.Parameters):
        self.inputs = parameters

    def solve(self, **conditions: ArrayLike) -> SimpleNamespace:
        """As ``NestedRoots.solve``."""
        points = np.broadcast_arrays(*(np.asarray(conditions[name], float) for name in DIMENSIONS))
        load, viscosity, diameter, roughness, _ = points
        with np.errstate(all="ignore"):
            if viscosity.any() and self.inputs.film_shares_load:
                fluid = find_root(self._excess_of_film, (FAINTEST, 0.0), args=points).x
                separation = self._film(np.log(load) + fluid, *points)
                solid = np.exp(self._excess_of_solids(separation, *points))
                fluid = np.exp(fluid)
                solid = np.where(fluid < NEARLY_ALL, 1.0 - fluid, solid)
            else:
                film = self._film(np.log(load), *points) if viscosity.any() else 0.0 * load
                surface = self.inputs.surface(roughness)
                far = film + surface.summit_offset + FARTHEST * surface.summit_deviation
                far = far + self._largest(diameter)
                root = find_root(self._excess_of_solids, (film, far), args=points).x
                separation = np.where(np.isnan(root) & (film > 0.0), film, root)
                solid = np.exp(np.minimum(self._excess_of_solids(separation, *points), 0.0))
                fluid = np.where(np.isnan(root), 1.0 - solid, 0.0)
            _, summits, particles = self._solids(separation, *points)
            total = np.logaddexp(summits, particles)
            areas = (np.exp(log_area) for log_area in (total, particles - total, summits - total))
        values = *areas, solid, fluid, separation, separation / self.inputs.ball_radius
        return SimpleNamespace(**dict(zip(VARIABLES, values, strict=True)))

    def _excess_of_film(self, fluid, *point):
        """ln (F_s + F_f)/F_t where the film bears the share exp(``fluid``)."""
        separation = self._film(np.log(point[0]) + fluid, *point)
        return np.logaddexp(self._excess_of_solids(separation, *point), fluid)

    def _excess_of_solids(self, separation, *point):
        """ln F_s/F_t."""
        return self._solids(separation, *point)[0] - np.log(point[0])

    def _film(self, log_load, load, viscosity, diameter, roughness, density):
        """d = R_x H_c [m] under ln F* = ``log_load`` (Eq. 7)."""
        inputs, kappa = self.inputs, self.inputs.ellipticity
        speed, modulus = inputs.speed_per_viscosity * viscosity, inputs.material_parameter
        log_w = log_load + math.log(inputs.apparent_area / inputs.ball_radius**2)
        smooth = 3.672 * np.exp(-0.045 * kappa**0.18 * log_w) * speed ** (0.663 * kappa**0.025)
        smooth *= modulus ** (0.502 * kappa**0.064) * (1.0 - 0.573 * math.exp(-0.74 * kappa))
        rough = 0.025 * (roughness / inputs.ball_radius) ** 1.248 * np.exp(-0.133 * log_w)
        rough *= inputs.hardness_parameter**0.119 * speed**-0.884
        rough *= modulus**-0.977 * kappa**0.081
        return inputs.ball_radius * smooth * (1.0 + rough)

    def _solids(self, separation, load, viscosity, diameter, roughness, density):
        """ln of F_s*, and of the areas of summits and particles over A_n (Eqs. 2 to 6)."""
        inputs = self.inputs
        log_load, log_area = self._summits(separation, roughness)
        gap = separation - inputs.particle_plane_height(inputs.surface(roughness).summit_offset)
        soft = 1.0 / (inputs.hardness_surface_1 + inputs.hardness_surface_2)
        cover = np.pi * soft * inputs.participation * density
        larger, depth = self._moment(gap, np.inf, diameter), inputs.elastic_depth_ratio * diameter
        elastic = inputs.elastic_factor * self._moment(gap - depth, gap, diameter)
        particles = cover * inputs.hardness_surface_2 * (elastic + larger)
        cover = cover * inputs.hardness_surface_1
        bare = np.log1p(-cover * self._moment(0.0, np.inf, diameter))
        log_solids = np.logaddexp(log_load + bare, np.log(inputs.particle_pressure * particles))
        return log_solids, log_area + np.log1p(-cover * larger), np.log(particles)

    def _largest(self, diameter):
        """X_max [m]."""
        mean, spread = self.inputs.sizes(diameter)
        return mean + self.inputs.truncation * spread

    def _moment(self, low, high, diameter):
        """Integral of x^2 phi_a from ``low`` to ``high`` [m] (Eq. 6), in m2."""
        mean, spread = self.inputs.sizes(diameter)
        low = np.maximum(low, 0.0)
        size, width = _nodes(low, np.maximum(np.minimum(high, self._largest(diameter)), low))
        step = (size - mean[..., np.newaxis]) / spread[..., np.newaxis]
        weight = size**2 * np.exp(-0.5 * step**2) * width
        moment = weight.sum(-1) / (math.sqrt(2.0 * math.pi) * spread)
        return np.where(diameter > 0.0, moment, 0.0)

    def _summits(self, separation, roughness):
        """ln F_ss* and ln A_ss/A_n without particles (first half of Eq. 6)."""
        inputs, surface = self.inputs, self.inputs.surface(roughness)
        deviation, radius = surface.summit_deviation, surface.summit_radius
        t = (separation - surface.summit_offset) / deviation
        far = np.hypot(t, math.sqrt(2.0 * NEGLIGIBLE))
        reach = np.where(t > 0.0, 2.0 * NEGLIGIBLE / (far + t), far - t)
        pressure = inputs.softer_hardness / inputs.elastic_modulus_surfaces
        strain = 0.75 * math.pi * inputs.yield_pressure_ratio * pressure
        first = strain**2 * radius / deviation  # omega_1/sigma_s, as w is omega/sigma_s
        last = first * inputs.plastic_interference_ratio
        lowest = np.maximum(-t - math.sqrt(2.0 * NEGLIGIBLE), 0.0)
        kinks = (np.clip(end, lowest, reach) for end in (0.0, first, last, -t, np.inf))
        ends = np.sort(np.stack([*kinks]), axis=0)
        pieces = (
            _nodes(np.sqrt(low), np.sqrt(high))  # of sqrt(w), which smooths the power of 3/2
            for low, high in zip(ends, ends[1:])
        )
        root, width = (np.concatenate(parts, axis=-1) for parts in zip(*pieces))
        w, t_, first_ = root**2, t[..., np.newaxis], first[..., np.newaxis]
        weight = np.exp(np.where(t_ > 0.0, -w * (t_ + 0.5 * w), -0.5 * (t_ + w) ** 2))
        weight *= 2.0 * root * width
        ratio = w / first_
        u = np.clip(
            (ratio - 1.0) / max(inputs.plastic_interference_ratio - 1.0, SMALLEST), 0.0, 1.0
        )
        grown = np.pi * (radius * deviation)[..., np.newaxis] * w * (1.0 + 3.0 * u**2 - 2.0 * u**3)
        done = np.clip(
            np.log(ratio) / max(math.log(inputs.plastic_interference_ratio), SMALLEST), 0.0, 1.0
        )
        mean = pressure * (1.0 - (1.0 - inputs.yield_pressure_ratio) * (1.0 - done))
        elastic = 4.0 / 3.0 * np.sqrt(radius * deviation**3)[..., np.newaxis] * w**1.5
        load = (weight * np.where(ratio < 1.0, elastic, mean * grown)).sum(-1)
        area = (weight * grown).sum(-1)
        scale = surface.summit_density / math.sqrt(2.0 * math.pi)
        tail = -0.5 * np.maximum(t, 0.0) ** 2
        return np.log(scale * load) + tail, np.log(scale * area) + tail


def _nodes(low, high):
    """Places and weights of quadrature between ends, along a new last axis."""
    middle, half = 0.5 * (high + low), 0.5 * (high - low)
    return middle[..., np.newaxis] + half[..., np.newaxis] * NODES, half[..., np.newaxis] * WEIGHTS
