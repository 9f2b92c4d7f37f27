"""All files of the atlas as one lazily loaded dataset.

Any program that reads NetCDF can concatenate the files along ``roughness``.
"""

import json
from os import PathLike
from pathlib import Path

import xarray as xr

from thirdbody.attributes import identity

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
        Over all five axes: variables for the default inputs as in every dataset, and fractions of the
        ensemble in each regime and mode; the attribute ``ensemble`` has the members.  Select with ``sel`` and ``isel``
        before using values: the whole may be larger than memory.

    Raises
    ------
    OSError
        Unless the folder has all files of one atlas, which can be read.

    Examples
    --------
    The probability that 10 N press particles of 500 nm between dry surfaces::

        atlas = open_atlas()
        dry = atlas["particle_surface_probability"].sel(viscosity=0.0)
        dry.swap_dims(load="normal_load").sel(normal_load=10, particle_diameter=5e-7)
    """
    files = sorted(Path(folder).glob("*.nc"))
    names = {f"{number}-of-{len(files)}.nc" for number in range(1, len(files) + 1)}
    if not files or {file.name for file in files} != names:
        raise FileNotFoundError(
            f"{folder} does not have all files of one atlas and no others; make them: snakemake -c2 atlas"
        )
    opened = (xr.open_dataset(file, engine="netcdf4", chunks={}) for file in files)
    parts = sorted(opened, key=lambda part: part["roughness"].values[0])
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
