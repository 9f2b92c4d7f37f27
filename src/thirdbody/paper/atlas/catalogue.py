"""All files of the atlas as one lazily loaded dataset, and the design charts in it.

Any program that reads NetCDF can concatenate the files along ``roughness``.  A chart shows limits over the
load, one curve per roughness, with ensemble ranges, as they are in the atlas.
"""

import json
from collections.abc import Iterator, Mapping, Sequence
from os import PathLike
from pathlib import Path

import numpy as np
import xarray as xr

from thirdbody.attributes import identity
from thirdbody.core.regimes import SOLUTION_STATUSES
from thirdbody.files import unreadable
from thirdbody.variables import AXES, CONDITION_AXES, DIMENSIONS, STATUS

CHUNKS = "results/atlas/chunks"
CHARTS = {  # the variable of the atlas in each
    "largest_particle": "largest_particle_diameter",
    "least_viscosity": "least_viscosity",
}


def open_atlas(folder: str | PathLike = CHUNKS) -> xr.Dataset:
    """Open the atlas as one dataset; its values are read from the files when they are used.

    Parameters
    ----------
    folder : path
        The folder of the files that ``snakemake atlas`` has made.

    Returns
    -------
    xarray.Dataset
        Over all five axes: variables for the default inputs as in every dataset, and results of the
        ensemble; the attribute ``ensemble`` has the members.  Select with ``sel`` and ``isel``
        before using values: the whole may be larger than memory.

    Raises
    ------
    OSError
        In one line, unless the folder has all files of one atlas, which can be read.

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
    parts = sorted(map(_opened, files), key=lambda part: part["roughness"].values[0])
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


def chart_panels(atlas: xr.Dataset, name: str, charts: Mapping) -> list[xr.Dataset]:
    """The panels of a chart, one of ``CHARTS``, by ``charts`` of ``config/atlas.yaml``: ``limit`` over
    ``load`` and ``roughness`` [SI], ``range`` also over ``quantile``, ``solution_status`` of the
    nearest point, the conditions as coordinates, and as attribute ``ends`` of the limit in the atlas.
    """
    variable = CHARTS[name]
    curves = [AXES["roughness"].to_si(value) for value in charts["roughness_nm"]]
    (along,) = (each for each in DIMENSIONS if each not in atlas[variable].dims)
    ends = atlas[along].values[atlas[along].values > 0.0][[0, -1]]
    panels = []
    for given in charts[name]:
        held = {
            axis.name: axis.to_si(given[axis.alias])
            for axis in CONDITION_AXES
            if axis.alias in given
        }
        found = {"limit": variable, "range": f"{variable}_range", STATUS: STATUS}
        shown = xr.Dataset({name: atlas[of] for name, of in found.items()})
        shown = shown.sel(held, method="nearest").sel(roughness=curves, method="nearest").load()
        # an unknown limit is put at the last value
        nearest = shown["limit"].fillna(ends[1]).clip(*ends)
        status = shown[STATUS].sel({along: nearest}, method="nearest").drop_vars(along)
        panels.append(shown.drop_dims(along).assign({STATUS: status}).assign_attrs(ends=ends))
    return panels


def chart_rows(panels: Sequence[xr.Dataset], newtons: Sequence[float]) -> Iterator[dict]:
    """Rows of the table of a chart: one for each panel, roughness and load of ``newtons`` [N]."""
    for panel in panels:
        held = [axis for axis in CONDITION_AXES if axis.name in panel.coords]
        for surface in panel["roughness"].values:
            for load in newtons:
                place = int(np.abs(panel["normal_load"].values - load).argmin())
                point = panel.isel(load=place).sel(roughness=surface)
                yield {
                    **{axis.column: float(point[axis.name]) for axis in held},
                    **{"load_N": load, "load": float(point["load"])},
                    "limit": float(point["limit"]),
                    **dict(zip(("low", "median", "high"), point["range"].values.tolist())),
                    STATUS: SOLUTION_STATUSES[int(point[STATUS])],
                }
