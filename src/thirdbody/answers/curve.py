"""``Curve``: the variables of an interface along one axis, with their range over the ensemble."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from thirdbody.data.quantities import FLAGS, QUANTITIES
from thirdbody.data.spread import ENDS
from thirdbody.solver.solution import Solution


@dataclass(frozen=True)
class Curve:
    """What ``Interface.curve`` returns.

    Attributes
    ----------
    along : str
        The axis and its unit, by its name.
    points : array, shape (n,)
        Values of the axis, in that unit.
    values : mapping
        Arrays of shape (n,) by the names of variables, SI; nan where there is no solution.
    low, high : mapping
        5 % and 95 % quantiles of the ensemble, by the names of numbers; empty without one.
    """

    along: str
    points: NDArray
    values: Mapping[str, NDArray]
    low: Mapping[str, NDArray]
    high: Mapping[str, NDArray]

    @classmethod
    def of(cls, along: str, points: NDArray, mine: Solution, members: list[Solution]) -> Curve:
        """The curve of solutions with the inputs of the interface and with those of the ensemble."""
        values = {name: getattr(mine, name) for name in (*QUANTITIES, *FLAGS)}
        if not members:
            return cls(along, points, values, {}, {})
        low, high = {}, {}
        for name in QUANTITIES:
            several = np.stack([getattr(member, name) for member in members])
            low[name], high[name] = (_quantile(several, end) for end in ENDS)
        return cls(along, points, values, low, high)

    def columns(self) -> dict[str, list]:
        """Columns of a table: numbers, None where there is none, and flags as words."""
        table = {self.along: self.points.tolist()}
        for name in QUANTITIES:
            table[name] = _numbers(self.values[name])
            for end, of_ensemble in (("low", self.low), ("high", self.high)):
                if name in of_ensemble:
                    table[f"{name}_{end}"] = _numbers(of_ensemble[name])
        for name, flag in FLAGS.items():
            table[name] = [
                flag.meanings[index] if index >= 0 else None for index in self.values[name].tolist()
            ]
        return table

    def as_csv(self) -> str:
        """The table as CSV, with ten significant digits: the axis in its unit, all else in SI."""
        table = self.columns()
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(table)
        for row in zip(*table.values(), strict=True):
            writer.writerow([f"{cell:.10g}" if isinstance(cell, float) else cell for cell in row])
        return text.getvalue()


def _numbers(values):
    return [value if np.isfinite(value) else None for value in values.tolist()]


def _quantile(several, end):
    """The quantile over members that have a solution; nan where none has."""
    found = np.full(several.shape[1:], np.nan)
    some = np.isfinite(several).any(axis=0)
    found[some] = np.nanquantile(several[:, some], end, axis=0)
    return found
