"""What a point costs in the library and in the baselines, class by class."""

from __future__ import annotations

import warnings

from thirdbody.accuracy.baselines import ElementwiseRoots, NestedRoots
from thirdbody.accuracy.classes import CLASSES, random_conditions
from thirdbody.accuracy.measuring import median_seconds, peak_megabytes
from thirdbody.interface import prepare_surface, solve
from thirdbody.parameters import Parameters

MICROSECONDS = 1e6  # of a second


def time_rows(parameters: Parameters, budget, plain) -> list[dict]:
    """Rows of the table ``times``: cost of a point of each class, method and ``rtol``.

    ``budget`` holds the numbers of points, of repeats and the tolerances of
    ``config/accuracy.yaml``; ``plain`` is the module of plain equations.
    """
    rows = []
    for kind in CLASSES:
        points = budget["points"] if kind.is_heaviest else budget["other_points"]
        given = random_conditions(kind, points, parameters)
        few = random_conditions(kind, budget["elementwise_points"], parameters)
        for rtol in budget["rtol"]:
            row = {"rtol": rtol, **kind._asdict()}
            rows.append({"method": "library"} | row | _library(given, parameters, rtol, budget))
            rows.append({"method": "elementwise_roots"} | row | _elementwise(few, parameters, rtol))
        one_by_one = random_conditions(kind, budget["nested_points"], parameters)
        cost = _nested(one_by_one, parameters, plain)
        rows.append({"method": "nested_roots", "rtol": None, **kind._asdict()} | cost)
    return rows


def _library(given, parameters, rtol, budget):
    """Cost of ``solve`` once the surfaces are prepared, and of preparing one."""

    def run():
        solve(**given, parameters=parameters, rtol=rtol)

    prepare_surface.cache_clear()
    roughness = float(given["roughness"][0])
    setup = median_seconds(lambda: prepare_surface(roughness, parameters, rtol), 1)
    memory = peak_megabytes(run)
    seconds = median_seconds(run, budget["repeats"])
    return _cost(seconds, given["load"].size, setup, memory)


def _elementwise(given, parameters, rtol):
    """Cost of ``find_root`` on the points of each surface in turn, its nodes being prepared."""
    solvers = {
        sigma: ElementwiseRoots(parameters, sigma, rtol) for sigma in set(given["roughness"].tolist())
    }
    parts = [
        (solver, {name: values[given["roughness"] == sigma] for name, values in given.items()})
        for sigma, solver in solvers.items()
    ]

    def run():
        for solver, part in parts:
            solver.solve(**part)

    return _cost(median_seconds(run, 1), given["load"].size)


def _nested(given, parameters, plain):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # quad's, where 1e-11 is more than rounding allows
        solver = NestedRoots(plain, parameters)
        return _cost(median_seconds(lambda: solver.solve(**given), 1), given["load"].size)


def _cost(seconds, points, setup=None, memory=None):
    return {
        "points_timed": points,
        "microseconds_per_point": MICROSECONDS * seconds / points,
        "setup_seconds": setup,
        "peak_memory_MB": memory,
    }
