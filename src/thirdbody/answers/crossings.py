"""Crossings of levels along an axis: sampled, bracketed and refined.

The axis is sampled at logarithmically spaced values.  Two neighbours on opposite sides of the level bracket a
crossing, which is refined to the requested error.  Where a curve has an extremum near the level, the sampling
is refined ``DEPTH`` times by ``FINER``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.arguments import check_count, check_points, check_rtol, ends_in_si, in_si
from thirdbody.core.bracketing import bracketed_roots
from thirdbody.core.parameters import Parameters
from thirdbody.core.solve import solve_arrays
from thirdbody.units import (
    ENGINEERING,
    SEARCHED,
    UNITS,
    Unit,
    decimal,
    is_labelled,
    unit_of,
    units_in_tables,
)

SWEEP = 32  # values along the axis
FINER, DEPTH = 8, 2  # where a curve has an extremum near the level
WIDER, ATTEMPTS = 8.0, 8  # until both sides of a crossing are certain


def queries(
    conditions: Mapping[str, ArrayLike], parameters: Parameters, along: str, **more: NDArray
) -> tuple[tuple[int, ...], dict[str, NDArray]]:
    """The broadcast shape of the conditions, except ``along``, and of ``more`` columns, and all of
    them flat, in SI."""
    for key, values in conditions.items():
        if is_labelled(values):
            allowed = f"its .values in {unit_of(key).text}"
            raise ValueError(f"{key} has named dimensions; allowed: {allowed}")
    given = more | in_si(conditions, parameters, without=along)
    check_points(given, conditions)
    columns = np.broadcast_arrays(*given.values())
    return columns[0].shape, dict(zip(given, map(np.ravel, columns)))


def differing(
    conditions: Mapping[str, ArrayLike], columns: Mapping[str, NDArray], parameters: Parameters
) -> dict[str, NDArray]:
    """The ``columns`` of ``queries`` in which these differ; conditions by their names in tables, which have units."""
    units, found = units_in_tables(conditions), {}
    for name, column in columns.items():
        if np.unique(column).size > 1:
            if name in units:
                column = decimal(units[name].from_si(column, parameters.newtons_per_load))
                name = units[name].key
            found[name] = column
    return found


def sweep_values(
    along: str, between: tuple[float, float] | None, count: int, parameters: Parameters
) -> tuple[Unit, NDArray]:
    """The unit of an axis, and its sampled values [SI]; arguments as in ``find``."""
    unit = unit_of(along)
    check_count("count", count)
    if between is None:
        default = UNITS[ENGINEERING[unit.condition]]
        ends = default.to_si(SEARCHED[unit.condition], parameters.newtons_per_load)
    else:
        ends = ends_in_si("between", between, unit, parameters)
    return unit, np.geomspace(*ends, count)


def crossings(
    limits: Sequence[tuple[str, NDArray]],
    unit: Unit,
    swept: NDArray,
    others: Mapping[str, NDArray],
    parameters: Parameters,
    rtol: float,
    progress: bool = True,
) -> tuple[NDArray, ...]:
    """Find the crossings of several variables, solved together, in the order of query and value.

    ``limits`` are pairs of a variable and its level for each query; ``swept``, the sampled values of the
    axis, and ``others`` are in SI.  Returns indices into ``limits``, and the fields of ``Crossings`` from
    ``query`` on.
    """
    check_rtol(rtol)
    levels = np.stack([level for _, level in limits])
    excess = _Excess([name for name, _ in limits], levels, unit.condition, others, parameters, rtol)
    limit, query, rises, *ends = _brackets(excess, swept, progress)
    root, width = bracketed_roots(
        lambda log_value: excess.at(limit, query, log_value)[0], *ends, 0.1 * rtol
    )
    error, status = _errors(excess, limit, query, root, 2.0 * (width + rtol))
    value = np.exp(root)
    place, error = (
        unit.from_si(each, parameters.newtons_per_load) for each in (value, value * np.expm1(error))
    )
    order = np.lexsort((value, query))
    return tuple(each[order] for each in (limit, query, place, error, rises, status))


@dataclass(frozen=True)
class _Excess:
    """Variables minus their levels, by limit and query, along an axis; other conditions in SI, by query."""

    names: list[str]
    levels: NDArray
    axis: str
    others: Mapping[str, NDArray]
    parameters: Parameters
    rtol: float

    def solved(self, query, values, progress=False):
        """Solutions of queries at values of the axis."""
        given = {name: column[query] for name, column in self.others.items()} | {self.axis: values}
        variables = {*self.names, "error_bound", "solution_status"}
        return solve_arrays(given, self.parameters, self.rtol, variables, progress)

    def everywhere(self, swept, progress):
        """All limits of all queries, in columns, at each of the values ``swept``."""
        found = self.solved(np.arange(self.levels.shape[1]), swept[:, None], progress)
        columns = [getattr(found, name) for name in self.names]
        return np.concatenate(columns, axis=1) - self.levels.ravel()

    def at(self, limit, query, log_value):
        """Limits of queries at ln of the axis, nan without solution; and the solution."""
        found = self.solved(query, np.exp(log_value))
        values = np.choose(limit, [getattr(found, name) for name in self.names])
        return values - self.levels[limit, query], found

    def certain_sign(self, limit, query, log_value):
        """The sign, 0 where the error of the variable may be larger; and the status."""
        excess, found = self.at(limit, query, log_value)
        margin = found.error_bound * np.abs(excess + self.levels[limit, query])
        return np.where(np.abs(excess) > margin, np.sign(excess), 0.0), found.solution_status


def _brackets(excess, swept, progress):
    """Limit and query of each change of sign, whether the variable rises there, and ln of the axis on
    both sides."""
    limit, query = (each.ravel() for each in np.indices(excess.levels.shape))
    values = excess.everywhere(swept, progress)
    log_values = np.broadcast_to(np.log(swept)[:, None], values.shape)
    brackets = []
    for depth in range(DEPTH + 1):
        above, known = values > 0.0, np.isfinite(values)
        step, place = np.nonzero((above[:-1] != above[1:]) & known[:-1] & known[1:])
        ends = log_values[step, place], log_values[step + 1, place]
        brackets.append((limit[place], query[place], above[step + 1, place], *ends))
        step, place = np.nonzero(_may_touch(values))
        if depth == DEPTH or not place.size:
            break
        ends = log_values[step, place], log_values[step + 2, place]
        log_values = np.linspace(*ends, 2 * FINER + 1)
        limit, query = limit[place], query[place]
        values, _ = excess.at(limit, query, log_values)
    return map(np.concatenate, zip(*brackets))


def _errors(excess, limit, query, root, error):
    """Distances from ``root`` in ln of the axis, from ``error`` on, at which the signs on both sides are
    certain and opposite, infinite if there are none; and the status."""
    for _ in range(ATTEMPTS):
        sign_above, _ = excess.certain_sign(limit, query, root + error)
        sign_below, status = excess.certain_sign(limit, query, root - error)
        certain = sign_above * sign_below < 0.0
        if certain.all():
            break
        error = np.where(certain, error, WIDER * error)
    return np.where(certain, error, np.inf), status


def _may_touch(excess):
    """Whether a curve may touch its level between three neighbouring values, by the index of the first."""
    distance, sign = np.abs(excess), np.sign(excess)
    first, middle, last = distance[:-2], distance[1:-1], distance[2:]
    same = (sign[:-2] == sign[1:-1]) & (sign[1:-1] == sign[2:])
    nearest = (middle < first) & (middle < last)
    return same & nearest & (middle <= np.maximum(first, last) - middle)
