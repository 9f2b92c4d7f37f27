"""Points known to 25 digits (*golden* points, in ``tests/golden``) and the errors of solutions at them."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Mapping
from os import PathLike
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

import thirdbody as tb
from thirdbody.data.attributes import parameters_on_one_surface
from thirdbody.data.conditions import DIMENSIONS
from thirdbody.solver.solution import QUANTITIES as VARIABLES

CLASS = ("medium", "bodies", "span")
SMALLEST = np.finfo(float).tiny  # smaller numbers have few digits in float64 and count as zero


class Group(NamedTuple):
    """Golden points of one class with the same inputs; arrays of shape (rows,)."""

    parameters: tb.Parameters
    rows: list[dict[str, str]]
    conditions: dict[str, NDArray]  # arguments of ``thirdbody.solve``
    expected: dict[str, NDArray]  # by ``VARIABLES``


def read_rows(path: str | PathLike) -> list[dict[str, str]]:
    """Rows of a file of golden points, as text by column."""
    with open(path, encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def grouped(rows: Iterable[dict[str, str]]) -> list[Group]:
    """Golden points with the same inputs and class together; ``ValueError`` if inputs are not physical."""
    shared = {}
    for row in rows:
        kind = tuple(row.get(name) for name in CLASS)
        shared.setdefault((parameters_of(row), kind), []).append(row)
    return [
        Group(parameters, members, _columns(members, DIMENSIONS), _columns(members, VARIABLES))
        for (parameters, _), members in shared.items()
    ]


def _columns(rows, names):
    """Numbers by column, nan where a row leaves one empty."""
    return {name: np.array([float(row[name] or "nan") for row in rows]) for name in names}


def parameters_of(row: Mapping[str, str]) -> tb.Parameters:
    """Inputs of the model in a row; ``ValueError`` if they are not physical."""
    return parameters_on_one_surface(row, float(row["roughness"]))


def relative_error(value: NDArray, expected: NDArray) -> NDArray[np.float64]:
    """|value/expected - 1| [1]: 0 where both are below the least normal float64, infinite where either is nan."""
    larger = np.maximum(np.abs(expected), SMALLEST)
    nothing = (np.abs(value) < SMALLEST) & (np.abs(expected) < SMALLEST)
    with np.errstate(over="ignore"):
        error = np.where(nothing, 0.0, np.abs(value - expected) / larger)
    return np.where(np.isnan(error), np.inf, error)
