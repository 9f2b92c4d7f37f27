"""Datasets of the workflow and their NetCDF-4 files; the same dataset gives the same bytes.

They have the names of xarray, but do not import it: importing xarray and pandas takes longer than
solving or drawing a figure.
"""

import errno
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from os import PathLike
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias, Union

import netCDF4
import numpy as np
from numpy.typing import NDArray

from thirdbody.files import unreadable
from thirdbody.variables import DIMENSIONS

if TYPE_CHECKING:
    import xarray as xr


# Values of points that a figure does not show: the fill values of NetCDF.  For a flag it is a value
# with a meaning, not_shown, because xarray converts integers with missing values to floats.
FILL_FLOAT = 9.969209968386869e36
FILL_FLAG = np.int8(-127)
# attributes that say how a file stores numbers
OF_THE_FILE = "_FillValue", "missing_value", "scale_factor", "add_offset", "_Unsigned"


class Variable(NamedTuple):
    """An array with named dimensions, attributes and encoding, in a form that xarray accepts."""

    dims: tuple[str, ...]
    values: NDArray
    attrs: Mapping[str, Any] = {}
    encoding: Mapping[str, Any] = {}  # of a file: its fill value


@dataclass(frozen=True, eq=False)
class PlainDataset:
    """Variables over shared dimensions, coordinates and attributes, with the interface of
    ``xarray.Dataset``: functions accept either."""

    data_vars: Mapping[str, Variable]
    coords: Mapping[str, Variable]
    attrs: Mapping[str, Any]

    @property
    def variables(self) -> dict[str, Variable]:
        """Variables and coordinates, in the order of a file."""
        return {**self.data_vars, **self.coords}

    @property
    def sizes(self) -> dict[str, int]:
        each = self.variables.values()
        return {name: size for one in each for name, size in zip(one.dims, one.values.shape)}

    def __contains__(self, name: str) -> bool:
        return name in self.variables

    def __getitem__(self, name: str) -> Variable:
        return self.variables[name]

    def to_xarray(self) -> "xr.Dataset":
        import xarray as xr

        return xr.Dataset(self.data_vars, self.coords, self.attrs)


Dataset: TypeAlias = Union[PlainDataset, "xr.Dataset"]  # functions accept either


def write_dataset(dataset: Dataset, path: str | PathLike) -> None:
    """Write a dataset as NetCDF-4: ``FILL_FLOAT`` and ``FILL_FLAG`` mark missing values, and
    unsolved points stay nan.  Raises ``OSError`` if the disk is full or not writable."""
    # smallest size, within 0.2 %, that every NetCDF-4 library reads; level 9 takes 50 % longer to
    # write
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
    """Write a dataset to a new file, except the values of its variables, which are returned empty;
    ``storage`` has arguments of ``netCDF4.Dataset.createVariable`` for each."""
    file.setncatts(dataset.attrs)
    for name, size in dataset.sizes.items():
        file.createDimension(str(name), size)
    declared = {}
    for key, variable in dataset.data_vars.items():
        name = str(key)
        declared[name] = _added(file, name, variable, **storage[name])
        beside = [  # coordinates along its dimensions that have other names
            str(other)
            for other, coordinate in dataset.coords.items()
            if other not in coordinate.dims and set(coordinate.dims) <= set(variable.dims)
        ]
        if beside:
            declared[name].coordinates = " ".join(beside)
    for name, coordinate in dataset.coords.items():
        _added(file, name, coordinate)[:] = coordinate.values
    return declared


def _added(file, name, variable, **storage) -> netCDF4.Variable:
    """Add a variable to a file that has its dimensions."""
    kind, fill = variable.values.dtype, variable.encoding.get("_FillValue")
    added = file.createVariable(name, kind, variable.dims, fill_value=fill, **storage)
    added.setncatts(variable.attrs)
    added.set_auto_maskandscale(False)
    return added


def read_plain(path: str | PathLike, needed: Collection[str] = DIMENSIONS) -> PlainDataset:
    """Read a NetCDF file, with packed numbers decoded and nan for their fill values; ``OSError`` in
    one line if it is missing, damaged, or lacks ``needed`` variables."""
    coordinates: set[str] = set()
    variables: dict[str, Variable] = {}
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
                variables[name] = Variable(stored.dimensions, values, attributes)
            attributes = dict(file.__dict__)
    except Exception as error:  # netCDF4 raises different exceptions for different damage
        reason = getattr(error, "strerror", None) or type(error).__name__
        raise unreadable(path, reason) from None
    for name in needed:
        if name not in variables:
            raise unreadable(path, f"no {name}")
    coords = {name: variables.pop(name) for name in [*variables] if name in coordinates}
    return PlainDataset(variables, coords, attributes)
