"""Datasets of solved variables, with the attributes that CF-1.11 and ACDD-1.3 require, and their
NetCDF-4 files.  The same dataset gives the same bytes.

``PlainDataset`` and ``PlainVariable`` have the attributes of ``Dataset`` and ``Variable`` in
xarray.  xarray itself is not imported: importing it and pandas takes longer than solving or drawing
a figure.
"""

import errno
import hashlib
import json
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias, Union

import netCDF4
import numpy as np
from numpy.typing import NDArray

from thirdbody.core.parameters import Parameters
from thirdbody.core.particles import mean_and_largest
from thirdbody.core.regimes import NO_FLAG
from thirdbody.files import unreadable
from thirdbody.variables import (
    AXES,
    CONDITION_AXES,
    CONDITIONS,
    DIMENSIONS,
    NORMAL_LOAD,
    STATUS,
    VARIABLES,
    Axis,
    Variable,
)

if TYPE_CHECKING:
    import xarray as xr


# Values of points that a figure does not show.  For numbers this is the fill value of NetCDF.  For
# flags it is an ordinary value that means not_shown: xarray would convert integers with fill values
# to floats.
FILL_FLOAT = 9.969209968386869e36
FILL_FLAG = np.int8(-127)
# attributes that describe how a file stores numbers
OF_THE_FILE = "_FillValue", "missing_value", "scale_factor", "add_offset", "_Unsigned"
# attributes of every dataset in their order; null where they depend on its content
EVERYWHERE = json.loads(Path(__file__).with_suffix(".json").read_text(encoding="utf-8"))
# keys of the attribute model_parameters, by the fields of ``Parameters`` and of ``Surface``
KEYS = EVERYWHERE["model_parameters"]


class PlainVariable(NamedTuple):
    """An array with named dimensions, attributes and encoding, in a form that xarray accepts."""

    dims: tuple[str, ...]
    values: NDArray
    attrs: Mapping[str, Any] = {}
    encoding: Mapping[str, Any] = {}  # the fill value in a file


@dataclass(frozen=True, eq=False)
class PlainDataset:
    """Variables over shared dimensions, coordinates and attributes, with the interface of
    ``xarray.Dataset``: functions accept either."""

    data_vars: Mapping[str, PlainVariable]
    coords: Mapping[str, PlainVariable]
    attrs: Mapping[str, Any]

    @property
    def variables(self) -> dict[str, PlainVariable]:
        """Variables and coordinates, in the order of a file."""
        return {**self.data_vars, **self.coords}

    @property
    def sizes(self) -> dict[str, int]:
        each = self.variables.values()
        return {name: size for one in each for name, size in zip(one.dims, one.values.shape)}

    def __contains__(self, name: str) -> bool:
        return name in self.variables

    def __getitem__(self, name: str) -> PlainVariable:
        return self.variables[name]

    def to_xarray(self) -> "xr.Dataset":
        import xarray as xr

        return xr.Dataset(self.data_vars, self.coords, self.attrs)


def finished(dataset: "xr.Dataset") -> "xr.Dataset":
    """The ``dataset`` as users get it: ``sel`` also takes conditions under their alias.

    Coordinates get no fill value in a file (CF 2.5.1).
    """
    for name, axis in CONDITIONS.items():
        if axis.alias in dataset.coords and dataset[axis.alias].dims == (name,):
            dataset = dataset.set_xindex(axis.alias)
    for coordinate in dataset.coords.values():
        coordinate.encoding["_FillValue"] = None
    return dataset


Dataset: TypeAlias = Union[PlainDataset, "xr.Dataset"]  # functions accept either


def write_dataset(dataset: Dataset, path: str | PathLike) -> None:
    """Write a dataset as NetCDF-4.  ``FILL_FLOAT`` and ``FILL_FLAG`` mark points that are not
    shown, and unsolved points stay nan.  Raises ``OSError`` if the disk is full or not writable."""
    # Variables are within 0.2 % of the smallest size that every NetCDF-4 library reads.  Level 9
    # takes 50 % longer to write.
    compressed = {"zlib": True, "complevel": 6, "shuffle": False}
    storage = {
        str(name): compressed | {"chunksizes": variable.values.shape}
        for name, variable in dataset.data_vars.items()
    }
    try:
        with netCDF4.Dataset(path, "w", format="NETCDF4") as file:
            for name, stored in declare(file, dataset, storage).items():
                stored[:] = dataset[name].values
    except RuntimeError as error:
        raise OSError(errno.EIO, str(error), str(path)) from None


def declare(
    file: netCDF4.Dataset, dataset: Dataset, storage: Mapping[str, Mapping]
) -> dict[str, netCDF4.Variable]:
    """Write a dataset to a new file, except the values of its variables.  Returns these variables,
    still empty, by name.  ``storage`` has the arguments of ``netCDF4.Dataset.createVariable`` for
    each variable."""
    file.setncatts(dataset.attrs)
    for name, size in dataset.sizes.items():
        file.createDimension(str(name), size)
    declared = {}
    for key, variable in dataset.data_vars.items():
        name = str(key)
        declared[name] = _added(file, name, variable, **storage[name])
        beside = [  # coordinates along the dimensions of this variable, under other names
            str(other)
            for other, coordinate in dataset.coords.items()
            if other not in coordinate.dims and set(coordinate.dims) <= set(variable.dims)
        ]
        if beside:
            declared[name].coordinates = " ".join(beside)
    for name, coordinate in dataset.coords.items():
        # numbers in chunks lie in the file itself, which others can then check
        stored = _added(file, name, coordinate, chunksizes=coordinate.values.shape)
        stored[:] = coordinate.values
    return declared


def _added(file, name, variable, **storage) -> netCDF4.Variable:
    """Add a variable to a file that has its dimensions."""
    kind, fill = variable.values.dtype, variable.encoding.get("_FillValue")
    added = file.createVariable(name, kind, variable.dims, fill_value=fill, **storage)
    added.setncatts(variable.attrs)
    added.set_auto_maskandscale(False)
    return added


def read_plain(path: str | PathLike, needed: Collection[str] = DIMENSIONS) -> PlainDataset:
    """Read a NetCDF file.  Packed numbers are decoded, and fill values of floats become nan.

    Raises ``OSError`` in one line if the file is missing or damaged, or lacks ``needed`` variables.
    """
    coordinates: set[str] = set()
    variables: dict[str, PlainVariable] = {}
    try:
        with netCDF4.Dataset(path) as file:
            coordinates.update(file.dimensions)
            for name, stored in file.variables.items():
                attributes = dict(stored.__dict__)
                coordinates.update(attributes.pop("coordinates", "").split())
                for each in OF_THE_FILE:
                    attributes.pop(each, None)
                values = np.ma.asanyarray(stored[...])
                values = values.filled(np.nan) if values.dtype.kind == "f" else values.data
                variables[name] = PlainVariable(stored.dimensions, values, attributes)
            attributes = dict(file.__dict__)
    except Exception as error:  # netCDF4 raises various exceptions for damaged files
        reason = getattr(error, "strerror", None) or type(error).__name__
        raise unreadable(path, reason) from None
    for name in needed:
        if name not in variables:
            raise unreadable(path, f"no {name}")
    coords = {name: variables.pop(name) for name in [*variables] if name in coordinates}
    return PlainDataset(variables, coords, attributes)


def coordinate_attributes(
    described: Variable, parameters: Parameters | None = None
) -> dict[str, str]:
    """Attributes of a coordinate: the normal load, or a condition.

    With the ``parameters`` that were solved, the particle size has the mean and the largest.
    """
    attributes = {
        "units": described.unit,
        "long_name": described.label,
        "symbol": described.symbol,
    }
    if parameters is not None and described.name == "particle_diameter":
        mean, largest = mean_and_largest(1.0, parameters)
        attributes["comment"] = (
            f"with these inputs the mean of the sizes is {mean:.3g} x_a, "
            f"the largest, X_max, {largest:.3g} x_a"
        )
    return attributes


def alias_attributes(axis: Axis, parameters: Parameters | None = None) -> dict[str, str]:
    """Attributes of a condition under its alias."""
    described = NORMAL_LOAD if axis.name == "load" else axis
    return coordinate_attributes(described, parameters) | {"units": axis.alias_unit}


def described_variable(name: str, dims: Iterable[Any], values: NDArray) -> PlainVariable:
    """The variable ``name`` of a dataset.

    A flag has codes and their meanings, as in files of ``stream`` and of the workflow, or names.
    A point that a figure does not show has a fill value in a file.
    """
    quantity = VARIABLES[name]
    attributes: dict[str, Any] = coordinate_attributes(quantity)
    attributes |= {"equation": quantity.equation}
    encoding: dict[str, Any] = {}
    if values.dtype == object:
        del attributes["units"]
        attributes["coverage_content_type"] = "qualityInformation"
    elif quantity.meanings:
        named = dict(enumerate(quantity.meanings))
        named |= {} if quantity.name == STATUS else {int(NO_FLAG): "without_values"}
        named |= {int(FILL_FLAG): "not_shown"}
        attributes["flag_values"] = np.array([*named], dtype=np.int8)
        attributes["flag_meanings"] = " ".join(named.values())
        attributes["coverage_content_type"] = "qualityInformation"
    else:
        attributes["ancillary_variables"] = STATUS
        attributes["coverage_content_type"] = "modelResult"
        encoding["_FillValue"] = FILL_FLOAT
    if quantity.comment:
        attributes["comment"] = quantity.comment
    return PlainVariable(tuple(dims), values, attributes, encoding)


def identity(origin: str) -> dict[str, str]:
    """The SHA-256 of an ``origin`` text, and the dataset id derived from it."""
    digest = hashlib.sha256(origin.encode()).hexdigest()
    return {"configuration_sha256": digest, "id": f"thirdbody-{digest[:16]}"}


def model_attribute(parameters: Parameters, roughness: Iterable[float] | None) -> str:
    """The attribute ``model_parameters`` of a dataset with the coordinate ``roughness`` [m].

    It is a flat JSON object in SI.  Values that depend on the roughness are lists.  If the
    roughness is None, no axis of the dataset, their power laws replace them: inputs by their names.
    """
    model = {key: getattr(parameters, name) for name, key in KEYS["body"].items()}
    if roughness is None:
        others = KEYS["body"] | KEYS["particles"]
        model |= {name: it for name, it in parameters.as_dict().items() if name not in others}
    else:
        surfaces = [parameters.surface(float(sigma)) for sigma in roughness]
        for name, key in KEYS["surface"].items():
            model[key] = [getattr(surface, name) for surface in surfaces]
    model["phi_a"] = "centred" if parameters.mean_ratio > 0.0 else "uncentred"
    model |= {key: getattr(parameters, name) for name, key in KEYS["particles"].items()}
    return json.dumps(model)


def attributes_of(
    parameters: Parameters, roughness: Iterable[float] | None, **known: Any
) -> dict[str, Any]:
    """Attributes of a dataset: those of every dataset, the ``known`` ones and the inputs."""
    inputs = {"model_parameters": model_attribute(parameters, roughness)}
    attributes = {**EVERYWHERE, **known, **inputs}
    return {name: value for name, value in attributes.items() if value is not None}


def described_grid(
    axes: Mapping[str, NDArray],
    values: Mapping[str, NDArray],
    parameters: Parameters,
    rtol: float,
    title: str = "Three-body contact on a grid",
    request: Mapping | None = None,
) -> PlainDataset:
    """The dataset of ``values`` with coordinates and attributes.

    ``values`` has an array over all ``axes`` for each variable.  The SHA-256 in the attributes
    depends on the parameters, ``rtol`` and ``request``, which by default are the axes.
    """
    variables = {
        name: described_variable(name, DIMENSIONS, values[name])
        for name in VARIABLES
        if name in values
    }
    coordinates = {
        name: PlainVariable((name,), axis, coordinate_attributes(AXES[name], parameters))
        for name, axis in axes.items()
    }
    newtons = axes["load"] * parameters.newtons_per_load
    coordinates["normal_load"] = PlainVariable(
        ("load",), newtons, coordinate_attributes(NORMAL_LOAD)
    )
    configuration = {"parameters": parameters.as_dict(), "rtol": rtol}
    configuration["request"] = request or {name: axis.tolist() for name, axis in axes.items()}
    known = identity(json.dumps(configuration, sort_keys=True)) | {"title": title, "rtol": rtol}
    attributes = attributes_of(parameters, axes["roughness"], **known)
    return PlainDataset(variables, coordinates, attributes)


def curves_of(dataset: Dataset) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """The conditions of the curves in a dataset, and the index of these curves in its variables.

    A curve has at least one point with a status.  The conditions are in SI, in the order of
    ``CONDITION_AXES``, of shape (4, curves).  The index comes after the load axis:
    ``values[:, index]``.
    """
    shown = np.logical_or.reduce(dataset[STATUS].values >= 0)
    axes = [dataset[axis.name].values for axis in CONDITION_AXES]
    conditions = np.stack([grid[shown] for grid in np.meshgrid(*axes, indexing="ij")])
    return conditions, shown
