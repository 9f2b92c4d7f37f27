"""Grids larger than memory: solved block by block, each written before the next is solved."""

from __future__ import annotations

from collections.abc import Collection
from itertools import product

import netCDF4
import numpy as np

from thirdbody.data.dataset import CONTRACT, described_grid, grid_axes, with_status
from thirdbody.data.files import whole
from thirdbody.data.scene import DIMENSIONS
from thirdbody.model.parameters import Parameters
from thirdbody.solver.solve import DEFAULT_RTOL, solve, type_of

POINTS_PER_BLOCK = 2**18  # some 50 MB while they are solved
ONE_CHUNK = 8 * POINTS_PER_BLOCK  # bytes of a variable kept by the file: no chunk is written twice


def stream(
    path,
    load,
    viscosity,
    particle_diameter,
    roughness,
    particle_density,
    parameters: Parameters,
    rtol: float = DEFAULT_RTOL,
    variables: Collection[str] = CONTRACT,
) -> None:
    """Write the dataset of ``grid`` to the NetCDF-4 file ``path``, in memory for a block at most.

    The arguments after ``path`` are those of ``grid``.  Nothing is compressed, which would take
    longer than solving.  The file appears whole or not at all; raises ``ValueError`` as ``grid``.
    """

    names = with_status(variables)

    def solved(*sides):
        return solve(*np.ix_(*sides), parameters, rtol, names)

    axes = grid_axes(load, viscosity, particle_diameter, roughness, particle_density)
    write_blocks(path, axes, solved, parameters, rtol, names)


def write_blocks(
    path, axes, solved, parameters: Parameters, rtol: float, names: Collection[str] = CONTRACT
) -> None:
    """Write to ``path`` what ``solved`` returns, a ``Solution``, for the sides of each block.

    ``axes`` are the five of ``grid_axes``; the sides of a block are pieces of them; ``names`` are
    the variables to write.
    """
    shape = tuple(axis.size for axis in axes.values())
    lengths = block_lengths(shape, POINTS_PER_BLOCK)
    empty = {name: np.broadcast_to(np.zeros((), type_of(name)), shape) for name in names}
    described = described_grid(axes, empty, parameters, rtol)
    with whole(path, recorded=False) as part, netCDF4.Dataset(part, "w", format="NETCDF4") as file:
        variables = _declare(file, described, lengths)
        for block in blocks(shape, lengths):
            solution = solved(*sides(axes, block))
            for name, variable in variables.items():
                variable[block] = getattr(solution, name)


def block_lengths(shape, points) -> tuple[int, ...]:
    """Lengths of blocks of at most ``points`` in an array of ``shape`` that lie together in it."""
    lengths = []
    for size in reversed(shape):
        lengths.append(min(size, max(points, 1)))
        points //= size
    return tuple(reversed(lengths))


def blocks(shape, lengths):
    """Index of each block of ``lengths`` in an array of ``shape``, in their order in it."""
    starts = [range(0, size, length) for size, length in zip(shape, lengths, strict=True)]
    for corner in product(*starts):
        yield tuple(
            slice(start, start + length) for start, length in zip(corner, lengths, strict=True)
        )


def sides(axes, block):
    """The pieces of ``axes`` that an index of ``blocks`` picks."""
    return [axis[side] for axis, side in zip(axes.values(), block, strict=True)]


def _declare(file, described, lengths):
    """Dimensions, coordinates and attributes of ``described`` in ``file``; its variables, empty."""
    file.setncatts(described.attrs)
    for name in DIMENSIONS:
        file.createDimension(name, described.sizes[name])
    for name, coordinate in described.coords.items():
        variable = file.createVariable(name, coordinate.dtype, coordinate.dims)
        variable.setncatts(coordinate.attrs)
        variable[:] = coordinate.values
    variables = {}
    for name, values in described.data_vars.items():
        attributes = dict(values.attrs)
        fill = attributes.pop("_FillValue")
        attributes["coordinates"] = "normal_load"
        variables[name] = file.createVariable(
            name,
            values.dtype,
            values.dims,
            chunksizes=lengths,
            chunk_cache=ONE_CHUNK,
            fill_value=fill,
        )
        variables[name].setncatts(attributes)
        variables[name].set_auto_maskandscale(False)
    return variables
