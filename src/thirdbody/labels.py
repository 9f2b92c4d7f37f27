"""Labelled solutions: the results of ``Solution.to_dataset`` and ``Solution.to_dataframe``."""

from collections.abc import Mapping
from typing import Any, Protocol

import numpy as np
import pandas as pd
import xarray as xr
from numpy.typing import ArrayLike

from thirdbody.conditions import from_si
from thirdbody.core.regimes import FLAG_MEANINGS, STATES, codes_to_name
from thirdbody.ensembles import MEMBER, Ensemble
from thirdbody.netcdf import coordinate_attributes, variable_attributes
from thirdbody.notes import area_note
from thirdbody.variables import CONDITIONS, NORMAL_LOAD, VARIABLES, decimal

POINT = "point"  # a dimension along which several conditions vary, or none does


class Points(Protocol):
    """Solved points, as ``Solution`` has them."""

    @property
    def variables(self) -> Mapping[str, Any]:
        """The variables by name."""

    @property
    def conditions(self) -> Mapping[str, Any]:
        """The conditions by name, SI."""

    @property
    def keys(self) -> Mapping[str, str]:
        """The name of each condition in tables."""

    @property
    def parameters(self) -> Ensemble:
        """The inputs."""

    @property
    def has_members(self) -> bool:
        """Whether the first dimension is that of members."""

    @property
    def index(self) -> pd.Index | None:
        """The index of columns of pandas."""


def labelled_dataset(solution: Points) -> xr.Dataset:
    """The variables and conditions of a solution, and the load in newtons.

    A dimension has the name of the only condition that varies along it.
    """
    return _with_rows(_labelled(solution), solution.index)


def _labelled(solution) -> xr.Dataset:
    variables, conditions = solution.variables, solution.conditions
    first = next(iter(variables.values()), None)
    labelled = first if isinstance(first, xr.DataArray) else None
    plain = [values for values in conditions.values() if not isinstance(values, xr.DataArray)]
    shape = np.broadcast_shapes(*map(np.shape, (*variables.values(), *plain)))
    of_points = shape[1:] if solution.has_members else shape
    names = [MEMBER] if solution.has_members else []
    names += _dimensions(of_points, conditions) if labelled is None else []
    dimensions = names if labelled is None else labelled.dims
    coordinates = {} if labelled is None else dict(labelled.coords)
    ensemble = solution.parameters
    if solution.has_members:
        coordinates[MEMBER] = MEMBER, np.arange(len(ensemble.members))
    for name, values in conditions.items():
        if name not in coordinates:
            attributes = coordinate_attributes(CONDITIONS[name], solution.keys[name])
            coordinates[name] = *_placed(values, dimensions, shape), attributes
    described = {}
    for name, values in variables.items():
        array = np.asarray(values).astype(np.int8 if name in STATES else float)
        described[name] = dimensions, array, variable_attributes(VARIABLES[name])
    dataset = xr.Dataset(described, coordinates)
    newtons = dataset["load"].variable * ensemble.newtons_per_load
    if solution.has_members and solution.keys["load"] != "load_N":  # each member has its own
        per_load = [member.newtons_per_load for member in ensemble.members]
        newtons = xr.Variable(MEMBER, per_load) * dataset["load"].variable
    newtons.attrs = coordinate_attributes(NORMAL_LOAD)
    return dataset.assign_coords(normal_load=newtons)


def labelled_frame(solution: Points) -> pd.DataFrame:
    """A solution as a table: one row per point, flags by name.

    Conditions have the names by which they were given, variables their SI unit behind their name.
    """
    dataset = _labelled(solution)
    flat = dataset if dataset.sizes else dataset.expand_dims(POINT)
    labels = [name for name in flat.dims if name in flat.coords]
    others = [name for name in flat.coords if name not in labels]
    frame = flat.to_dataframe().reset_index()[[*labels, *others, *solution.variables]]
    for name, codes in codes_to_name({name: frame[name] for name in solution.variables}).items():
        frame[name] = pd.Categorical.from_codes(codes, FLAG_MEANINGS[name])
    headings = {name: column_name(name) for name in solution.variables}
    headings |= solution.keys
    for name, key in solution.keys.items():
        frame[name] = decimal(from_si(key, frame[name], solution.parameters.newtons_per_load))
    headings[NORMAL_LOAD.name] = "load_N"
    if solution.keys["load"] == "load_N":
        frame = frame.drop(columns=NORMAL_LOAD.name)
    frame = frame.rename(columns=headings)
    frame.attrs["notes"] = [area_note(solution.parameters)]
    return indexed(frame, solution.index, range(len(frame)))


def column_name(variable: str) -> str:
    """The name of a variable in tables: with its unit, if it has one."""
    unit = VARIABLES[variable].unit
    return variable if unit == "1" else f"{variable}_{unit}"


def indexed(table: pd.DataFrame, index: pd.Index | None, points: ArrayLike) -> pd.DataFrame:
    """A table whose rows belong to ``points``, flat indices into an array with the rows of
    ``index`` along its last axis, with the labels of these rows; unchanged if ``index`` is None."""
    if index is None:
        return table
    return table.set_index(index.take(np.asarray(points, int) % max(len(index), 1)))


def _with_rows(dataset, index):
    """A dataset with the ``index`` of the points along its last dimension as a coordinate, one for
    each level, of its name or else ``row``; as text where netCDF has no such type.  Unchanged if
    ``index`` is None."""
    if index is None:
        return dataset
    dimension, size = [*dataset.sizes.items()][-1]
    rows = index.take(np.arange(size) % max(len(index), 1))
    labels: dict[str, tuple] = {}
    for level, name in enumerate(rows.names):
        if name is None or name in (*dataset.variables, *labels):
            name = "row" if rows.nlevels == 1 else f"row_{level}"
        values = np.asarray(rows.get_level_values(level))
        labels[str(name)] = dimension, values.astype(str) if values.dtype == object else values
    return dataset.assign_coords(labels)


def _dimensions(shape, conditions) -> list[str]:
    """A name for each axis of the points: the condition, if only one varies along it and along no
    other.
    """
    varying = [
        [name for name, values in conditions.items() if axis in _axes(np.shape(values), shape)]
        for axis in range(-len(shape), 0)
    ]
    along = [name for names in varying for name in names]
    owners = [
        names[0] if len(names) == 1 and along.count(names[0]) == 1 else None for names in varying
    ]
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
