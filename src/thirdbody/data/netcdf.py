"""Datasets as NetCDF-4 files: written so that the same dataset gives the same bytes, and read."""

from __future__ import annotations

import errno
from collections.abc import Collection, Mapping
from os import PathLike

import netCDF4  # noqa: F401  xarray would import it at the first file
import xarray as xr

from thirdbody.data.conditions import DIMENSIONS
from thirdbody.data.quantities import QUANTITIES


def write_dataset(dataset: xr.Dataset, path: str | PathLike) -> None:
    """Write a dataset of points: the same dataset gives the same bytes.

    Its values are written as they are, those that hold ``FILL_FLOAT`` or ``FILL_FLAG`` being the
    missing ones: the nan of an unsolved point stays what it is.

    Parameters
    ----------
    dataset : xarray.Dataset
        One of ``grid``, ``scene_dataset`` or ``band``.
    path : path
        NetCDF-4 file to write; one that is there is replaced.

    Raises
    ------
    OSError
        If there is no room or no right, however the library below says so.

    Examples
    --------
    >>> import tempfile
    >>> import thirdbody as tb
    >>> axes = dict(viscosity=0.0, particle_diameter=3e-7, roughness=3e-7, particle_density=1e11)
    >>> points = tb.grid(load=1e-5, **axes, parameters=tb.load_parameters())
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     write_dataset(points, f"{folder}/points.nc")
    ...     again = read_dataset(f"{folder}/points.nc")
    >>> bool(again["separation"] == points["separation"])
    True
    """
    # smallest of what every NetCDF-4 library reads, by benchmarks/measure_compression.py,
    # to 0.2 %: level 9 takes half as long again to write
    compressed = {"zlib": True, "complevel": 6, "shuffle": False}
    encoding = {name: {"_FillValue": None} for name in dataset.coords}
    encoding |= {
        name: compressed | {"chunksizes": dataset[name].shape} for name in dataset.data_vars
    }
    write_netcdf(dataset, path, encoding)


def read_dataset(path: str | PathLike) -> xr.Dataset:
    """A dataset of ``write_dataset``, in memory; where it holds no point, nan and ``FILL_FLAG``.

    Parameters
    ----------
    path : path
        NetCDF-4 file of a dataset, or of the band around one.

    Raises
    ------
    OSError
        If the file is absent, damaged, or holds something else: one line names it.

    Examples
    --------
    See ``write_dataset``.
    """
    dataset = load(path)
    missing = [name for name in (*DIMENSIONS, *QUANTITIES) if name not in dataset.variables]
    if missing and not all(f"{name}_low" in dataset for name in QUANTITIES):
        raise unreadable(path, f"no {missing[0]}")
    return dataset


def write_netcdf(dataset: xr.Dataset, path: str | PathLike, encoding: Mapping) -> None:
    """Write any ``dataset`` with the ``encoding`` of each variable; ``OSError`` if that fails."""
    try:
        dataset.to_netcdf(path, engine="netcdf4", format="NETCDF4", encoding=encoding)
    except RuntimeError as error:
        raise OSError(errno.EIO, str(error), str(path)) from None


def load(path: str | PathLike, needed: Collection[str] = ()) -> xr.Dataset:
    """Any NetCDF file, in memory; ``OSError`` in one line if it cannot be read or lacks a name."""
    try:
        with xr.open_dataset(path, engine="netcdf4") as dataset:
            loaded = dataset.load()
    except Exception as error:  # each kind of damage has an exception of its own below
        raise unreadable(path, type(error).__name__) from None
    for name in needed:
        if name not in loaded.variables:
            raise unreadable(path, f"no {name}")
    return loaded


def unreadable(path: str | PathLike, reason: str) -> OSError:
    """The error of a product that is damaged: it says how to make it again."""
    return OSError(f"{path} cannot be read ({reason}); remake it: snakemake -c2 --force {path}")
