"""One file of the atlas: some surfaces, in the layout of every dataset, with the ensemble."""

import csv
import json
import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from os import PathLike
from pathlib import Path
from typing import Any

import netCDF4
import numpy as np
import xarray as xr

from thirdbody.attributes import described_grid
from thirdbody.core.parameters import Parameters
from thirdbody.core.regimes import BOUNDARY_LIMIT, PARTICLE_LIMIT
from thirdbody.core.state import type_of
from thirdbody.grids import Axes
from thirdbody.netcdf import declare
from thirdbody.paper.atlas.surfaces import QUANTILES, solve_surface
from thirdbody.variables import AXES, CONDITION_AXES, DIMENSIONS, FLAGS
from thirdbody.version import Version

SAFE_DIGITS = 2  # written in addition to the requested ones
APART = "roughness", "particle_density"  # each pair of them is solved and stored on its own
QUANTILE = "quantile"
COMMENT = (
    "load is F_t* of the default inputs, those of model_parameters, and normal_load belongs to it. "
    "Each member of the ensemble is solved at the same normal_load, which is another F_t* where its "
    "apparent area differs; turning_point_load is F_t* of each member's own area. ensemble gives what "
    "differs from the default in each member, by the names of config/inputs.yaml, SI. A probability is "
    "the fraction of the members; a _range has quantiles of those members that have a value."
)


def axis_values(axis: Mapping) -> list[float]:
    """The values [unit of the key] of an axis of ``config/atlas.yaml``, increasing, to twelve digits."""
    space = np.geomspace if axis["scale"] == "logarithmic" else np.linspace
    spaced = space(axis["from"], axis["to"], axis["count"])
    return sorted({float(f"{value:.12g}") for value in (*spaced, *axis["also"])})


def atlas_axes(configured: Mapping[str, Mapping]) -> Axes:
    """The five axes of ``config/atlas.yaml``, increasing, SI; the load is F_t [N]."""
    others = {
        axis.name: axis.values(axis_values(configured[axis.alias])) for axis in CONDITION_AXES
    }
    return {"load": np.array(axis_values(configured["load_N"])), **others}


def write_chunk(
    path: str | PathLike,
    axes: Axes,
    default: Parameters,
    members: Sequence[Mapping[str, Any]],
    kept: Collection[str],
    rtol: float,
    version: Version | None = None,
) -> None:
    """Solve some surfaces of the atlas for all inputs, and write the results part by part.

    ``axes`` are those of ``atlas_axes``, with some of the roughnesses.  ``members`` are the inputs of
    each member of the ensemble that differ from the default, SI; the quantities ``kept`` are stored
    at each point for the default.  The ``version`` of the software is by default that of what runs.
    """
    members = members or [{}]  # without an ensemble, only the default
    ensemble = [replace(default, **member) for member in members]
    sets = list(dict.fromkeys([default, *ensemble]))
    weights = [ensemble.count(each) for each in sets]
    with netCDF4.Dataset(path, "w", format="NETCDF4") as file:
        described = _described(axes, default, members, kept, rtol, version)
        variables = declare(file, described, _storage(described, kept, rtol))
        for indices in np.ndindex(*(axes[name].size for name in APART)):
            place = {name: slice(index, index + 1) for name, index in zip(APART, indices)}
            part = {name: axis[place.get(name, slice(None))] for name, axis in axes.items()}
            for name, values in solve_surface(part, sets, weights, kept, rtol).items():
                index = (place.get(each, slice(None)) for each in variables[name].dimensions)
                variables[name][tuple(index)] = values


def _storage(described, kept, rtol) -> dict[str, dict[str, Any]]:
    """Storage of variables: a chunk for each part, with the known digits."""
    lengths = {**described.sizes, **dict.fromkeys(APART, 1)}
    rounding = {
        "significant_digits": math.ceil(-math.log10(rtol)) + SAFE_DIGITS,
        "quantize_mode": "GranularBitRound",
    }
    return {
        name: {
            "zlib": True,
            "complevel": 1,
            "shuffle": name in kept,  # groups the zeros of omitted digits
            "chunksizes": [lengths[each] for each in variable.dims],
            **(rounding if name in kept else {}),
        }
        for name, variable in described.data_vars.items()
    }


def _described(axes, default, members, kept, rtol, version) -> xr.Dataset:
    """Coordinates, attributes and empty variables of the file."""
    shape = [axis.size for axis in axes.values()]
    empty = {name: np.broadcast_to(np.zeros((), type_of(name)), shape) for name in (*kept, *FLAGS)}
    loads = {"load": axes["load"] / default.newtons_per_load}
    described = described_grid({**axes, **loads}, empty, default, rtol, version=version).to_xarray()
    # the normal loads as given, without rounding
    described["normal_load"].values[:] = axes["load"]
    quantiles = {"units": "1", "long_name": "fraction of the ensemble below"}
    described = described.assign_coords({QUANTILE: (QUANTILE, QUANTILES, quantiles)})
    for name, dimensions, attributes in _findings(len(members)):
        sizes = [described.sizes[each] for each in dimensions]
        kind = np.int16 if "scale_factor" in attributes else float
        described[name] = dimensions, np.broadcast_to(np.zeros((), kind), sizes), attributes
    ends = (AXES["roughness"].from_si(end) for end in axes["roughness"][[0, -1]])
    return described.assign_attrs(
        title=f"Atlas of three-body contact, roughness {' to '.join(f'{e:.4g} nm' for e in ends)}",
        comment=f"{described.attrs['comment']}. {COMMENT}",
        ensemble=json.dumps([dict(member) for member in members]),
    )


def _findings(members: int) -> Iterator[tuple[str, tuple[str, ...], dict[str, Any]]]:
    """Name, dimensions and attributes of the results of ``solve_surface``: the rows of
    ``chunk.csv``, and the range of each that is not a fraction; fractions are stored as counts."""
    limits = {"particle_limit": PARTICLE_LIMIT, "boundary_limit": BOUNDARY_LIMIT}
    with open(Path(__file__).with_suffix(".csv"), encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    for row in rows:
        name, without = row.pop("name"), row.pop("without").split()
        dimensions = tuple(each for each in DIMENSIONS if each not in without)
        attributes = {key: text.format(**limits) for key, text in row.items() if text}
        attributes["coverage_content_type"] = "modelResult"
        if name.endswith("_probability"):
            yield name, dimensions, attributes | {"scale_factor": 1.0 / members}
        else:
            ranged = {"long_name": f"{attributes['long_name']}: quantiles of the ensemble"}
            yield name, dimensions, attributes
            yield f"{name}_range", (QUANTILE, *dimensions), attributes | ranged
