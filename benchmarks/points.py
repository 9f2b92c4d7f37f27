"""Points known to 25 digits (*golden* points, in ``tests/golden``) and the errors of solutions at
them.
"""

import csv
from collections.abc import Iterable, Mapping
from os import PathLike
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

import thirdbody as tb
from thirdbody.netcdf import KEYS
from thirdbody.variables import DIMENSIONS, QUANTITIES

VARIABLES = tuple(QUANTITIES)
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
    """Golden points in groups that share inputs and class.

    Raises ``ValueError`` if inputs are not physical.
    """
    shared = {}
    for row in rows:
        kind = tuple(row.get(name) for name in CLASS)
        parameters = parameters_on_one_surface(row, float(row["roughness"]))
        shared.setdefault((parameters, kind), []).append(row)
    return [
        Group(parameters, members, _columns(members, DIMENSIONS), _columns(members, VARIABLES))
        for (parameters, _), members in shared.items()
    ]


def _columns(rows, names):
    """Numbers by column, nan where a row leaves one empty."""
    return {name: np.array([float(row[name] or "nan") for row in rows]) for name in names}


def parameters_on_one_surface(model: Mapping, roughness: float) -> tb.Parameters:
    """The inputs in ``model``, whose summits are those of one surface, of ``roughness`` [m].

    ``model`` has the keys of ``model_parameters``; older datasets lack ``particle_plane``.
    """
    model = {"particle_plane": "surface", **model}
    kinds = tb.Parameters.__annotations__
    given = {
        name: float(model[key]) if kinds[name] is float else model[key]
        for name, key in (KEYS["body"] | KEYS["particles"]).items()
    }
    density, radius, deviation, offset = (float(model[key]) for key in KEYS["surface"].values())
    return tb.Parameters(
        **given,
        reference_roughness=roughness,
        summit_parameter=density * radius * roughness,
        summit_parameter_exponent=0.0,
        summit_radius=radius,
        summit_radius_exponent=0.0,
        summit_deviation_ratio=deviation / roughness,
        summit_offset_ratio=offset / roughness,
    )


def relative_error(value: NDArray, expected: NDArray) -> NDArray[np.float64]:
    """|value/expected - 1| [1]: 0 where both are below the least normal float64, infinite where
    either is nan.
    """
    larger = np.maximum(np.abs(expected), SMALLEST)
    nothing = (np.abs(value) < SMALLEST) & (np.abs(expected) < SMALLEST)
    with np.errstate(over="ignore"):
        error = np.where(nothing, 0.0, np.abs(value - expected) / larger)
    return np.where(np.isnan(error), np.inf, error)
