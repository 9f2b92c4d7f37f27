"""All files of the atlas as one dataset, of which only what is used is read.

The catalogue, a small JSON file beside the folder of the chunks, says which files there are and which
roughnesses each holds.  Any program that reads NetCDF can put them together along ``roughness``.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from os import PathLike
from pathlib import Path

import numpy as np
import xarray as xr
from numpy.typing import NDArray
from xarray.backends import BackendArray
from xarray.core import indexing

from thirdbody.data.attributes import identity
from thirdbody.data.netcdf import unreadable

CHUNKS, FILE, ROUGHNESS = "chunks", "file", "roughness_m"  # keys
ALONG = "roughness"


def write_catalogue(path: str | PathLike, chunks: Sequence[str | PathLike]) -> None:
    """Write the catalogue of the files ``chunks``, with their places relative to the catalogue's own.

    Parameters
    ----------
    path : path
        File to write.
    chunks : sequence of path
        Those of ``thirdbody.atlas.chunk.write_chunk``, in any order.

    Raises
    ------
    OSError
        If a file cannot be read: one line names it.
    """
    listed = []
    for chunk in chunks:
        with _opened(chunk) as dataset:
            listed.append(
                {
                    FILE: Path(chunk).relative_to(Path(path).parent).as_posix(),
                    ROUGHNESS: dataset[ALONG].values.tolist(),
                }
            )
    listed.sort(key=lambda each: each[ROUGHNESS])
    Path(path).write_text(json.dumps({CHUNKS: listed}, indent=2) + "\n", encoding="utf-8")


def open_atlas(path: str | PathLike = "results/atlas/catalogue.json") -> xr.Dataset:
    """Open the atlas as one dataset; its values are read from the files when they are used.

    Parameters
    ----------
    path : path
        The catalogue, a product of ``snakemake atlas``.

    Returns
    -------
    xarray.Dataset
        Over all five axes: variables under the default inputs as in every dataset, and what the
        ensemble says beside them; ``ensemble`` among its attributes names the members.  Pick with
        ``sel`` and ``isel`` before values are used: all of them may be larger than memory.

    Raises
    ------
    OSError
        If a file is absent, damaged or something else: one line names it.

    Examples
    --------
    The probability that 10 N press particles of 500 nm between dry surfaces::

        atlas = tb.open_atlas()
        dry = atlas["particle_surface_probability"].sel(viscosity=0.0)
        dry.swap_dims(load="normal_load").sel(normal_load=10, particle_diameter=5e-7)
    """
    path = Path(path)
    try:
        listed = json.loads(path.read_text(encoding="utf-8"))[CHUNKS]
        files = [path.parent / each[FILE] for each in listed]
    except (ValueError, TypeError, KeyError) as error:
        raise unreadable(path, type(error).__name__) from None
    parts = [_opened(file) for file in files]
    first = parts[0]
    ends = np.cumsum([part.sizes[ALONG] for part in parts])
    coordinates = dict(first.coords)
    surfaces = np.concatenate([part[ALONG].values for part in parts])
    coordinates[ALONG] = (ALONG, surfaces, first[ALONG].attrs)
    variables = {}
    for name, variable in first.data_vars.items():
        joined = _Joined([part[name].variable for part in parts], ends)
        values = indexing.LazilyIndexedArray(joined)
        variables[name] = xr.Variable(variable.dims, values, variable.attrs)
    attributes = first.attrs | {
        "title": "Atlas of three-body contact",
        "model_parameters": _joined_parameters(parts),
        **identity(" ".join(part.attrs["configuration_sha256"] for part in parts)),
    }
    dataset = xr.Dataset(variables, coordinates, attributes)
    for name in dataset.coords:
        dataset.variables[name].encoding["_FillValue"] = (
            None  # where it is written: none is missing
        )
    dataset.set_close(lambda: [part.close() for part in parts])
    return dataset


def _opened(path) -> xr.Dataset:
    """The dataset of a file, whose values are read when they are used and then forgotten."""
    try:
        return xr.open_dataset(path, engine="netcdf4", cache=False)
    except Exception as error:  # each kind of damage has an exception of its own below
        raise unreadable(path, type(error).__name__) from None


def _joined_parameters(parts) -> str:
    """The attribute ``model_parameters`` of all surfaces: its lists run along the roughness."""
    each = [json.loads(part.attrs["model_parameters"]) for part in parts]
    joined = {
        name: sum((some[name] for some in each), []) if isinstance(value, list) else value
        for name, value in each[0].items()
    }
    return json.dumps(joined)


class _Joined(BackendArray):
    """A variable of several files, one behind the other along the roughness.

    Parameters
    ----------
    parts : sequence of xarray.Variable
        Of each file, unread.
    ends : array
        Where each part ends along the roughness.
    """

    def __init__(self, parts: Sequence[xr.Variable], ends: NDArray[np.int64]):
        self.parts, self.ends = parts, ends
        self.axis = parts[0].dims.index(ALONG)
        sizes = parts[0].sizes | {ALONG: int(ends[-1])}
        self.shape, self.dtype = tuple(sizes.values()), parts[0].dtype

    def __getitem__(self, key):
        return indexing.explicit_indexing_adapter(
            key, self.shape, indexing.IndexingSupport.OUTER, self._read
        )

    def _read(self, key):
        """What ``key`` picks, a number, slice or array of places for each axis."""
        places = np.arange(self.shape[self.axis])[key[self.axis]]
        asked = np.atleast_1d(places)
        owners = np.searchsorted(self.ends, asked, side="right")
        pieces = []
        for owner in np.unique(owners) if owners.size else [0]:
            own = asked[owners == owner] - (self.ends[owner - 1] if owner else 0)
            within = (*key[: self.axis], own, *key[self.axis + 1 :])
            picked = dict(zip(self.parts[owner].dims, within, strict=True))
            pieces.append(self.parts[owner].isel(picked).values)
        axis = sum(np.ndim(each) > 0 or isinstance(each, slice) for each in key[: self.axis])
        values = np.concatenate(pieces, axis=axis)
        # pieces are in the order of the files, each in the order that was asked for
        back = np.argsort(np.argsort(owners, kind="stable"), kind="stable")
        values = np.take(values, back, axis=axis) if len(pieces) > 1 else values
        return values if np.ndim(places) else np.take(values, 0, axis=axis)
