"""All files of the atlas as one dataset, of which only what is used is read.

The catalogue, a small JSON file beside the folder of the chunks, says which files there are and which
roughnesses each holds.  Any program that reads NetCDF can put them together along ``roughness``.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from os import PathLike
from pathlib import Path

import xarray as xr

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
    parts = []
    for file in files:
        with _opened(file) as part:
            parts.append(part.attrs)
    dataset = xr.open_mfdataset(
        files,
        engine="netcdf4",
        combine="nested",
        concat_dim=ALONG,
        data_vars="minimal",
        coords="minimal",
        compat="override",
        join="override",
    )
    for name in dataset.coords:
        dataset[name].encoding["_FillValue"] = None  # where it is written: none is missing
    return dataset.assign_attrs(
        title="Atlas of three-body contact",
        model_parameters=_joined_parameters(parts),
        **identity(" ".join(part["configuration_sha256"] for part in parts)),
    )


def _opened(path) -> xr.Dataset:
    """The dataset of a file."""
    try:
        return xr.open_dataset(path, engine="netcdf4", cache=False)
    except Exception as error:  # each kind of damage has an exception of its own below
        raise unreadable(path, type(error).__name__) from None


def _joined_parameters(parts) -> str:
    """The attribute ``model_parameters`` of all surfaces: its lists run along the roughness."""
    each = [json.loads(part["model_parameters"]) for part in parts]
    joined = {
        name: sum((some[name] for some in each), []) if isinstance(value, list) else value
        for name, value in each[0].items()
    }
    return json.dumps(joined)
