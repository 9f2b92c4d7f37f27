"""Measured errors and times as one dataset over method, relative error asked for, and class."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import xarray as xr

from benchmarks.points import CLASS, VARIABLES
from thirdbody.data.attributes import software_version
from thirdbody.data.tables import TABLES

COORDINATES = {
    "method": "library, or the baseline that it is measured against",
    "rtol": "relative error asked for",
    "medium": "dry or lubricated",
    "bodies": "bodies in contact",
    "span": "usual: the ranges of Table 2; or extremes",
    "variable": "variable of the datasets",
}
OF_ERRORS = ("points", "unsolved", "beyond_rtol", "largest_error", "percentile_99_error")
OF_TIMES = ("microseconds_per_point", "setup_seconds", "peak_memory_MB")


def accuracy_dataset(
    errors: Sequence[Mapping[str, Any]], times: Sequence[Mapping[str, Any]]
) -> xr.Dataset:
    """Put errors and times into one dataset.

    Parameters
    ----------
    errors, times : sequence of mapping
        Rows of the tables of these names.

    Returns
    -------
    xarray.Dataset
        The numbers of both tables as variables over method, ``rtol``, medium, bodies and span,
        those of ``errors`` over the variable of the solution as well; nan where the tables have no
        row.  A method that is not asked for an ``rtol`` has the same value at each.

    Examples
    --------
    >>> kind = {"medium": "dry", "bodies": "two_body", "span": "usual"}
    >>> cost = {"microseconds_per_point": 1.5, "setup_seconds": 0.01, "peak_memory_MB": 2.0}
    >>> measured = accuracy_dataset([], [{"method": "library", "rtol": 1e-9, **kind, **cost}])
    >>> measured["microseconds_per_point"].item()
    1.5
    """
    axes = {name: _values(times, name) for name in ("method", "rtol", *CLASS)}
    with_variables = {**axes, "variable": list(VARIABLES)}
    variables = _arrays(errors, with_variables, "errors", OF_ERRORS)
    variables |= _arrays(times, axes, "times", OF_TIMES)
    coordinates = {
        name: (name, values, {"long_name": COORDINATES[name], "units": "1"})
        for name, values in with_variables.items()
    }
    attributes = {
        "Conventions": "CF-1.11",
        "title": "Errors and times of the solver and of two baselines",
        "source": "points solved in multiple precision; processor time of one core",
        "license": "CC-BY-4.0",
        "software_version": software_version(),
    }
    return xr.Dataset(variables, coordinates, attributes)


def _values(rows, name):
    """Different values of a column, in order of appearance; None is none."""
    return list(dict.fromkeys(row[name] for row in rows if row[name] is not None))


def _arrays(rows, axes, table, names):
    """A variable over ``axes`` for each of ``names``, columns of ``table``."""
    columns = {column.name: column for column in TABLES[table]}
    shape = [len(values) for values in axes.values()]
    arrays = {name: np.full(shape, np.nan) for name in names}
    for row in rows:
        place = tuple(
            slice(None) if row[name] is None else values.index(row[name])
            for name, values in axes.items()
        )
        for name in names:
            arrays[name][place] = np.nan if row[name] is None else row[name]
    return {
        name: (
            list(axes),
            array,
            {"units": columns[name].unit, "long_name": columns[name].description},
        )
        for name, array in arrays.items()
    }
