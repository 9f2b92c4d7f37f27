"""What a point costs in the library and in the baselines, class by class."""

from __future__ import annotations

import warnings

import numpy as np

from thirdbody.accuracy.baselines import ElementwiseRoots, NestedRoots
from thirdbody.accuracy.classes import CLASSES, HEAVIEST, PointClass, random_conditions
from thirdbody.accuracy.measuring import MICROSECONDS, median_seconds, peak_megabytes
from thirdbody.compiled import prepare_model
from thirdbody.interface import prepare_surface, solve
from thirdbody.parameters import Parameters


def time_rows(parameters: Parameters, budget, plain) -> list[dict]:
    """Rows of the table ``times``: cost of a point of each class, method and ``rtol``.

    ``budget`` holds the numbers of points, of repeats and the tolerances of
    ``config/accuracy.yaml``; ``plain`` is the module of plain equations.
    """
    return [row for kind in CLASSES for row in _rows_of(kind, parameters, budget, plain)]


def _rows_of(kind: PointClass, parameters, budget, plain):
    """Rows of one class, the baseline that knows no ``rtol`` last."""
    sizes = budget["points"]
    library = sizes["heaviest"] if kind == HEAVIEST else sizes["others"]
    many, some, few = (
        random_conditions(kind, count, parameters)
        for count in (library, sizes["elementwise_roots"], sizes["nested_roots"])
    )
    for rtol in budget["rtol"]:
        costs = {
            "library": _library(many, parameters, rtol, budget["repeats"]),
            "elementwise_roots": _elementwise(some, parameters, rtol),
        }
        for method, cost in costs.items():
            yield {"method": method, "rtol": rtol, **kind._asdict(), **cost}
    yield {"method": "nested_roots", "rtol": None, **kind._asdict(), **_nested(few, parameters, plain)}


def _library(given, parameters, rtol, repeats):
    """Cost of ``solve`` once the surfaces are prepared, and of preparing one."""

    def run():
        solve(**given, parameters=parameters, rtol=rtol)

    roughness = float(given["roughness"][0])

    def prepare():
        prepare_surface.cache_clear()
        prepare_model(prepare_surface(roughness, parameters, rtol), parameters, rtol)

    setup = median_seconds(prepare, 1)
    memory = peak_megabytes(run)
    return _cost(median_seconds(run, repeats), given["load"].size, setup, memory)


def _elementwise(given, parameters, rtol):
    """Cost of ``find_root`` on the points of each surface in turn, its nodes being prepared."""
    parts = []
    for sigma in np.unique(given["roughness"]):
        chosen = given["roughness"] == sigma
        part = {name: values[chosen] for name, values in given.items()}
        parts.append((ElementwiseRoots(parameters, float(sigma), rtol), part))

    def run():
        for solver, part in parts:
            solver.solve(**part)

    return _cost(median_seconds(run, 1), given["load"].size)


def _nested(given, parameters, plain):
    """Cost of nested roots, point by point."""
    solver = NestedRoots(plain, parameters)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # quad's, where 1e-11 is more than rounding allows
        return _cost(median_seconds(lambda: solver.solve(**given), 1), given["load"].size)


def _cost(seconds, points, setup=None, memory=None):
    return {
        "points": points,
        "microseconds_per_point": MICROSECONDS * seconds / points,
        "setup_seconds": setup,
        "peak_memory_MB": memory,
    }
