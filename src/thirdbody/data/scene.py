"""A scene: the load axis and the groups of curves that one figure shows."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

DIMENSIONS = ("load", "viscosity", "particle_diameter", "roughness", "particle_density")

CENTISTOKES = 1e-6
NANOMETRE = 1e-9


@dataclass(frozen=True)
class Curves:
    """A group of curves: every combination of its four 1-D axes (SI)."""

    viscosity: np.ndarray  # nu [m2/s], 0: dry
    particle_diameter: np.ndarray  # x_a [m], 0: two-body
    roughness: np.ndarray  # sigma [m]
    particle_density: np.ndarray  # eta_a [m-2]

    @classmethod
    def of(cls, group: dict) -> list[Curves]:
        """Groups that one entry of ``curves`` describes: diameters relative to the roughness
        make a group of each roughness."""
        viscosity = scaled(group["viscosity_cSt"], CENTISTOKES)
        density = np.asarray(group["particle_density_per_m2"], dtype=float)
        roughness = scaled(group["roughness_nm"], NANOMETRE)
        if "particle_diameter_nm" in group:
            diameter = scaled(group["particle_diameter_nm"], NANOMETRE)
            return [cls(viscosity, diameter, roughness, density)]
        ratios = group["particle_diameter_per_roughness"]
        return [
            cls(viscosity, relative(ratios, sigma_nm), scaled([sigma_nm], NANOMETRE), density)
            for sigma_nm in group["roughness_nm"]
        ]


def scaled(values, unit: float):
    """Sorted unique ``values`` [``unit``] in SI; equal decimals give equal floats everywhere."""
    return np.unique(np.array([float(f"{value * unit:.12g}") for value in values]))


def relative(ratios, roughness_nm):
    """Diameters [m] from their ``ratios`` to the roughness [nm]."""
    return scaled([ratio * roughness_nm for ratio in ratios], NANOMETRE)


@dataclass(frozen=True)
class Scene:
    """What a dataset holds: its axes (SI, 1-D, increasing) and which combinations are shown."""

    name: str
    title: str
    load: np.ndarray
    groups: tuple[Curves, ...]

    @classmethod
    def of(cls, name: str, scene: dict, newtons_per_load: float) -> Scene:
        """The scene that a validated entry of ``config/scenes.yaml`` with its load axis describes.

        ``newtons_per_load`` F_t/F_t* [N] turns the axis in newtons into F_t*.
        """
        groups = [curves for group in scene["curves"] for curves in Curves.of(group)]
        load = load_values(scene["load_axis"], scene.get("named_loads", []), newtons_per_load)
        return cls(name, scene["title"], load, tuple(groups))

    @property
    def size(self) -> int:
        """Number of points."""
        axes = (
            tuple(getattr(group, name).size for name in DIMENSIONS[1:]) for group in self.groups
        )
        return self.load.size * sum(math.prod(sizes) for sizes in axes)

    def axis(self, name: str):
        """Values of the dimension ``name`` over all groups, increasing."""
        if name == "load":
            return self.load
        return np.unique(np.concatenate([getattr(group, name) for group in self.groups]))

    def placed(self, group: Curves):
        """Index arrays of ``group`` in the scene's five-dimensional arrays."""
        positions = [np.searchsorted(self.axis(n), getattr(group, n)) for n in DIMENSIONS[1:]]
        return np.ix_(np.arange(self.load.size), *positions)


def load_values(axis: dict, named_loads, newtons_per_load: float):
    """F_t* log-spaced over ``axis['load_N']`` in ``axis['count']`` steps, with ``named_loads``.

    A named load beyond the ends is left out: the axis spans the loads of Table 2.
    """
    first, last = (float(f"{end / newtons_per_load:.12g}") for end in axis["load_N"])
    spaced = np.geomspace(first, last, axis["count"])
    named = [value for value in named_loads if first <= value <= last]
    return np.unique(np.concatenate([spaced, named]))
