"""One file of the atlas: some of its surfaces, in the layout of every dataset, with the ensemble."""

from __future__ import annotations

import json
import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from os import PathLike
from typing import Any

import netCDF4
import numpy as np
import xarray as xr

from thirdbody.atlas.grid import AtlasGrid
from thirdbody.atlas.spread import QUANTILES
from thirdbody.atlas.surfaces import LIMITS, TURNING, Clock, solve_surface
from thirdbody.data.conditions import AXES, DIMENSIONS
from thirdbody.data.dataset import described_grid
from thirdbody.data.quantities import FLAGS
from thirdbody.data.streaming import declare
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import (
    BOUNDARY_LIMIT,
    CONTACT_MODES,
    LUBRICATION_REGIMES,
    PARTICLE_LIMIT,
)
from thirdbody.solver.solution import type_of

POINTS_TOGETHER = 2**20  # solved at a time for one set of inputs: some 150 MB
SAFE_DIGITS = 2  # written beyond those that are asked for
QUANTILE = "quantile"
COMMENT = (
    "load is F_t* of the default inputs, those of model_parameters, and normal_load belongs to it. "
    "Each member of the ensemble is solved at the same normal_load, which is another F_t* where its "
    "apparent area differs; turning_point_load is F_t* of each member's own area. ensemble gives what "
    "differs from the default in each member, by the names of config/inputs.yaml, SI. A probability is "
    "the fraction of the members; a _range has quantiles of those members that have a value."
)
PASSED = "0: on this side at the least value of the axis already; infinite: at none"


@dataclass(frozen=True)
class Finding:
    """A variable of the atlas that is found on the points of a surface.

    Attributes
    ----------
    long_name : str
        What it is.
    dimensions : tuple of str
        Axes that it has.
    units : str
        SI unit.
    symbol : str
        Symbol of the paper, ``none`` where it has none.
    comment : str
        What else there is to say of it, or nothing.
    is_fraction : bool
        Whether it is a fraction of the members: stored as their number.
    """

    long_name: str
    dimensions: tuple[str, ...]
    units: str = "1"
    symbol: str = "none"
    comment: str = ""
    is_fraction: bool = False


def _without(*left_out: str) -> tuple[str, ...]:
    return tuple(name for name in DIMENSIONS if name not in left_out)


def _of_state(kind: str, state: str) -> Finding:
    told = f"probability of {state.replace('_', '-')} {kind} over the ensemble"
    return Finding(told, DIMENSIONS, is_fraction=True)


_OF_LIMITS = {
    "largest_particle_diameter": Finding(
        f"largest particle diameter that stays out of the particle-surface mode, A_sa,t* = {PARTICLE_LIMIT}",
        _without("particle_diameter"),
        "m",
        "x_a",
        PASSED,
    ),
    "least_viscosity": Finding(
        f"least viscosity that leaves boundary lubrication, L_s = {BOUNDARY_LIMIT}",
        _without("viscosity"),
        "m2 s-1",
        "nu",
        PASSED,
    ),
    "turning_point_load": Finding(
        "load at the turning point of the contact area", _without("load"), "1", "F_TPCA*"
    ),
    "turning_point_window_low": Finding(
        "least particle diameter over roughness with a turning point",
        _without("load", "particle_diameter"),
    ),
    "turning_point_window_high": Finding(
        "largest particle diameter over roughness with a turning point",
        _without("load", "particle_diameter"),
    ),
}


def _findings() -> Iterator[tuple[str, Finding]]:
    for state in LUBRICATION_REGIMES:
        yield f"{state}_probability", _of_state("lubrication", state)
    for state in CONTACT_MODES:
        yield f"{state}_probability", _of_state("contact", state)
    for name in (*LIMITS, *TURNING):
        finding = _OF_LIMITS[name]
        yield name, finding
        told = f"{finding.long_name}: quantiles of the ensemble"
        dimensions = (QUANTILE, *finding.dimensions)
        yield f"{name}_range", replace(finding, long_name=told, dimensions=dimensions)
    for name, of in (("turning_point", TURNING[0]), ("turning_point_window", TURNING[1])):
        told = f"probability of a {name.replace('_', ' ')} over the ensemble"
        yield f"{name}_probability", Finding(told, _OF_LIMITS[of].dimensions, is_fraction=True)


FINDINGS = dict(_findings())


def write_chunk(
    path: str | PathLike,
    grid: AtlasGrid,
    default: Parameters,
    members: Sequence[Mapping[str, Any]],
    kept: Collection[str],
    rtol: float,
) -> Clock:
    """Solve the surfaces of ``grid`` for all inputs and write what is found, little by little.

    Parameters
    ----------
    path : path
        NetCDF-4 file to write, which only this process reads before it is complete.
    grid : AtlasGrid
        Some surfaces of the atlas.
    default : Parameters
        The default inputs.
    members : sequence of mapping
        For each member of the ensemble, the inputs that differ from the default, SI.
    kept : collection of str
        Quantities kept of each point under the default inputs, beside the flags.
    rtol : float
        Relative error asked for.

    Returns
    -------
    Clock
        Processor time that solving took.
    """
    ensemble = [replace(default, **member) for member in members]
    sets = list(dict.fromkeys([default, *ensemble]))
    weights = [ensemble.count(each) for each in sets]
    clock = Clock(len(sets))
    with netCDF4.Dataset(path, "w", format="NETCDF4") as file:
        described = _described(grid, default, members, kept, rtol)
        sides = dict.fromkeys(("roughness", "particle_density"), 1)
        digits = dict.fromkeys(kept, math.ceil(-math.log10(rtol)) + SAFE_DIGITS)
        file_variables = declare(file, described, {**described.sizes, **sides}, 1, digits)
        for place, part in _parts(grid):
            found = solve_surface(part, sets, weights, kept, rtol, clock)
            for name, values in found.items():
                variable = file_variables[name]
                variable[tuple(place.get(each, slice(None)) for each in variable.dimensions)] = (
                    values
                )
    return clock


def _parts(grid: AtlasGrid) -> Iterator[tuple[dict[str, slice], AtlasGrid]]:
    """Where they are in the file, and the parts of a grid that are solved at a time: some particle
    densities on one surface."""
    surfaces, densities = (grid.conditions[name] for name in ("roughness", "particle_density"))
    of_one_density = math.prod(grid.shape) // (surfaces.size * densities.size)
    step = max(POINTS_TOGETHER // of_one_density, 1)
    for row in range(surfaces.size):
        surface = grid.with_roughness(surfaces[row : row + 1])
        for first in range(0, densities.size, step):
            some = slice(first, min(first + step, densities.size))
            place = {"roughness": slice(row, row + 1), "particle_density": some}
            yield place, surface.with_density(densities[some])


def _described(grid, default, members, kept, rtol) -> xr.Dataset:
    """Coordinates, attributes and empty variables of the file of ``grid``."""
    empty = {
        name: np.broadcast_to(np.zeros((), type_of(name)), grid.shape) for name in (*kept, *FLAGS)
    }
    described = described_grid(grid.axes(default), empty, default, rtol).to_xarray()
    # the normal loads are given: those of the grid have no rounding
    described["normal_load"].values[:] = grid.newtons
    told = {"units": "1", "long_name": "fraction of the ensemble below"}
    described = described.assign_coords({QUANTILE: (QUANTILE, QUANTILES, told)})
    for name, finding in FINDINGS.items():
        shape = [described.sizes[each] for each in finding.dimensions]
        kind = np.int16 if finding.is_fraction else float
        values = np.broadcast_to(np.zeros((), kind), shape)
        described[name] = finding.dimensions, values, _attributes(finding, len(members))
    ends = " to ".join(
        f"{AXES['roughness'].from_si(end):.4g} nm" for end in grid.conditions["roughness"][[0, -1]]
    )
    return described.assign_attrs(
        title=f"Atlas of three-body contact, roughness {ends}",
        comment=f"{described.attrs['comment']}. {COMMENT}",
        ensemble=json.dumps([dict(member) for member in members]),
    )


def _attributes(finding: Finding, members: int) -> dict:
    attributes = {
        "units": finding.units,
        "long_name": finding.long_name,
        "symbol": finding.symbol,
        "coverage_content_type": "modelResult",
    }
    attributes |= {"comment": finding.comment} if finding.comment else {}
    return attributes | ({"scale_factor": 1.0 / members} if finding.is_fraction else {})
