"""One file of the atlas: some surfaces, in the layout of every dataset, with the ensemble."""

import json
import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from os import PathLike
from typing import Any

import netCDF4
import numpy as np
import xarray as xr
from numpy.typing import NDArray

from thirdbody.attributes import described_grid
from thirdbody.core.parameters import Parameters
from thirdbody.core.state import type_of
from thirdbody.grids import Axes, grid
from thirdbody.netcdf import declare
from thirdbody.variables import AXES, CONDITION_AXES, DIMENSIONS, FLAGS, STATUS

SAFE_DIGITS = 2  # written in addition to the requested ones
APART = "roughness", "particle_density"  # each pair of them is solved and stored on its own
# what is in a regime, and in a mode
KINDS = {"lubrication_regime": "lubrication", "contact_mode": "contact"}
STATES = {  # the variables with the fraction of the members in each regime and mode
    f"{state}_probability": (flag, state) for flag in KINDS for state in FLAGS[flag].meanings
}
COMMENT = (
    "load is F_t* of the default inputs, those of model_parameters, and normal_load belongs to it. "
    "Each member of the ensemble is solved at the same normal_load, which is another F_t* where its "
    "apparent area differs. ensemble gives what differs from the default in each member, by the names "
    "of config/inputs.yaml, SI. A probability is the fraction of the members."
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
) -> None:
    """Solve some surfaces of the atlas for all inputs, and write the results part by part.

    ``axes`` are those of ``atlas_axes``, with some of the roughnesses.  ``members`` are the inputs of
    each member of the ensemble that differ from the default, SI; the quantities ``kept`` are stored
    at each point for the default.
    """
    members = members or [{}]  # without an ensemble, only the default
    ensemble = [replace(default, **member) for member in members]
    sets = list(dict.fromkeys([default, *ensemble]))
    weights = [ensemble.count(each) for each in sets]
    with netCDF4.Dataset(path, "w", format="NETCDF4") as file:
        described = _described(axes, default, members, kept, rtol)
        variables = declare(file, described, _storage(described, kept, rtol))
        for indices in np.ndindex(*(axes[name].size for name in APART)):
            place = {name: slice(index, index + 1) for name, index in zip(APART, indices)}
            part = {name: axis[place.get(name, slice(None))] for name, axis in axes.items()}
            index = tuple(place.get(name, slice(None)) for name in DIMENSIONS)
            for name, values in _solved(part, sets, weights, kept, rtol).items():
                variables[name][index] = values


def _solved(
    axes: Axes,
    sets: Sequence[Parameters],
    weights: Sequence[int],
    kept: Collection[str],
    rtol: float,
) -> dict[str, NDArray]:
    """Variables of the atlas by name: those ``kept`` and the flags for the first of the ``sets`` of
    inputs, and how many members are in each regime and mode, each set as often as its weight."""
    names = [*kept, *FLAGS]
    values: dict[str, NDArray] = {}
    for parameters, weight in zip(sets, weights, strict=True):
        own = {**axes, "load": axes["load"] / parameters.newtons_per_load}
        solved = grid(parameters=parameters, rtol=rtol, variables=names, progress=False, **own)
        if not values:
            values = {name: solved[name].values for name in names}
            values |= {name: np.zeros(solved[STATUS].shape, np.int16) for name in STATES}
        for name, (flag, state) in STATES.items():
            values[name] += weight * (solved[flag].values == FLAGS[flag].meanings.index(state))
    return values


def _storage(described, kept, rtol) -> dict[str, dict[str, Any]]:
    """Storage of variables: a chunk for each part, with the known digits."""
    lengths = [1 if name in APART else described.sizes[name] for name in DIMENSIONS]
    rounding = {
        "significant_digits": math.ceil(-math.log10(rtol)) + SAFE_DIGITS,
        "quantize_mode": "GranularBitRound",
    }
    return {
        name: {
            "zlib": True,
            "complevel": 1,
            "shuffle": name in kept,  # groups the zeros of omitted digits
            "chunksizes": lengths,
            **(rounding if name in kept else {}),
        }
        for name in described.data_vars
    }


def _described(axes, default, members, kept, rtol) -> xr.Dataset:
    """Coordinates, attributes and empty variables of the file."""
    shape = [axis.size for axis in axes.values()]
    empty = {name: np.broadcast_to(np.zeros((), type_of(name)), shape) for name in (*kept, *FLAGS)}
    loads = {"load": axes["load"] / default.newtons_per_load}
    described = described_grid({**axes, **loads}, empty, default, rtol).to_xarray()
    # the normal loads as given, without rounding
    described["normal_load"].values[:] = axes["load"]
    for name, (flag, state) in STATES.items():
        attributes = {
            "units": "1",
            "symbol": "none",
            "long_name": f"probability of {state.replace('_', '-')} {KINDS[flag]} over the ensemble",
            "coverage_content_type": "modelResult",
            "scale_factor": 1.0 / len(members),  # stored as counts
        }
        described[name] = DIMENSIONS, np.broadcast_to(np.zeros((), np.int16), shape), attributes
    ends = (AXES["roughness"].from_si(end) for end in axes["roughness"][[0, -1]])
    return described.assign_attrs(
        title=f"Atlas of three-body contact, roughness {' to '.join(f'{e:.4g} nm' for e in ends)}",
        comment=f"{described.attrs['comment']}. {COMMENT}",
        ensemble=json.dumps([dict(member) for member in members]),
    )
