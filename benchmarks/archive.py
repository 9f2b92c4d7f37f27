"""The measured errors and times as one dataset over method, rtol and class of points."""

from __future__ import annotations

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


def accuracy_dataset(errors, times) -> xr.Dataset:
    """Rows of the tables ``errors`` and ``times`` as arrays; nan where a table says nothing.

    A method that is not asked for an ``rtol`` has the same value at each.
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
    """Values of a column in order of appearance."""
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
