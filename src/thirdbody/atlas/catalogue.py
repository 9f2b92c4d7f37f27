"""All files of the atlas as one lazily loaded dataset.

The catalogue, a small JSON file beside the folder of the chunks, lists the files and their
roughnesses.  Any program that reads NetCDF can concatenate them along ``roughness``.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from os import PathLike
from pathlib import Path

import xarray as xr

from thirdbody.data.attributes import identity
from thirdbody.data.files import unreadable


def write_catalogue(path: str | PathLike, chunks: Sequence[str | PathLike]) -> None:
    """Write the catalogue of the files ``chunks``, with paths relative to it.

    Raises ``OSError`` in one line if a file cannot be read.
    """
    listed = []
    for chunk in chunks:
        place = Path(chunk).relative_to(Path(path).parent).as_posix()
        with _opened(chunk) as dataset:
            listed.append({"file": place, "roughness_m": dataset["roughness"].values.tolist()})
    listed.sort(key=lambda each: each["roughness_m"])
    Path(path).write_text(json.dumps({"chunks": listed}, indent=2) + "\n", encoding="utf-8")


def open_atlas(path: str | PathLike = "results/atlas/catalogue.json") -> xr.Dataset:
    """Open the atlas as one dataset; its values are read from the files when they are used.

    Parameters
    ----------
    path : path
        The catalogue, a product of ``snakemake atlas``.

    Returns
    -------
    xarray.Dataset
        Over all five axes: variables for the default inputs as in every dataset, and results of the
        ensemble; the attribute ``ensemble`` has the members.  Select with ``sel`` and ``isel``
        before using values: the whole may be larger than memory.

    Raises
    ------
    OSError
        In one line, if a file is missing, damaged or of another kind.

    Examples
    --------
    The probability that 10 N press particles of 500 nm between dry surfaces::

        atlas = tb.open_atlas()
        dry = atlas["particle_surface_probability"].sel(viscosity=0.0)
        dry.swap_dims(load="normal_load").sel(normal_load=10, particle_diameter=5e-7)
    """
    path = Path(path)
    try:
        listed = json.loads(path.read_text(encoding="utf-8"))["chunks"]
        files = [path.parent / each["file"] for each in listed]
    except (ValueError, TypeError, KeyError) as error:
        raise unreadable(path, type(error).__name__) from None
    parts = [_opened(file) for file in files]
    dataset = xr.concat(
        parts,
        "roughness",
        data_vars="minimal",
        coords="minimal",
        compat="override",
        join="override",
        combine_attrs="override",
    )
    for name in dataset.coords:
        dataset[name].encoding["_FillValue"] = None  # when written: no value is missing
    # lists in the inputs of the model are along the roughness
    inputs, *others = (json.loads(part.attrs["model_parameters"]) for part in parts)
    for name in (name for name, value in inputs.items() if isinstance(value, list)):
        inputs[name] = sum((other[name] for other in others), inputs[name])
    return dataset.assign_attrs(
        title="Atlas of three-body contact",
        model_parameters=json.dumps(inputs),
        **identity(" ".join(part.attrs["configuration_sha256"] for part in parts)),
    )


def _opened(path: str | PathLike) -> xr.Dataset:
    try:
        return xr.open_dataset(path, engine="netcdf4", chunks={})
    except Exception as error:  # netCDF4 raises different exceptions for different damage
        raise unreadable(path, type(error).__name__) from None
