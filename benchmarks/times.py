"""Time of a point in the library and in the baselines, class by class."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from functools import partial
from types import ModuleType
from typing import Any

import numpy as np

from benchmarks.baselines import ElementwiseRoots, NestedRoots
from benchmarks.classes import CLASSES, HEAVIEST, PointClass, random_conditions
from benchmarks.measuring import (
    MICROSECONDS,
    least_seconds,
    peak_megabytes,
    processor_seconds,
)
from thirdbody.model.asperity import SummitPopulation
from thirdbody.model.parameters import Parameters
from thirdbody.solver.compiled.tables import precisions, prepare_model
from thirdbody.solver.plan import COMPILED
from thirdbody.solver.solve import solve
from thirdbody.solver.surfaces import Sheet, log_yields, prepare_tables


def time_rows(
    parameters: Parameters, budget: Mapping[str, Any], plain: ModuleType
) -> list[dict[str, Any]]:
    """Measure the cost of a point of each class for each method and ``rtol``.

    Parameters
    ----------
    parameters : Parameters
        Inputs of the model.
    budget : mapping
        Content of ``config/accuracy.yaml``: ``points``, ``rtol`` and ``rounds`` are used.
    plain : module
        The plain equations, as ``benchmarks.baselines.load_plain_model`` returns them.

    Returns
    -------
    list of dict
        Rows of the table ``times``.
    """
    return [row for kind in CLASSES for row in _rows_of(kind, parameters, budget, plain)]


def _rows_of(kind: PointClass, parameters, budget, plain):
    """Rows of one class; that of the baseline which is not asked for an ``rtol`` comes last."""
    sizes = budget["points"]
    library = sizes["heaviest"] if kind == HEAVIEST else sizes["others"]
    many, some, few = (
        random_conditions(kind, count, parameters)
        for count in (library, sizes["elementwise_roots"], sizes["nested_roots"])
    )
    runs, costs = {}, {}
    for rtol in budget["rtol"]:
        solving = partial(solve, **many, parameters=parameters, rtol=rtol, way=COMPILED)
        costs["library", rtol] = {
            "setup_seconds": processor_seconds(partial(_prepare, many, parameters, rtol)),
            "peak_memory_MB": peak_megabytes(solving),
        }
        runs["library", rtol] = solving
        runs["elementwise_roots", rtol] = _elementwise(some, parameters, rtol)
    runs["nested_roots", None] = partial(NestedRoots(plain, parameters).solve, **few)
    counts = {"library": many, "elementwise_roots": some, "nested_roots": few}
    with warnings.catch_warnings():
        # quad warns where rounding keeps it from the error of 1e-11 that it is asked for.
        warnings.simplefilter("ignore")
        seconds = least_seconds(runs, budget["rounds"])
    for (method, rtol), time in seconds.items():
        points = counts[method]["load"].size
        yield {
            "method": method,
            "rtol": rtol,
            **kind._asdict(),
            "points": points,
            "microseconds_per_point": MICROSECONDS * time / points,
            **costs.get((method, rtol), {"setup_seconds": None, "peak_memory_MB": None}),
        }


def _prepare(given, parameters, rtol):
    """Prepare a surface anew: everything that is done once for all of its points."""
    prepare_tables.cache_clear()
    prepare_model.cache_clear()
    summits = SummitPopulation.of(parameters.surface(float(given["roughness"][0])), parameters)
    sheet = Sheet.of_one(log_yields(summits), summits.materials)
    for real in precisions(rtol):
        prepare_model(sheet, parameters, rtol, real)


def _elementwise(given, parameters, rtol):
    """A function that solves the points of all surfaces, one after the other, by ``find_root``."""
    parts = []
    for sigma in np.unique(given["roughness"]):
        chosen = given["roughness"] == sigma
        part = {name: values[chosen] for name, values in given.items()}
        parts.append((ElementwiseRoots(parameters, float(sigma), rtol), part))

    def run():
        for solver, part in parts:
            solver.solve(**part)

    return run
