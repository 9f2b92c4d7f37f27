"""Crossings of levels along an axis: sampled, bracketed and refined.

The axis is sampled at logarithmically spaced values.  Two neighbours on opposite sides of the level
bracket a crossing, and the bracket is narrowed to the requested error.  Around an extremum near the
level the sampling is refined ``DEPTH`` times by the factor ``FINER``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.core.bracketing import bracketed_roots
from thirdbody.core.names import ERROR_BOUND, SOLUTION_STATUS
from thirdbody.core.parameters import Parameters
from thirdbody.core.solve import solve_points

FINER, DEPTH = 8, 2  # refinements around an extremum near the level
WIDER, ATTEMPTS = 8.0, 8  # factor and number of widenings until the signs on both sides are certain


class Crossings(NamedTuple):
    """Crossings of levels: arrays with an element per crossing, sorted by query and value.

    ``limit`` and ``query`` are indices into the limits and the queries.  ``value`` is that of the
    axis, and ``error`` a bound on its error, in SI.  At the distance ``error`` on both sides the
    variable is above and below the level by more than its ``error_bound``.  If float64 cannot
    decide this, ``error`` is infinite.  ``rises`` is whether the variable increases at the
    crossing, and ``solution_status`` is the status of the point.
    """

    limit: NDArray
    query: NDArray
    value: NDArray
    error: NDArray
    rises: NDArray
    solution_status: NDArray


def crossings(
    limits: Sequence[tuple[str, NDArray]],
    axis: str,
    samples: NDArray,
    others: Mapping[str, NDArray],
    parameters: Parameters,
    rtol: float,
    callback: Callable[[int], None] | None = None,
) -> Crossings:
    """Find the crossings of several variables, which are solved together.

    Parameters
    ----------
    limits : sequence of pairs
        A variable, and its level for each query [SI], shape (queries,).
    axis : str
        Name of the condition along which crossings are sought.
    samples : array
        Increasing values of the axis.
    others : mapping of arrays
        The other conditions of each query by name, shape (queries,).
    parameters, rtol
        As in ``solve_points``.
    callback : callable, optional
        Called with the number of samples of queries that have been solved since its last call.
    """
    levels = np.stack([level for _, level in limits])
    names = [name for name, _ in limits]
    excess = _Excess(names, levels, axis, others, parameters, rtol, callback)
    limit, query, rises, low, high = _brackets(excess, samples)
    root, width = bracketed_roots(
        lambda log_value: excess.at(limit, query, log_value)[0], low, high, 0.1 * rtol
    )
    error, status = _errors(excess, limit, query, root, 2.0 * (width + rtol))
    value = np.exp(root)
    order = np.lexsort((value, query))
    columns = limit, query, value, value * np.expm1(error), rises, status
    return Crossings(*(column[order] for column in columns))


@dataclass(frozen=True)
class _Excess:
    """Variables minus their levels along an axis, for each limit and query."""

    names: list[str]
    levels: NDArray
    axis: str
    others: Mapping[str, NDArray]
    parameters: Parameters
    rtol: float
    callback: Callable[[int], None] | None

    def solved(self, query, values, callback=None):
        """Variables by name for the queries at ``values`` of the axis."""
        points = {name: column[query] for name, column in self.others.items()} | {self.axis: values}
        variables = {*self.names, ERROR_BOUND, SOLUTION_STATUS}
        return solve_points(points, self.parameters, self.rtol, variables, callback)

    def everywhere(self, samples):
        """The excess at each of the ``samples`` (rows), for all limits of all queries (columns)."""
        queries = np.arange(self.levels.shape[1])
        solved = self.solved(queries, samples[:, None], self.callback)
        columns = [solved[name] for name in self.names]
        return np.concatenate(columns, axis=1) - self.levels.ravel()

    def at(self, limit, query, log_value):
        """The excess at ln of the axis, nan without solution, and the variables."""
        solved = self.solved(query, np.exp(log_value))
        values = np.choose(limit, [solved[name] for name in self.names])
        return values - self.levels[limit, query], solved

    def certain_sign(self, limit, query, log_value):
        """The sign of the excess, 0 where its error may be larger, and the status."""
        excess, solved = self.at(limit, query, log_value)
        margin = solved[ERROR_BOUND] * np.abs(excess + self.levels[limit, query])
        sign = np.where(np.abs(excess) > margin, np.sign(excess), 0.0)
        return sign, solved[SOLUTION_STATUS]


def _brackets(excess, samples):
    """The limit and query of each change of sign, whether the variable rises, and ln of the axis on
    both sides."""
    limit, query = (indices.ravel() for indices in np.indices(excess.levels.shape))
    values = excess.everywhere(samples)
    log_values = np.broadcast_to(np.log(samples)[:, None], values.shape)
    brackets = []
    for depth in range(DEPTH + 1):
        above, solved = values > 0.0, np.isfinite(values)
        step, curve = np.nonzero((above[:-1] != above[1:]) & solved[:-1] & solved[1:])
        ends = log_values[step, curve], log_values[step + 1, curve]
        brackets.append((limit[curve], query[curve], above[step + 1, curve], *ends))
        step, curve = np.nonzero(_may_touch(values))
        if depth == DEPTH or not curve.size:
            break
        ends = log_values[step, curve], log_values[step + 2, curve]
        log_values = np.linspace(*ends, 2 * FINER + 1)
        limit, query = limit[curve], query[curve]
        values, _ = excess.at(limit, query, log_values)
    return map(np.concatenate, zip(*brackets))


def _errors(excess, limit, query, root, error):
    """Bounds on the errors of ``root`` in ln of the axis, and the status.

    A bound is a distance, from ``error`` on, at which the signs on both sides are certain and
    opposite.  It is infinite if there is no such distance.
    """
    for _ in range(ATTEMPTS):
        sign_above, _ = excess.certain_sign(limit, query, root + error)
        sign_below, status = excess.certain_sign(limit, query, root - error)
        certain = sign_above * sign_below < 0.0
        if certain.all():
            break
        error = np.where(certain, error, WIDER * error)
    return np.where(certain, error, np.inf), status


def _may_touch(excess):
    """Whether a curve may touch its level between three neighbouring samples, at the index of the
    first sample."""
    distance, sign = np.abs(excess), np.sign(excess)
    first, middle, last = distance[:-2], distance[1:-1], distance[2:]
    same = (sign[:-2] == sign[1:-1]) & (sign[1:-1] == sign[2:])
    nearest = (middle < first) & (middle < last)
    return same & nearest & (middle <= np.maximum(first, last) - middle)
