"""Searching the unknown inputs of an interpretation for those that explain most of the paper."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import cma
import numpy as np
from numpy.typing import NDArray
from scipy.stats.qmc import LatinHypercube

from thirdbody.study.calibration import Interpretation

FIRST_STEP = 0.05  # standard deviation of the first steps of a search, in the unit cube
SAME_HEIGHT = 0.03  # a descent has converged when objectives differ by no more [1]


def scatter(interpretation: Interpretation, budget: Mapping[str, Any]) -> NDArray[np.float64]:
    """Places that fill the unit cube of the unknowns, shape (scattered, unknowns).

    Every second one, from the first on, has summits of at least ``budget["elastic_radius"]``.
    """
    unknowns = interpretation.unknowns
    places = LatinHypercube(len(unknowns), rng=np.random.default_rng(0)).random(budget["scattered"])
    for column, unknown in enumerate(unknowns):
        if unknown.name == "summit_radius":
            least = unknown.position(budget["elastic_radius"])
            places[::2, column] = least + (1.0 - least) * places[::2, column]
    return places


def search(
    interpretation: Interpretation,
    objective: Callable[[Interpretation, NDArray[np.float64]], float],
    start: NDArray[np.float64],
    budget: Mapping[str, Any],
    seed: int,
) -> NDArray[np.float64]:
    """Search the unknowns of an interpretation, two at least, for the least objective.

    A CMA evolution strategy descends from the position ``start``, and saves evaluations by a quadratic
    surrogate (Hansen 2019, doi:10.1145/3321707.3321842).  ``budget`` has the number of ``evaluations`` for each
    unknown, which the last generation may exceed.  The same ``seed``, from 1, gives the same result: positions
    and, in the last column, the objective there [1], in the order of evaluation.
    """
    rows = []

    def function(positions):
        value = objective(interpretation, positions)
        rows.append([*positions, value])
        return value

    options = {
        "bounds": [0.0, 1.0],
        "maxfevals": budget["evaluations"] * len(interpretation.unknowns),
        "tolfun": SAME_HEIGHT,
        "tolfunhist": SAME_HEIGHT,
        "seed": seed,
        "verbose": -9,
    }
    cma.fmin_lq_surr(function, start, FIRST_STEP, options)
    least = min(row[-1] for row in rows)
    print(f"{interpretation.name} seed {seed}: {len(rows)} evaluations, least {least:.3f}")
    return np.array(rows)
