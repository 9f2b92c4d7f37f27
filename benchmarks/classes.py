"""Classes of points whose time and error are measured; random points and grids of a class."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import product
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

import thirdbody as tb


class PointClass(NamedTuple):
    """A class of points."""

    medium: str  # dry or lubricated
    bodies: str  # two_body or three_body: without or with particles
    span: str  # usual: within the ranges of Table 2; or extremes


# The most expensive of the usual classes, by which methods are compared.
HEAVIEST = PointClass("lubricated", "three_body", "usual")
CLASSES = [
    PointClass(*names)
    for names in product(("dry", "lubricated"), ("two_body", "three_body"), ("usual", "extremes"))
]
# Ends between which conditions are drawn, evenly in their logarithms, SI: F_t [N], nu [m2/s],
# x_a [m], eta_a [m-2].  The usual ones are those of Table 2.
SPANS = {
    "usual": {
        "normal_load": (0.04, 80.0),
        "viscosity": (10e-6, 150e-6),
        "particle_diameter": (50e-9, 1e-6),
        "particle_density": (1e10, 1e12),
    },
    "extremes": {
        "normal_load": (1e-6, 1e4),
        "viscosity": (1e-9, 1e-2),
        "particle_diameter": (1e-12, 1e-5),
        "particle_density": (1e5, 1e10),
    },
}
SEED = 4
ROUGHNESS = {"usual": (300e-9,), "extremes": (1e-9, 100e-9, 1e-6, 10e-6)}  # values of sigma [m]


def random_conditions(
    kind: PointClass, count: int, parameters: tb.Parameters, seed: int = SEED
) -> dict[str, NDArray[np.float64]]:
    """Random points of a class: the five arguments of ``thirdbody.solve``, shape (count,)."""
    random = np.random.default_rng(seed)
    drawn = {
        name: np.exp(random.uniform(*np.log(ends), count))
        for name, ends in SPANS[kind.span].items()
    }
    if kind.medium == "dry":
        drawn["viscosity"] = np.zeros(count)
    if kind.bodies == "two_body":
        drawn["particle_diameter"] = np.zeros(count)
    return {
        "load": drawn["normal_load"] / parameters.newtons_per_load,
        "viscosity": drawn["viscosity"],
        "particle_diameter": drawn["particle_diameter"],
        "roughness": random.choice(ROUGHNESS[kind.span], count),
        "particle_density": drawn["particle_density"],
    }


def grid_axes(
    kind: PointClass, counts: Mapping[str, int], parameters: tb.Parameters
) -> dict[str, NDArray[np.float64]]:
    """Axes of a grid over the span of a class, with so many values each, on its first roughness."""
    spans = SPANS[kind.span]
    axes = {
        name: np.geomspace(*spans[name], counts[name]) for name in ("viscosity", "particle_density")
    }
    axes["particle_diameter"] = np.geomspace(
        *spans["particle_diameter"], counts["particle_diameter"]
    )
    axes["load"] = np.geomspace(*spans["normal_load"], counts["load"]) / parameters.newtons_per_load
    axes["roughness"] = np.array(ROUGHNESS[kind.span][:1])
    if kind.medium == "dry":
        axes["viscosity"] = np.zeros(1)
    if kind.bodies == "two_body":
        axes["particle_diameter"] = np.zeros(1)
    return axes
