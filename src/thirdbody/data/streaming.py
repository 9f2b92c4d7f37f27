"""Grids larger than memory: solved block by block, each written before the next is solved."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from itertools import product
from math import prod
from numbers import Integral
from os import PathLike
from pathlib import Path
from shutil import disk_usage
from typing import TYPE_CHECKING

import netCDF4
import numpy as np
from numpy.typing import ArrayLike

from thirdbody.conditions.checks import check_parameters, check_rtol
from thirdbody.data.conditions import DIMENSIONS
from thirdbody.data.dataset import Axes, crossed, described_grid, grid_axes, with_status
from thirdbody.data.files import atomic_write
from thirdbody.data.netcdf import add_variable
from thirdbody.data.plain import PlainDataset
from thirdbody.data.quantities import CONTRACT
from thirdbody.messages import shown, shown_file
from thirdbody.model.parameters import Parameters
from thirdbody.progress import Progress, check_progress
from thirdbody.solver.solution import Solution, type_of
from thirdbody.solver.solve import DEFAULT_RTOL, solve_arrays

if TYPE_CHECKING:
    import xarray as xr

POINTS_PER_BLOCK = 2**18  # some 50 MB while they are solved
EXACT: Mapping[str, int] = {}  # numbers are written with all digits
ONE_CHUNK = 8 * POINTS_PER_BLOCK  # bytes of a variable kept by the file: no chunk is written twice


def stream(
    path: str | PathLike,
    *,
    load: ArrayLike,
    viscosity: ArrayLike,
    particle_diameter: ArrayLike,
    roughness: ArrayLike,
    particle_density: ArrayLike,
    parameters: Parameters,
    rtol: float = DEFAULT_RTOL,
    variables: Collection[str] = CONTRACT,
    compression: int = 0,
    progress: bool = True,
) -> None:
    """Solve every combination of five axes block by block, into a file.

    What ``grid`` returns is written to the file, and no more than a block of it is in memory.

    Parameters
    ----------
    path : path
        NetCDF-4 file to write: it appears whole or not at all.
    load, viscosity, particle_diameter, roughness, particle_density : array_like
        The five axes, as in ``grid``.
    parameters : Parameters
        Inputs of the model.
    rtol : float, optional
        Relative error asked for in every variable [1].
    variables : collection of str, optional
        Those of ``Solution`` that are wanted; ``solution_status`` is always given.  A count of
        separations, which ``grid`` gives where there are several, is given if it is among them.
    compression : int, optional
        Level of zlib, from 0 to 9.  Nothing is compressed at 0: it would take longer than solving.
    progress : bool, optional
        Whether a call that takes long says how far it has come, as ``solve``.

    Raises
    ------
    ValueError
        As ``grid``, but for any number of points.
    OSError
        If there is no right to write, or no room: unless it is compressed, before anything is solved.

    Warns
    -----
    OutOfRangeWarning
        As ``solve``.

    Examples
    --------
    >>> import tempfile
    >>> import xarray as xr
    >>> import thirdbody as tb
    >>> parameters = tb.load_parameters()
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     tb.stream(
    ...         f"{folder}/grid.nc",
    ...         load=[1e-6, 1e-5],
    ...         viscosity=0.0,
    ...         particle_diameter=3e-7,
    ...         roughness=3e-7,
    ...         particle_density=1e11,
    ...         parameters=parameters,
    ...     )
    ...     written = xr.load_dataset(f"{folder}/grid.nc")
    >>> written["separation"].squeeze().shape
    (2,)
    """
    if not isinstance(compression, Integral) or compression not in range(10):
        raise ValueError(f"compression is {shown(compression)}; allowed: 0 to 9")
    check_parameters(parameters)
    check_rtol(rtol)
    check_progress(progress)
    names = with_status(variables)
    axes = grid_axes(parameters, load, viscosity, particle_diameter, roughness, particle_density)

    def solved(sides):
        return solve_arrays(crossed(sides), parameters, rtol, names)

    points = prod(axis.size for axis in axes.values())
    with Progress(points, "points", progress) as progressing:
        write_blocks(path, axes, solved, parameters, rtol, names, compression, progressing.add)


def write_blocks(
    path: str | PathLike,
    axes: Axes,
    solved: Callable[[Axes], Solution],
    parameters: Parameters,
    rtol: float,
    names: Collection[str] = CONTRACT,
    compression: int = 0,
    written: Callable[[int], None] = lambda points: None,
) -> None:
    """Write what ``solved`` returns for each block of a grid.

    Parameters
    ----------
    path : path
        NetCDF-4 file to write.
    axes : Mapping
        The five axes, as of ``grid_axes``.
    solved : callable
        Gives the ``Solution`` over the pieces of the axes that are the sides of a block.
    parameters : Parameters
        Inputs of the model, for the attributes of the file.
    rtol : float
        Relative error asked for [1], likewise.
    names : collection of str, optional
        Variables to write.
    compression : int, optional
        Level of zlib.
    written : callable, optional
        Is told how many more points are written.
    """
    shape = tuple(axis.size for axis in axes.values())
    lengths = block_lengths(shape, POINTS_PER_BLOCK)
    types = {name: np.dtype(type_of(name)) for name in names}
    with atomic_write(path) as part:
        if not compression:
            _require_room(path, prod(shape), sum(kind.itemsize for kind in types.values()))
        empty = {name: np.broadcast_to(np.zeros((), kind), shape) for name, kind in types.items()}
        described = described_grid(axes, empty, parameters, rtol)
        with netCDF4.Dataset(part, "w", format="NETCDF4") as file:
            variables = declare(file, described, dict(zip(DIMENSIONS, lengths)), compression)
            for block in blocks(shape, lengths):
                solution = solved(sides(axes, block))
                for name, variable in variables.items():
                    variable[block] = getattr(solution, name)
                written(solution.solution_status.size)


def _require_room(path: str | PathLike, points: int, bytes_a_point: int) -> None:
    """Raise ``OSError`` if the folder of a file has no room for it."""
    size, free = points * bytes_a_point, disk_usage(Path(path).parent).free
    if size > free:
        raise OSError(
            f"{shown_file(path)} would hold {points:.3g} points in {size:.3g} bytes; allowed: at most the "
            f"{free:.3g} bytes that are free there"
        )


def block_lengths(shape: Sequence[int], points: int) -> tuple[int, ...]:
    """Lengths of blocks of at most ``points`` each, whose points lie together in an array.

    Examples
    --------
    >>> block_lengths((10, 20, 30), 100)
    (1, 3, 30)
    """
    lengths = []
    for size in reversed(shape):
        lengths.append(min(size, max(points, 1)))
        points //= size
    return tuple(reversed(lengths))


def blocks(shape: Sequence[int], lengths: Sequence[int]) -> Iterator[tuple[slice, ...]]:
    """Index of each block of ``lengths`` in an array of ``shape``, in their order in it."""
    starts = [range(0, size, length) for size, length in zip(shape, lengths, strict=True)]
    for corner in product(*starts):
        yield tuple(
            slice(start, start + length) for start, length in zip(corner, lengths, strict=True)
        )


def sides(axes: Axes, block: tuple[slice, ...]) -> Axes:
    """The pieces of ``axes`` that an index of ``blocks`` picks."""
    return {name: axis[side] for (name, axis), side in zip(axes.items(), block, strict=True)}


def declare(
    file: netCDF4.Dataset,
    described: PlainDataset | xr.Dataset,
    lengths: Mapping[str, int],
    compression: int,
    digits: Mapping[str, int] = EXACT,
) -> dict[str, netCDF4.Variable]:
    """Put all of a dataset into a file but the values of its variables.

    Parameters
    ----------
    file : netCDF4.Dataset
        A new file: it gets the dimensions, coordinates and attributes.
    described : PlainDataset or xarray.Dataset
        What the file will hold.
    lengths : mapping
        Of the pieces in which variables are stored, by dimension.
    compression : int
        Level of zlib.
    digits : mapping, optional
        Significant digits that variables are rounded to, by name, which then take less room.

    Returns
    -------
    dict
        The variables by name, empty, which take values as they are stored.
    """
    file.setncatts(described.attrs)
    for name, size in described.sizes.items():
        file.createDimension(name, size)
    for name, coordinate in described.coords.items():
        add_variable(file, name, coordinate)[:] = coordinate.values
    variables = {}
    for name, values in described.data_vars.items():
        rounded = name in digits
        variables[name] = add_variable(
            file,
            name,
            values,
            coordinates="normal_load" if "load" in values.dims else "",
            zlib=compression > 0,
            complevel=compression,
            shuffle=rounded,  # digits that are left out, which are zeros, come together
            chunksizes=[lengths[each] for each in values.dims],
            chunk_cache=ONE_CHUNK,
            significant_digits=digits.get(name),
            quantize_mode="GranularBitRound",
        )
    return variables
