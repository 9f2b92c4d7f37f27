"""Classes of points whose time and error are measured: their random points, their grids, and the
clock.
"""

import time
from collections.abc import Callable, Mapping
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


HEAVIEST = PointClass("lubricated", "three_body", "usual")  # the most expensive of the usual ones
TIMED = HEAVIEST, HEAVIEST._replace(span="extremes")
NAMES = ("dry", "lubricated"), ("two_body", "three_body"), ("usual", "extremes")
CLASSES = [PointClass(*names) for names in product(*NAMES)]
# Conditions are drawn between these ends, evenly in their logarithms: F_t [N], nu [m2/s], x_a [m]
# and eta_a [m-2].  The usual ends are those of Table 2.
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
MICROSECONDS = 1e6  # in a second
ROUGHNESS = {"usual": (300e-9,), "extremes": (1e-9, 100e-9, 1e-6, 10e-6)}  # values of sigma [m]


def random_conditions(
    kind: PointClass, count: int, parameters: tb.Parameters, seed: int = SEED
) -> dict[str, NDArray[np.float64]]:
    """Random points of a class: the five arguments of ``thirdbody.solve``, shape (count,)."""
    random = np.random.default_rng(seed)
    spans = SPANS[kind.span].items()
    drawn = {name: np.exp(random.uniform(*np.log(ends), count)) for name, ends in spans}
    return _of_class(kind, drawn, random.choice(ROUGHNESS[kind.span], count), parameters)


def grid_axes(
    kind: PointClass, counts: Mapping[str, int], parameters: tb.Parameters
) -> dict[str, NDArray[np.float64]]:
    """Axes of a grid over the span of a class.

    ``counts`` has the number of values on each axis; the axis of the roughness has ``ROUGHNESS``.
    """
    counts = {"normal_load": counts["load"], **counts}
    spans = SPANS[kind.span].items()
    axes = {name: np.geomspace(*ends, counts[name]) for name, ends in spans}
    axes = _of_class(kind, axes, np.array(ROUGHNESS[kind.span]), parameters)
    return {name: np.unique(values) for name, values in axes.items()}


def _of_class(kind, given, roughness, parameters):
    """Conditions of a class, without a film or without particles if the class has none."""
    wet, bodies = kind.medium == "lubricated", kind.bodies == "three_body"
    return {
        "load": given["normal_load"] / parameters.newtons_per_load,
        "viscosity": wet * given["viscosity"],
        "particle_diameter": bodies * given["particle_diameter"],
        "roughness": roughness,
        "particle_density": given["particle_density"],
    }


def least_seconds(
    functions: Mapping, rounds: int, clock: Callable[[], float] = time.process_time
) -> dict:
    """Least time [s] of each function over several rounds, by name.

    The least counts, as other programs can only add to a time.  The functions take turns, so that a
    busy minute falls on all of them.
    """
    times = {name: [] for name in functions}
    for _ in range(rounds):
        for name, function in functions.items():
            start = clock()
            function()
            times[name].append(clock() - start)
    return {name: min(each) for name, each in times.items()}
