"""Time of streaming a grid to a file, beside solving it and writing it alone."""

from __future__ import annotations

import math
import resource
import shutil
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.classes import ROUGHNESS, SPANS
from benchmarks.measuring import MEGABYTE, MICROSECONDS, wall_seconds
from thirdbody.data.conditions import DIMENSIONS
from thirdbody.data.dataset import crossed
from thirdbody.data.quantities import FLAGS, NUMBERS
from thirdbody.data.streaming import (
    POINTS_PER_BLOCK,
    block_lengths,
    blocks,
    sides,
    stream,
    write_blocks,
)
from thirdbody.model.parameters import Parameters
from thirdbody.solver.plan import expect_points
from thirdbody.solver.solve import solve

POINT_BYTES = 8 * len(NUMBERS) + len(FLAGS)


def stream_rows(
    parameters: Parameters, settings: Mapping[str, Any], directory: Path
) -> list[dict[str, Any]]:
    """Measure streaming, solving alone and writing alone of the same grid.

    Each is done several times in turn, and the quickest counts.

    Parameters
    ----------
    parameters : Parameters
        Inputs of the model.
    settings : mapping
        The entry ``streaming`` of ``config/accuracy.yaml``: the number of ``values`` on each axis,
        ``rtol`` and the number of ``rounds``.
    directory : Path
        Where the files are written; they are removed afterwards.

    Returns
    -------
    list of dict
        Rows of the table ``streaming``.

    Raises
    ------
    OSError
        If the directory has no room for a file.

    Examples
    --------
    >>> import tempfile
    >>> from thirdbody import load_parameters
    >>> values = {"load": 3, "viscosity": 1, "particle_diameter": 2, "particle_density": 1}
    >>> settings = {"values": values, "rtol": 1e-6, "rounds": 1}
    >>> with tempfile.TemporaryDirectory() as place:
    ...     rows = stream_rows(load_parameters(), settings, Path(place))
    >>> [row["what"] for row in rows], rows[0]["points"]
    (['streaming', 'solving', 'writing'], 6)
    """
    axes, rtol = _axes(parameters, settings["values"]), settings["rtol"]
    points = math.prod(axis.size for axis in axes.values())
    _require_room(directory, points)
    expect_points(points)
    # What is prepared once for a surface is no part of what is measured.
    solve(**crossed(sides(axes, next(_blocks(axes)))), parameters=parameters, rtol=rtol)
    path = directory / "streamed.nc"

    def record(what, function):
        # The first file is slower than those after it, as the system sets memory aside for it.
        _write_alone(path, axes, parameters, rtol)
        path.unlink()
        seconds = wall_seconds(function)
        size = path.stat().st_size / MEGABYTE if path.exists() else None
        path.unlink(missing_ok=True)
        return {
            "what": what,
            "points": points,
            "rtol": rtol,
            "seconds": seconds,
            "microseconds_per_point": MICROSECONDS * seconds / points,
            "resident_memory_MB": _resident_megabytes(),
            "file_MB": size,
        }

    rounds = [
        [
            record("streaming", lambda: stream(path, **axes, parameters=parameters, rtol=rtol)),
            record("solving", lambda: _solve_blocks(axes, parameters, rtol)),
            record("writing", lambda: _write_alone(path, axes, parameters, rtol)),
        ]
        for _ in range(settings["rounds"])
    ]
    return [min(rows, key=lambda row: row["seconds"]) for rows in zip(*rounds, strict=True)]


def _axes(parameters, values) -> dict:
    """Axes of the grid: the usual span with the number of ``values`` of each, one roughness."""
    spans = {
        name: np.geomspace(*ends, values.get(name, 0)) for name, ends in SPANS["usual"].items()
    }
    load = np.geomspace(*SPANS["usual"]["normal_load"], values["load"])
    given = {**spans, "load": load / parameters.newtons_per_load, "roughness": ROUGHNESS["usual"]}
    return {name: np.asarray(given[name]) for name in DIMENSIONS}


def _solve_blocks(axes, parameters, rtol):
    for block in _blocks(axes):
        solve(**crossed(sides(axes, block)), parameters=parameters, rtol=rtol)


def _write_alone(path, axes, parameters, rtol):
    """Write a file of the same size: all blocks of one shape hold the solution of the first."""
    known = {}

    def solved(given):
        shape = tuple(axis.size for axis in given.values())
        if shape not in known:
            known[shape] = solve(**crossed(given), parameters=parameters, rtol=rtol)
        return known[shape]

    write_blocks(path, axes, solved, parameters, rtol)


def _blocks(axes):
    shape = tuple(axis.size for axis in axes.values())
    return blocks(shape, block_lengths(shape, POINTS_PER_BLOCK))


def _resident_megabytes():
    """Most memory [MB] that this process has held so far, libraries included."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024 / MEGABYTE


def _require_room(directory, points):
    needed, free = 1.1 * points * POINT_BYTES, shutil.disk_usage(directory).free
    if free < needed:
        raise OSError(
            f"{directory} has {free / MEGABYTE:.0f} MB of free space; {points} points need "
            f"{needed / MEGABYTE:.0f} MB"
        )
