"""The classes of points whose cost and error are measured: medium, bodies and span."""

from __future__ import annotations

from itertools import product
from typing import NamedTuple

import numpy as np

from thirdbody.model.parameters import Parameters


class PointClass(NamedTuple):
    """Dry or lubricated points with two or three bodies, in the usual span or at extremes."""

    medium: str
    bodies: str
    span: str


# that which all other figures are compared by
HEAVIEST = PointClass("lubricated", "three_body", "usual")
CLASSES = [
    PointClass(*names)
    for names in product(("dry", "lubricated"), ("two_body", "three_body"), ("usual", "extremes"))
]
# ends between which the logarithms of the conditions are spread evenly, SI; the usual ones are
# those of Table 2, its load in N
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
ROUGHNESS = {"usual": (300e-9,), "extremes": (1e-9, 100e-9, 1e-6, 10e-6)}  # [m]


def random_conditions(kind: PointClass, count: int, parameters: Parameters, seed=SEED) -> dict:
    """``count`` random points of a class: the arguments of ``solve`` as 1-D arrays, by name."""
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
