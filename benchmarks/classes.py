"""The classes of points whose cost and error are measured, and random points of a class."""

from __future__ import annotations

from itertools import product
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.model.parameters import Parameters


class PointClass(NamedTuple):
    """A class of points.

    Attributes
    ----------
    medium : str
        ``dry`` or ``lubricated``.
    bodies : str
        ``two_body`` or ``three_body``: without or with particles.
    span : str
        ``usual``: conditions within the ranges of Table 2; or ``extremes``.
    """

    medium: str
    bodies: str
    span: str


# The class that costs most among the usual ones: comparisons of methods refer to it.
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
    kind: PointClass, count: int, parameters: Parameters, seed: int = SEED
) -> dict[str, NDArray[np.float64]]:
    """Draw random points of a class.

    Parameters
    ----------
    kind : PointClass
        The class.
    count : int
        Number of points.
    parameters : Parameters
        Inputs of the model, which relate loads in newtons to dimensionless ones.
    seed : int
        The same seed gives the same points.

    Returns
    -------
    dict of array, shape (count,)
        The five conditions by the names of the arguments of ``thirdbody.solve``, in its units.

    Examples
    --------
    >>> from thirdbody import load_parameters, solve
    >>> inputs = load_parameters()
    >>> points = random_conditions(HEAVIEST, 3, inputs)
    >>> solve(**points, parameters=inputs).solid_load_fraction.shape
    (3,)
    """
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
