"""Points solved in multiple precision, and how far a solution is from them.

The files are those of ``tests/golden``: each row holds every input of the model, the conditions
of a point and its solution to 25 digits.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass

import numpy as np

from thirdbody.data.conditions import DIMENSIONS
from thirdbody.model.parameters import Parameters
from thirdbody.solver.solution import QUANTITIES

VARIABLES = QUANTITIES  # those that the files give
CLASS = ("medium", "bodies", "span")
SMALLEST = np.finfo(float).tiny  # what is smaller has few digits in float64 and counts as zero


@dataclass(frozen=True)
class Group:
    """Points that share all inputs and the roughness, so that they are solved as one array.

    ``conditions`` are the five arguments of ``solve`` and ``expected`` the values of
    ``VARIABLES``, each a 1-D array over ``rows``, the lines of the file as mappings of text.
    """

    parameters: Parameters
    rows: list
    conditions: dict
    expected: dict

    def take(self, chosen) -> Group:
        """The points at the indices ``chosen``."""
        return Group(
            self.parameters,
            [self.rows[index] for index in chosen],
            {name: values[chosen] for name, values in self.conditions.items()},
            {name: values[chosen] for name, values in self.expected.items()},
        )


def read_rows(path) -> list[dict]:
    """Lines of a file of golden points, as mappings of text."""
    with open(path, encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def grouped(rows) -> list[Group]:
    """``rows`` of ``read_rows`` as groups of points with the same inputs, in order of appearance."""
    shared = {}
    for row in rows:
        shared.setdefault(parameters_of(row), []).append(row)
    return [
        Group(
            parameters,
            members,
            {name: _column(members, name) for name in DIMENSIONS},
            {name: _column(members, name) for name in VARIABLES},
        )
        for parameters, members in shared.items()
    ]


def _column(rows, name):
    """Numbers of a column, nan where a row leaves it empty."""
    return np.array([float(row[name] or "nan") for row in rows])


def parameters_of(row) -> Parameters:
    """The inputs of a golden ``row``, whose surface is given at its own roughness."""
    return Parameters.on_one_surface(row, float(row["roughness"]))


def relative_errors(solution, expected) -> dict:
    """Relative error of each of ``VARIABLES``; infinite where a number is expected and none is.

    ``solution`` has them as attributes and ``expected`` as items, arrays of one shape.
    """
    return {name: relative_error(getattr(solution, name), expected[name]) for name in VARIABLES}


def relative_error(value, expected):
    """|value/expected - 1|, elementwise; numbers below ``SMALLEST`` are equal to each other."""
    larger = np.maximum(np.abs(expected), SMALLEST)
    nothing = (np.abs(value) < SMALLEST) & (np.abs(expected) < SMALLEST)
    with np.errstate(over="ignore"):
        error = np.where(nothing, 0.0, np.abs(value - expected) / larger)
    return np.where(np.isnan(error), np.inf, error)
