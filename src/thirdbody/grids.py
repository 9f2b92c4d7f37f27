"""``grid`` and ``stream`` solve every combination of five axes: in memory, or block by block into a
file."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import replace
from itertools import product
from math import prod
from numbers import Integral
from os import PathLike
from pathlib import Path
from shutil import disk_usage
from typing import TYPE_CHECKING, Unpack

import netCDF4
import numpy as np
from numpy.typing import NDArray

from thirdbody.conditions import (
    ConditionArguments,
    Conditions,
    check_rtol,
    checked_variables,
    read_conditions,
)
from thirdbody.core.parameters import Parameters
from thirdbody.core.solve import DEFAULT_RTOL, solve_points
from thirdbody.core.state import type_of
from thirdbody.core.sweep import is_worthwhile, sweep
from thirdbody.ensembles import MEMBER, Ensemble, differing
from thirdbody.files import atomic_write, format_path, format_value
from thirdbody.inputs import or_calibrated
from thirdbody.netcdf import (
    PlainVariable,
    alias_attributes,
    coordinate_attributes,
    declare,
    described_grid,
    finished,
    identity,
)
from thirdbody.progress import progress_bar
from thirdbody.variables import CONDITIONS, FLAGS, STATUS, VARIABLES
from thirdbody.version import current

if TYPE_CHECKING:
    import xarray as xr

POINTS_PER_BLOCK = 2**18  # about 50 MB while they are solved
SOLIDS = "roughness", "particle_density", "particle_diameter"
ONE_CHUNK = 8 * POINTS_PER_BLOCK  # bytes of a chunk cache, enough to write each chunk only once
Axes = Mapping[str, NDArray[np.float64]]  # 1-D and increasing, by name, in the order of DIMENSIONS


def grid(
    *,
    parameters: Parameters | Ensemble | None = None,
    members: bool = False,
    rtol: float = DEFAULT_RTOL,
    variables: str | Collection[str] | None = None,
    progress: bool = True,
    **conditions: Unpack[ConditionArguments],
) -> xr.Dataset:
    """Solve every combination of five axes and return a dataset.

    Parameters
    ----------
    parameters : Parameters or Ensemble, optional
        Inputs of the model, by default the calibrated inputs.
    members : bool, optional
        Whether all members of an ensemble are solved, by default only the best.
    rtol : float, optional
        Requested relative error of every variable [1].  At 1e-3 or more, large grids are
        interpolated over the separation, which is faster.  Below 1e-3 every point is solved
        individually.
    variables : str or collection of str, optional
        Variables of ``Solution`` to compute; ``solution_status`` is always included.
    progress : bool, optional
        Whether a long call shows its progress, as in ``solve``.
    **conditions : array_like, shape (n,) or scalar
        The five axes, increasing, as numbers or quantities, by any of their names in
        ``thirdbody.solve``; the speed may be a sixth axis.  Viscosity 0 is dry contact; diameter or
        density 0 is two-body contact.

    Returns
    -------
    xarray.Dataset
        The axes [SI] are the dimensions.  An axis given under an alias is also a coordinate under
        it, for ``sel``.  Regime, mode and status are names; ``solution_status`` is the status of
        each point, and points without values are nan.  With ``members`` the first dimension is
        ``member``, the best first.  For loads in newtons, the coordinate ``load`` is F_t* of the
        best.

    Raises
    ------
    ValueError
        For an axis that is missing, not 1-D, not increasing or not physical, a quantity of the
        wrong dimension, an ``rtol`` out of range, or an unknown variable.

    Warns
    -----
    OutOfRangeWarning
        As in ``solve``.

    Examples
    --------
    >>> import thirdbody as tb
    >>> oil = dict(viscosity_cSt=[0, 90], roughness_nm=300)
    >>> debris = dict(particle_diameter_nm=300, particle_density_per_m2=1e11)
    >>> points = tb.grid(load_N=[1, 10], **oil, **debris, variables=["solid_load_fraction"])
    >>> points["solid_load_fraction"].squeeze().shape
    (2, 2)
    >>> points["solid_load_fraction"].sel(viscosity_cSt=90, load_N=10).round(4).item()
    0.6543
    """
    ensemble = or_calibrated(parameters)
    check_rtol(rtol)
    names = _names(variables)
    read = read_conditions(conditions, ensemble.best)
    axes = _axes(read)
    sets = ensemble if members else (ensemble,)
    grids = [_grid_of(each, read, axes, rtol, names, progress) for each in sets]
    dataset = _along_members(grids, ensemble, read) if members else grids[0]
    return finished(dataset.assign_coords(_under_aliases(read, ensemble.best)))


def _under_aliases(read: Conditions, parameters: Parameters) -> dict[str, PlainVariable]:
    """The axes that were given under an alias, by it: coordinates beside those in SI."""
    return {
        key: PlainVariable(
            (name,), np.atleast_1d(read.given[name]), alias_attributes(CONDITIONS[name], parameters)
        )
        for name, key in read.keys.items()
        if key != name
    }


def _along_members(grids: list[xr.Dataset], ensemble: Ensemble, read: Conditions) -> xr.Dataset:
    """The grids of all members joined along a new dimension; the loads F_t* are of the best."""
    import xarray as xr

    changed = {"load": grids[0]["load"].variable}
    if read.is_force:  # the same load in newtons for all
        changed["normal_load"] = grids[0]["normal_load"].variable
    joined = xr.concat(
        [each.assign_coords(changed) for each in grids],
        dim=xr.Variable(MEMBER, np.arange(len(grids))),
        coords="minimal" if read.is_force else ["normal_load"],
        compat="override",
        combine_attrs="override",
    )
    origin = " ".join(each.attrs["configuration_sha256"] for each in grids)
    return joined.assign_attrs(identity(origin) | differing(ensemble))


def _grid_of(
    ensemble: Ensemble,
    read: Conditions,
    axes: Axes,
    rtol: float,
    names: Collection[str],
    progress: bool,
) -> xr.Dataset:
    """The dataset of the best of an ensemble, over five axes, or six with the speed."""
    parameters = ensemble.best
    axes = read.with_load(parameters, axes)
    speeds = axes.pop("speed", None)
    if speeds is None:
        return _solved_grid(axes, axes, parameters, rtol, names, progress)
    import xarray as xr

    films = {"viscosity": axes["viscosity"][:, None], "speed": speeds}
    films = ensemble.setup.without_speed(films, parameters)
    viscosities, places = np.unique(films["viscosity"], return_inverse=True)
    films = axes | {"viscosity": viscosities}
    request = axes | {"speed": speeds}
    solved = _solved_grid(films, request, parameters, rtol, names, progress)
    shape = axes["viscosity"].size, speeds.size
    films_of = xr.DataArray(places.reshape(shape), dims=("film", "speed"))
    placed = solved.isel(viscosity=films_of).drop_vars("viscosity").rename(film="viscosity")
    return placed.assign_coords(
        {
            name: (name, request[name], coordinate_attributes(CONDITIONS[name]))
            for name in ("viscosity", "speed")
        }
    )


def _solved_grid(
    axes: Axes,
    request: Axes,
    parameters: Parameters,
    rtol: float,
    names: Collection[str],
    progress: bool,
) -> xr.Dataset:
    """The dataset over five ``axes``; ``request``, the axes of the user, determines its SHA-256."""
    points = prod(axis.size for axis in axes.values())
    with progress_bar(points, progress) as bar:
        values = _values(axes, parameters, rtol, names, bar.update)
    from thirdbody.lazy import lazy_states

    values |= {name: lazy_states(name, values[name]) for name in FLAGS.keys() & values.keys()}
    listed = {name: axis.tolist() for name, axis in request.items()}
    described = described_grid(axes, values, parameters, rtol, request=listed)
    return described.to_xarray().assign_attrs(software_version=current().text)


def _values(
    axes: Axes,
    parameters: Parameters,
    rtol: float,
    names: Collection[str],
    callback: Callable[[int], None],
) -> dict[str, NDArray]:
    """Variables over all ``axes``, interpolated if this is faster."""
    if is_worthwhile(axes, rtol):
        return sweep(axes, parameters, rtol, names, callback)
    return solve_points(crossed(axes), parameters, rtol, names, callback)


def stream(
    path: str | PathLike,
    *,
    parameters: Parameters | Ensemble | None = None,
    rtol: float = DEFAULT_RTOL,
    variables: str | Collection[str] | None = None,
    compression: int = 0,
    progress: bool = True,
    **conditions: Unpack[ConditionArguments],
) -> None:
    """Solve every combination of five axes block by block, into a file.

    The file contains the dataset that ``grid`` returns, with CF flags (``flag_values``,
    ``flag_meanings``) instead of names.  Only one block is in memory at a time.

    Parameters
    ----------
    path : path
        NetCDF-4 file, written atomically.
    parameters, rtol, variables, progress, **conditions
        As in ``grid``.
    compression : int, optional
        Level of zlib, from 0 to 9.  The default 0 is no compression, because compression takes
        longer than solving.

    Raises
    ------
    ValueError
        As in ``grid``, and for a speed.
    OSError
        If the path is not writable or the disk is full.  Without compression the space is checked
        before anything is solved.

    Warns
    -----
    OutOfRangeWarning
        As in ``solve``.

    Examples
    --------
    >>> import tempfile
    >>> import xarray as xr
    >>> import thirdbody as tb
    >>> oil = dict(viscosity_cSt=0, roughness_nm=300)
    >>> debris = dict(particle_diameter_nm=300, particle_density_per_m2=1e11)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     tb.stream(f"{folder}/grid.nc", load_N=[1, 10], **oil, **debris)
    ...     written = xr.load_dataset(f"{folder}/grid.nc")
    >>> written["separation"].squeeze().shape
    (2,)
    """
    if not isinstance(compression, Integral) or compression not in range(10):
        raise ValueError(f"compression is {format_value(compression)}; allowed: 0 to 9")
    inputs = or_calibrated(parameters).best
    check_rtol(rtol)
    names = _names(variables)
    read = read_conditions(conditions, inputs)
    axes = read.with_load(inputs, _axes(read))
    if "speed" in axes:
        raise ValueError("speed_m_per_s is no axis of a file; allowed: other viscosities instead")
    shape = tuple(axis.size for axis in axes.values())
    lengths = _block_lengths(axes)
    types = {name: np.dtype(type_of(name)) for name in names}
    empty = {name: np.broadcast_to(np.zeros((), kind), shape) for name, kind in types.items()}
    described = described_grid(axes, empty, inputs, rtol)
    described = replace(described, coords={**described.coords, **_under_aliases(read, inputs)})
    with atomic_write(path) as (part,):
        size = prod(shape) * sum(kind.itemsize for kind in types.values())
        free = disk_usage(Path(path).parent).free
        if size > free and not compression:
            raise OSError(
                f"{format_path(path)} would hold {prod(shape):.3g} points in {size:.3g} bytes; "
                f"allowed: at most the {free:.3g} bytes free on the disk"
            )
        with (
            netCDF4.Dataset(part, "w", format="NETCDF4") as file,
            progress_bar(prod(shape), progress) as bar,
        ):
            storage = {"zlib": compression > 0, "complevel": compression, "shuffle": False}
            storage |= {"chunksizes": lengths, "chunk_cache": ONE_CHUNK}
            stored = declare(file, described, dict.fromkeys(names, storage))
            file.software_version = current().text
            starts = [range(0, size, length) for size, length in zip(shape, lengths)]
            for corner in product(*starts):
                block = tuple(slice(i, i + length) for i, length in zip(corner, lengths))
                sides = {name: axis[side] for (name, axis), side in zip(axes.items(), block)}
                values = _values(sides, inputs, rtol, names, bar.update)
                for name, variable in stored.items():
                    variable[block] = values[name]


def _block_lengths(axes: Axes) -> list[int]:
    """Lengths of a block along the ``axes``.

    Surfaces and particles are split first: ``sweep`` uses one table for all loads and viscosities.
    """
    lengths = {name: axis.size for name, axis in axes.items()}
    while prod(lengths.values()) > POINTS_PER_BLOCK:
        solids = [name for name in SOLIDS if lengths[name] > 1]
        longest = max(solids or lengths, key=lengths.__getitem__)
        lengths[longest] = -(-lengths[longest] // 2)
    return [*lengths.values()]


def _names(variables: str | Collection[str] | None) -> list[str]:
    """The names of variables, always with the status, as it explains nan."""
    chosen = checked_variables(variables, VARIABLES)
    return [name for name in VARIABLES if name in chosen or name == STATUS]


def _axes(read: Conditions) -> dict[str, NDArray[np.float64]]:
    """The axes of a grid, a load in the unit of the user; ``ValueError`` unless they increase."""
    axes = {name: np.atleast_1d(values) for name, values in read.arrays.items()}
    for name, axis in axes.items():
        if axis.ndim != 1 or axis.size == 0 or (np.diff(axis) <= 0.0).any():
            message = f"{read.keys[name]} of shape {axis.shape} does not increase"
            raise ValueError(f"{message}; allowed: one increasing dimension")
    return axes


def crossed(sides: Axes) -> dict[str, NDArray[np.float64]]:
    """The axes ``sides`` of a grid, in shapes that broadcast to all points."""
    return dict(zip(sides, np.ix_(*sides.values()), strict=True))
