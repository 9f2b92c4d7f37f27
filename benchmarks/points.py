"""Points whose solutions are known in multiple precision, and how far a solution is from them.

Such *golden* points are read from the files of ``tests/golden``.  Each row holds every input of the
model, the conditions of a point and its solution to 25 digits.
"""

from __future__ import annotations

import csv
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import NDArray

from thirdbody.data.conditions import DIMENSIONS
from thirdbody.model.parameters import Parameters
from thirdbody.solver.solution import QUANTITIES

VARIABLES = QUANTITIES  # of the solution: those that the files give
CLASS = ("medium", "bodies", "span")  # columns that tell the class of a point
SMALLEST = np.finfo(float).tiny  # smaller numbers have few digits in float64 and count as zero


@dataclass(frozen=True)
class Group:
    """Golden points with the same inputs and roughness, which are solved as one array.

    Attributes
    ----------
    parameters : Parameters
        Their inputs of the model.
    rows : list of dict
        Their lines of the file, as text by name of the column.
    conditions : dict of array, shape (rows,)
        Their conditions, by the names of the arguments of ``thirdbody.solve`` and in its units.
    expected : dict of array, shape (rows,)
        Their solutions, by the names of ``VARIABLES``.
    """

    parameters: Parameters
    rows: list[dict[str, str]]
    conditions: dict[str, NDArray[np.float64]]
    expected: dict[str, NDArray[np.float64]]

    def take(self, chosen: Sequence[int]) -> Group:
        """The points at the indices ``chosen``, as a group."""
        return Group(
            self.parameters,
            [self.rows[index] for index in chosen],
            {name: values[chosen] for name, values in self.conditions.items()},
            {name: values[chosen] for name, values in self.expected.items()},
        )


def read_rows(path: str | PathLike) -> list[dict[str, str]]:
    """Lines of a file of golden points, as text by name of the column."""
    with open(path, encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def grouped(rows: Iterable[dict[str, str]]) -> list[Group]:
    """Sort golden points into groups with the same inputs.

    Parameters
    ----------
    rows : iterable of dict
        As ``read_rows`` returns them.

    Returns
    -------
    list of Group
        In the order in which their inputs appear first.

    Raises
    ------
    ValueError
        If the inputs of a row are not physical.
    """
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


def parameters_of(row: Mapping[str, str]) -> Parameters:
    """Inputs of the model in a row of ``read_rows``, for a surface of its own roughness.

    Raises
    ------
    ValueError
        If they are not physical.
    """
    return Parameters.on_one_surface(row, float(row["roughness"]))


def relative_errors(
    solution: Any, expected: Mapping[str, NDArray[np.float64]]
) -> dict[str, NDArray[np.float64]]:
    """Relative errors of all variables of a solution.

    Parameters
    ----------
    solution : object
        Has ``VARIABLES`` as attributes: arrays.
    expected : mapping
        The right values: arrays of the same shape, by the names of ``VARIABLES``.

    Returns
    -------
    dict of array
        As ``relative_error``, by the names of ``VARIABLES``.
    """
    return {name: relative_error(getattr(solution, name), expected[name]) for name in VARIABLES}


def relative_error(
    value: NDArray[np.float64], expected: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Relative error |value/expected - 1|, elementwise.

    Parameters
    ----------
    value, expected : array
        What was found and what is right, of the same unit and shape.

    Returns
    -------
    array
        Errors [1]: 0 where both numbers are below the least normal float64, infinite where
        either is nan.

    Examples
    --------
    >>> relative_error(np.array([1.5, 1e-320, np.nan]), np.array([1.0, 0.0, 1.0]))
    array([0.5, 0. , inf])
    """
    larger = np.maximum(np.abs(expected), SMALLEST)
    nothing = (np.abs(value) < SMALLEST) & (np.abs(expected) < SMALLEST)
    with np.errstate(over="ignore"):
        error = np.where(nothing, 0.0, np.abs(value - expected) / larger)
    return np.where(np.isnan(error), np.inf, error)
