"""Labelled solutions: the results of ``Solution.to_dataset`` and ``Solution.to_dataframe``."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr

from thirdbody.attributes import coordinate_attributes, variable_attributes
from thirdbody.conditions import from_si, unit_text
from thirdbody.core.regimes import FLAG_MEANINGS, codes_to_name
from thirdbody.tabular import indexed, with_rows
from thirdbody.variables import AXES, NORMAL_LOAD, VARIABLES, decimal

if TYPE_CHECKING:
    from thirdbody.points import Solution

RATIOS = "load", "film_thickness"  # dimensionless, unlike others of this name
POINT = "point"  # a dimension along which several conditions vary, or none does


def labelled_dataset(solution: Solution) -> xr.Dataset:
    """The variables and conditions of a solution, and the load in newtons.

    A dimension has the name of the only condition that varies along it.
    """
    return with_rows(_labelled(solution), solution.index)


def _labelled(solution) -> xr.Dataset:
    variables, conditions = solution.variables, solution.conditions
    first = next(iter(variables.values()), None)
    labelled = isinstance(first, xr.DataArray)
    plain = [values for values in conditions.values() if not isinstance(values, xr.DataArray)]
    shape = np.broadcast_shapes(*map(np.shape, (*variables.values(), *plain)))
    dimensions = first.dims if labelled else _dimensions(shape, conditions)
    coordinates = dict(first.coords) if labelled else {}
    for name, values in conditions.items():
        if name not in coordinates:
            attributes = coordinate_attributes(AXES[name], solution.keys[name])
            coordinates[name] = *_placed(values, dimensions, shape), attributes
    described = {
        name: (dimensions, np.asarray(values), variable_attributes(VARIABLES[name]))
        for name, values in variables.items()
    }
    dataset = xr.Dataset(described, coordinates)
    newtons = dataset["load"].variable * solution.newtons_per_load
    newtons.attrs = coordinate_attributes(NORMAL_LOAD)
    return dataset.assign_coords(normal_load=newtons)


def labelled_frame(solution: Solution) -> pd.DataFrame:
    """A solution as a table: one row per point, flags by name.

    Headings have units: of conditions those in which they were given, of variables SI.
    """
    dataset = _labelled(solution)
    flat = dataset if dataset.sizes else dataset.expand_dims(POINT)
    labels = [name for name in flat.dims if name in flat.coords]
    others = [name for name in flat.coords if name not in labels]
    frame = flat.to_dataframe().reset_index()[[*labels, *others, *flat.data_vars]]
    for name, codes in codes_to_name({name: frame[name] for name in flat.data_vars}).items():
        frame[name] = pd.Categorical.from_codes(codes, FLAG_MEANINGS[name])
    headings = {name: flat[name].attrs.get("units") for name in frame.columns}
    for name, key in solution.keys.items():
        headings[name] = unit_text(key)
        frame[name] = decimal(from_si(key, frame[name], solution.newtons_per_load))
    if solution.keys["load"] == "load_N":
        frame = frame.drop(columns=NORMAL_LOAD.name)
    headings = {
        name: f"{name} [{unit}]"
        for name, unit in headings.items()
        if unit and (unit != "1" or name in RATIOS)
    }
    frame = frame.rename(columns=headings)
    return indexed(frame, solution.index, range(len(frame)))


def _dimensions(shape, conditions) -> list[str]:
    """A name for each axis of the points: the condition, if only one varies along it and along no other."""
    varying = [
        [name for name, values in conditions.items() if axis in _axes(np.shape(values), shape)]
        for axis in range(-len(shape), 0)
    ]
    owners = [names[0] if len(names) == 1 else None for names in varying]
    owners = [name if owners.count(name) == 1 else None for name in owners]
    if owners.count(None) == 1:
        return [name or POINT for name in owners]
    return [name or f"{POINT}_{axis}" for axis, name in enumerate(owners)]


def _placed(values, dimensions, shape):
    """Dimensions and values of a condition, without the axes along which it is constant."""
    if isinstance(values, xr.DataArray):
        return values.dims, values.values
    axes = _axes(np.shape(values), shape)
    repeated = tuple(axis for axis in range(-np.ndim(values), 0) if axis not in axes)
    return [dimensions[axis] for axis in axes], np.squeeze(values, repeated)


def _axes(sizes, shape) -> list[int]:
    """Axes (negative) of an array of ``sizes`` that are as long as those of ``shape``."""
    return [axis for axis in range(-len(sizes), 0) if sizes[axis] == shape[axis]]
