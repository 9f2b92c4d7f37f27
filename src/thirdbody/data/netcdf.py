"""Datasets as NetCDF-4 files: the same dataset gives the same bytes."""

from __future__ import annotations

import errno
from collections.abc import Collection, Mapping
from os import PathLike
from typing import Any

import xarray as xr

from thirdbody.data.conditions import DIMENSIONS
from thirdbody.data.quantities import FILL_FLAG, FILL_FLOAT, QUANTITIES, STATUS


def write_dataset(dataset: xr.Dataset, path: str | PathLike) -> None:
    """Write a dataset of points.

    Where a figure shows no point, numbers become ``FILL_FLOAT``; where a point has no solution, they
    stay nan.

    Parameters
    ----------
    dataset : xarray.Dataset
        One of ``grid``, ``scene_dataset`` or ``band``.
    path : path
        NetCDF-4 file to write; one that is there is replaced.

    Raises
    ------
    OSError
        If the file cannot be written.

    Examples
    --------
    >>> import tempfile
    >>> import thirdbody as tb
    >>> axes = dict(viscosity=0.0, particle_diameter=3e-7, roughness=3e-7, particle_density=1e11)
    >>> points = tb.grid(load=1e-5, **axes, parameters=tb.load_parameters())
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     write_dataset(points, f"{folder}/points.nc")
    ...     again = read_dataset(f"{folder}/points.nc")
    >>> bool(again["separation"].values == points["separation"].values)
    True
    """
    # Level 6 without shuffle is within 0.2 % of the smallest file.
    compression = {"zlib": True, "complevel": 6, "shuffle": False}
    encoding = {
        name: compression | {"chunksizes": variable.shape}
        for name, variable in dataset.data_vars.items()
    }
    shown = dataset[STATUS] != FILL_FLAG if STATUS in dataset else True
    # The fill value is an attribute, not an encoding, which would replace every nan by it.
    filled = {
        name: variable.where(shown, FILL_FLOAT).assign_attrs(_FillValue=FILL_FLOAT)
        for name, variable in dataset.data_vars.items()
        if variable.dtype.kind == "f"
    }
    write_netcdf(dataset.assign(filled), path, encoding)


def write_netcdf(
    dataset: xr.Dataset, path: str | PathLike, encoding: Mapping[str, Mapping[str, Any]]
) -> None:
    """Write any ``dataset``, ``encoding`` as of ``xarray.Dataset.to_netcdf``; ``OSError`` if that fails."""
    unfilled = {
        name: {"_FillValue": None}
        for name, variable in dataset.variables.items()
        if "_FillValue" not in variable.attrs
    }
    storage = {
        name: unfilled.get(name, {}) | dict(encoding.get(name, {})) for name in dataset.variables
    }
    try:
        dataset.to_netcdf(path, engine="netcdf4", format="NETCDF4", encoding=storage)
    except RuntimeError as error:
        raise OSError(errno.EIO, str(error), str(path)) from None


def read_dataset(path: str | PathLike) -> xr.Dataset:
    """Read a dataset of ``write_dataset``; where it shows no point, it holds nan and ``FILL_FLAG``.

    Raises
    ------
    OSError
        If the file is absent, damaged, or holds something else: one line names it.
    """
    dataset = load(path)
    missing = [name for name in (*DIMENSIONS, *QUANTITIES) if name not in dataset]
    if missing and not all(f"{name}_low" in dataset for name in QUANTITIES):
        raise unreadable(path, f"no {missing[0]}")
    return dataset


def load(path: str | PathLike, needed: Collection[str] = ()) -> xr.Dataset:
    """Read any NetCDF file into memory; ``OSError`` in one line if it is damaged or lacks a name."""
    try:
        dataset = xr.load_dataset(path, engine="netcdf4").drop_encoding()
    except Exception as error:  # each kind of damage raises an exception of its own
        raise unreadable(path, type(error).__name__) from None
    for name in needed:
        if name not in dataset:
            raise unreadable(path, f"no {name}")
    return dataset


def unreadable(path: str | PathLike, reason: str) -> OSError:
    """The error for a damaged product, with the command that makes it again."""
    return OSError(f"{path} cannot be read ({reason}); remake it: snakemake -c2 --force {path}")
