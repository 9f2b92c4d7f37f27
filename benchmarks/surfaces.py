"""How the time of the heaviest class depends on how many surfaces the points are on."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from itertools import count
from typing import Any

import numpy as np

from benchmarks.classes import HEAVIEST, SEED, random_conditions
from benchmarks.measuring import MICROSECONDS, least_seconds, processor_seconds
from thirdbody.model.parameters import Parameters
from thirdbody.solver.plan import COMPILED
from thirdbody.solver.solve import solve

# Whether the tables of the surfaces are there or have to be made in the call that is timed.
READY, NEW = "ready", "new"
ROUGHNESS = 100e-9, 500e-9  # ends of the values of sigma [m], those of the paper


def surface_rows(parameters: Parameters, budget: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Measure the cost of points that are spread over many surfaces, in no order.

    Parameters
    ----------
    parameters : Parameters
        Inputs of the model.
    budget : mapping
        Content of ``config/accuracy.yaml``: ``surfaces`` and ``rounds`` are used.

    Returns
    -------
    list of dict
        Rows of the table ``surfaces``.
    """
    settings = budget["surfaces"]
    points, rtol = settings["points"], settings["rtol"]
    given = random_conditions(HEAVIEST, points, parameters)
    others = _like(parameters)

    def run(surfaces, tables):
        inputs = parameters if tables == READY else next(others)
        on = given | {"roughness": _shuffled(surfaces, points)}
        return partial(solve, **on, parameters=inputs, rtol=rtol, way=COMPILED)

    runs = {
        (surfaces, tables): partial(run, surfaces, tables)
        for tables in (READY, NEW)
        for surfaces in settings["surfaces"]
    }
    for surfaces in settings["surfaces"]:
        run(surfaces, READY)()
    seconds = least_seconds(runs, budget["rounds"], timed=lambda make: processor_seconds(make()))
    return [
        {
            "surfaces": surfaces,
            "tables": tables,
            "points": points,
            "rtol": rtol,
            "microseconds_per_point": MICROSECONDS * each / points,
            "ratio": each / seconds[settings["surfaces"][0], tables],
        }
        for (surfaces, tables), each in seconds.items()
    ]


def _like(parameters):
    """Inputs that are as good as the same, but for which there are no tables yet."""
    for number in count(1):
        ratio = parameters.plastic_interference_ratio * (1.0 + 1e-9 * number)
        yield replace(parameters, plastic_interference_ratio=ratio)


def _shuffled(surfaces, points):
    """sigma [m] of each point: so many values, each for as many points, in no order."""
    values = np.geomspace(*ROUGHNESS, surfaces + 2)[1:-1]
    return values[np.random.default_rng(SEED).permutation(points) % surfaces]
