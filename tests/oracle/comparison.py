"""The library beside the extended-precision oracle: whole domain, all interpretations of the
equations.

Tests hold it to what is found here; ``benchmarks.oracle`` counts it.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

import thirdbody as tb
from benchmarks.points import relative_error
from tests.oracle.extended import CONDITIONS, QUANTITIES, Oracle, Solved
from tests.oracle.random_points import COMBINATIONS, draw_for_library, move_to_kinks
from thirdbody.variables import VARIABLES

RTOLS = 1e-2, 1e-3, 1e-6, 1e-9, 1e-11  # of the surfaces, in turn
ROUND = len(COMBINATIONS) * len(RTOLS)  # surfaces that have each of the one with each of the other
PLACES = "anywhere", "next to kinks"
NOT_CONVERGED = "not_converged"
ROUNDING = (
    1.5e-12  # relative change of a load that may decide, by rounding, whether there is a separation
)
BEYOND_BOUND = "beyond its bound"


class Drawn(NamedTuple):
    """Numbers and conditions of all points, the inputs of each surface, and what the oracle
    finds."""

    model: dict
    conditions: dict
    inputs: list
    expected: Solved

    @property
    def rtols(self):
        """What each surface is solved to."""
        return np.resize(RTOLS, len(self.inputs))

    def per_point(self, of_surfaces):
        """Values of surfaces, for each of their points."""
        return np.repeat(of_surfaces, self.conditions["load"].size // len(self.inputs))


class Compared(NamedTuple):
    """What the library finds at the points of ``Drawn``."""

    found: dict  # the variables of ``Solution``
    known: np.ndarray  # which points have values, here and by the oracle
    good: np.ndarray  # which have them as exact as asked for
    error: dict  # relative error of each quantity [1]
    problems: dict  # by what is wrong, the points at which it is: none should be


def draw_points(oracle: Oracle, surfaces: int, points: int, seed: int, place: str) -> Drawn:
    """``points`` points on each of so many ``surfaces``, lying as ``place`` of ``PLACES`` says."""
    model, conditions, inputs = draw_for_library(surfaces, points, seed)
    if place != PLACES[0]:
        conditions = move_to_kinks(model, conditions, oracle, seed + 1)
    return Drawn(model, conditions, inputs, oracle.solve(model, **conditions))


def compare(drawn: Drawn, oracle: Oracle) -> Compared:
    """Solve all points by the library, and say what differs from the oracle."""
    found = _solved(drawn)
    rtol, bound = drawn.per_point(drawn.rtols), found["error_bound"]
    exists = _exists(drawn.expected)
    good = found["solution_status"] != NOT_CONVERGED
    has_values = np.isfinite(found["separation"])
    known = has_values & exists
    problems = {
        "exists": _decided(oracle, drawn, np.flatnonzero(has_values != exists)),
        "is good without a separation": np.flatnonzero(has_values & good & ~exists),
    }
    errors = {}
    for name in QUANTITIES:
        error = errors[name] = relative_error(
            found[name], drawn.expected.values[name].astype(float)
        )
        problems[f"{name} {BEYOND_BOUND}"] = np.flatnonzero(known & ~(error <= bound))
        problems[f"{name} beyond rtol"] = np.flatnonzero(known & good & ~(error <= rtol))
    return Compared(found, known, good, errors, problems)


def _solved(drawn):
    """The variables of all points, each surface solved in one call."""
    found = []
    points = drawn.conditions["load"].size // len(drawn.inputs)
    for index, (parameters, rtol) in enumerate(zip(drawn.inputs, drawn.rtols, strict=True)):
        here = slice(index * points, (index + 1) * points)
        given = {name: drawn.conditions[name][here] for name in CONDITIONS}
        found.append(tb.solve(**given, parameters=parameters, rtol=rtol))
    return {name: np.concatenate([getattr(one, name) for one in found]) for name in VARIABLES}


def _exists(expected):
    """Where there is a separation that is not negative."""
    return expected.values["separation"] >= 0.0


def _decided(oracle, drawn, places):
    """Those of ``places`` where there also is a separation, or none, under loads apart by
    rounding."""
    model, conditions = (
        {name: values[places] for name, values in given.items()}
        for given in (drawn.model, drawn.conditions)
    )
    less, same, more = (
        _exists(oracle.solve(model, **conditions | {"load": conditions["load"] * factor}))
        for factor in (1.0 - ROUNDING, 1.0, 1.0 + ROUNDING)
    )
    return places[(less == same) & (same == more)]
