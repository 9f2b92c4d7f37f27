"""The atlas: every combination of many conditions, in a file of ``tb.stream`` for each
roughness."""

import json
from os import PathLike
from pathlib import Path

import xarray as xr

from thirdbody.netcdf import identity

CHUNKS = "results/atlas/chunks"


def open_atlas(folder: str | PathLike = CHUNKS) -> xr.Dataset:
    """Open the atlas as one dataset; its values are read from the files when they are used.

    Parameters
    ----------
    folder : path
        The folder of the files that ``snakemake atlas`` has made.

    Returns
    -------
    xarray.Dataset
        What ``tb.grid`` returns, over all five axes.  Select with ``sel`` and ``isel`` before using
        values: the whole may be larger than memory.

    Raises
    ------
    OSError
        If the folder has no files, or a file cannot be read.
    ValueError
        If the files have different inputs of the model, variables, ``rtol`` or axes.

    Examples
    --------
    A_sa,t* of particles of 500 nm under the load nearest to 10 N, between dry surfaces::

        atlas = open_atlas()
        dry = atlas["particle_contact_area_ratio"].sel(viscosity=0.0, particle_diameter=5e-7)
        dry.swap_dims(load="normal_load").sel(normal_load=10, method="nearest")
    """
    files = sorted(Path(folder).glob("*.nc"))
    if not files:
        raise FileNotFoundError(f"{folder} has no files; make them: snakemake -c2 atlas")
    chunks = [xr.open_dataset(file, engine="netcdf4", chunks={}) for file in files]
    chunks.sort(key=lambda chunk: chunk["roughness"].item())
    inputs, *others = (json.loads(chunk.attrs["model_parameters"]) for chunk in chunks)
    for name in [name for name, value in inputs.items() if isinstance(value, list)]:
        inputs[name] = sum((other.pop(name) for other in others), inputs[name])
    first = chunks[0]
    for chunk, other in zip(chunks[1:], others, strict=True):
        is_alike = other.items() <= inputs.items() and chunk.attrs["rtol"] == first.attrs["rtol"]
        if not is_alike or set(chunk.data_vars) != set(first.data_vars):
            sigma = chunk["roughness"].item()
            raise ValueError(
                f"roughness {sigma:g} m in {folder} was solved with other inputs, "
                "variables or rtol than the first; allowed: files of one configuration"
            )
    atlas = xr.concat(
        chunks,
        "roughness",
        data_vars="minimal",
        coords="minimal",
        compat="override",
        join="exact",
        combine_attrs="drop_conflicts",
    )
    for name in atlas.coords:
        atlas[name].encoding["_FillValue"] = None  # when written: no value is missing
    return atlas.assign_attrs(
        title="Atlas of three-body contact",
        model_parameters=json.dumps(inputs),
        **identity(" ".join(chunk.attrs["configuration_sha256"] for chunk in chunks)),
    )
