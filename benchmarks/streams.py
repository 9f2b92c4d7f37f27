"""What streaming a grid to a file costs, against solving alone and writing alone."""

from __future__ import annotations

import math
import resource
import shutil

import numpy as np

from benchmarks.classes import ROUGHNESS, SPANS
from benchmarks.measuring import MEGABYTE, MICROSECONDS, wall_seconds
from thirdbody.data.conditions import DIMENSIONS
from thirdbody.data.quantities import FLAGS, QUANTITIES
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

POINT_BYTES = 8 * len(QUANTITIES) + len(FLAGS)


def stream_rows(parameters: Parameters, settings, directory) -> list[dict]:
    """Rows of the table ``streaming`` for the grid of ``settings``, numbers of values by axis.

    Of each the quickest of some rounds.  The files are written to ``directory`` and removed;
    ``OSError`` if it has no room for one.
    """
    axes, rtol = _axes(parameters, settings["values"]), settings["rtol"]
    points = math.prod(axis.size for axis in axes.values())
    _require_room(directory, points)
    expect_points(points, parameters)
    solve(*np.ix_(*sides(axes, next(_blocks(axes)))), parameters=parameters, rtol=rtol)  # prepares
    path = directory / "streamed.nc"

    def record(what, function):
        # the file system takes memory for a file: the first time is slower
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
    """Axes over the usual span, with so many values each, on one roughness."""
    spans = {
        name: np.geomspace(*ends, values.get(name, 0)) for name, ends in SPANS["usual"].items()
    }
    load = np.geomspace(*SPANS["usual"]["normal_load"], values["load"])
    given = {**spans, "load": load / parameters.newtons_per_load, "roughness": ROUGHNESS["usual"]}
    return {name: np.asarray(given[name]) for name in DIMENSIONS}


def _solve_blocks(axes, parameters, rtol):
    for block in _blocks(axes):
        solve(*np.ix_(*sides(axes, block)), parameters=parameters, rtol=rtol)


def _write_alone(path, axes, parameters, rtol):
    """The same file with the solution of the first block in every block of its shape."""
    known = {}

    def solved(*given):
        shape = tuple(axis.size for axis in given)
        if shape not in known:
            known[shape] = solve(*np.ix_(*given), parameters=parameters, rtol=rtol)
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
