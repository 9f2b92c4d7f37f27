"""The atlas: solutions of every combination of many conditions.  Each roughness has a file, made by
``tb.stream``."""

import json
from functools import partial
from os import PathLike
from pathlib import Path

import xarray as xr

from thirdbody.core.regimes import states_of
from thirdbody.lazy import TEXT
from thirdbody.netcdf import described_variable, finished, identity
from thirdbody.variables import DIMENSIONS, FLAGS

CHUNKS = "results/atlas/chunks"


def open_atlas(folder: str | PathLike = CHUNKS) -> xr.Dataset:
    """Open the atlas as one dataset, which reads values from the files when they are used.

    Parameters
    ----------
    folder : path
        The folder of the files that ``snakemake atlas`` has made.

    Returns
    -------
    xarray.Dataset
        A dataset as from ``tb.grid``, over all five axes.  Select conditions with ``sel`` and
        ``isel`` before using values: all values may be larger than memory.

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
                f"roughness {sigma:g} m in {folder} was solved with other inputs, variables or "
                "rtol than the first; allowed: files of one configuration"
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
    for name in FLAGS.keys() & atlas.keys():
        states = atlas[name].data.map_blocks(partial(states_of, name), dtype=TEXT)
        atlas[name] = described_variable(name, DIMENSIONS, states)
    return finished(atlas).assign_attrs(
        title="Atlas of three-body contact",
        model_parameters=json.dumps(inputs),
        **identity(" ".join(chunk.attrs["configuration_sha256"] for chunk in chunks)),
    )
