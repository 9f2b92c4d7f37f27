"""Grids larger than memory, solved and written block by block."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from itertools import product
from math import prod
from numbers import Integral
from os import PathLike
from pathlib import Path
from shutil import disk_usage

import netCDF4
import numpy as np
from numpy.typing import ArrayLike

from thirdbody.data.dataset import checked_grid, crossed, described_grid
from thirdbody.data.files import atomic_write
from thirdbody.data.netcdf import declare
from thirdbody.data.quantities import CONTRACT
from thirdbody.messages import format_path, format_value
from thirdbody.model.parameters import Parameters
from thirdbody.progress import Progress
from thirdbody.solver.solution import type_of
from thirdbody.solver.solve import DEFAULT_RTOL, solve_arrays

POINTS_PER_BLOCK = 2**18  # about 50 MB while they are solved
ONE_CHUNK = 8 * POINTS_PER_BLOCK  # bytes of a chunk cache in which no chunk is written twice


def stream(
    path: str | PathLike,
    *,
    parameters: Parameters | None = None,
    rtol: float = DEFAULT_RTOL,
    variables: Collection[str] = CONTRACT,
    compression: int = 0,
    progress: bool = True,
    **conditions: ArrayLike,
) -> None:
    """Solve every combination of five axes block by block, into a file.

    Writes the dataset that ``grid`` would return, with only one block in memory.

    Parameters
    ----------
    path : path
        NetCDF-4 file to write; it is written atomically.
    parameters, rtol, progress, **conditions
        As in ``grid``.
    variables : collection of str, optional
        As in ``grid``; ``separation_count`` is only included on request.
    compression : int, optional
        Level of zlib, from 0 to 9.  At the default 0 nothing is compressed, because that would take
        longer than solving.

    Raises
    ------
    ValueError
        As in ``grid``, but without a limit on the number of points.
    OSError
        If the path is not writable or the disk is full; without compression, before anything is solved.

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
    parameters, names, axes = checked_grid(parameters, rtol, variables, progress, conditions)
    shape = tuple(axis.size for axis in axes.values())
    lengths = block_lengths(shape, POINTS_PER_BLOCK)
    types = {name: np.dtype(type_of(name)) for name in names}
    empty = {name: np.broadcast_to(np.zeros((), kind), shape) for name, kind in types.items()}
    described = described_grid(axes, empty, parameters, rtol)
    with atomic_write(path) as part:
        size = prod(shape) * sum(kind.itemsize for kind in types.values())
        free = disk_usage(Path(path).parent).free
        if size > free and not compression:
            raise OSError(
                f"{format_path(path)} would hold {prod(shape):.3g} points in {size:.3g} bytes; allowed: at "
                f"most the {free:.3g} bytes free on the disk"
            )
        with (
            netCDF4.Dataset(part, "w", format="NETCDF4") as file,
            Progress(prod(shape), "points", progress) as progressing,
        ):
            storage = {"zlib": compression > 0, "complevel": compression, "shuffle": False}
            storage |= {"chunksizes": lengths, "chunk_cache": ONE_CHUNK}
            stored = declare(file, described, dict.fromkeys(names, storage))
            for block in blocks(shape, lengths):
                sides = {name: axis[side] for (name, axis), side in zip(axes.items(), block)}
                solution = solve_arrays(crossed(sides), parameters, rtol, names)
                for name, variable in stored.items():
                    variable[block] = getattr(solution, name)
                progressing.add(solution.solution_status.size)


def block_lengths(shape: Sequence[int], points: int) -> tuple[int, ...]:
    """Lengths of contiguous blocks of at most ``points`` each: for an array of shape (10, 20, 30),
    at most 100 points make blocks of shape (1, 3, 30)."""
    lengths = []
    for size in reversed(shape):
        lengths.append(min(size, max(points, 1)))
        points //= size
    return tuple(reversed(lengths))


def blocks(shape: Sequence[int], lengths: Sequence[int]) -> Iterator[tuple[slice, ...]]:
    """Index of each block of ``lengths`` in an array of ``shape``, in memory order."""
    starts = [range(0, size, length) for size, length in zip(shape, lengths)]
    for corner in product(*starts):
        yield tuple(slice(start, start + length) for start, length in zip(corner, lengths))
