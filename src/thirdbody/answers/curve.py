"""``Curve``: the variables of an interface along one axis, with their range over the ensemble."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from thirdbody.data.quantities import FLAGS, QUANTITIES
from thirdbody.data.spread import ENDS
from thirdbody.solver.solution import Solution
from thirdbody.tabular import Tabular

if TYPE_CHECKING:
    import pandas as pd


@dataclass(frozen=True)
class Curve(Tabular):
    """What ``Interface.curve`` returns.

    Attributes
    ----------
    along : str
        The axis and its unit, by its name; ``points`` are its values, in that unit.
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
        import pandas as pd

        values = {name: getattr(mine, name) for name in (*QUANTITIES, *FLAGS)}
        low, high = {}, {}
        for name in QUANTITIES if members else ():
            of_members = pd.DataFrame([getattr(member, name) for member in members])
            low[name], high[name] = of_members.quantile(ENDS).to_numpy()  # without nan
        return cls(along, points, values, low, high)

    def to_dataframe(self) -> pd.DataFrame:
        """A row a point: the axis in its unit, numbers in SI with their ranges, flags as words."""
        import pandas as pd

        table = {self.along: self.points}
        for name in QUANTITIES:
            table[name] = self.values[name]
            table |= {
                f"{name}_{end}": of_ensemble[name]
                for end, of_ensemble in (("low", self.low), ("high", self.high))
                if name in of_ensemble
            }
        for name, flag in FLAGS.items():
            table[name] = [
                flag.meanings[index] if index >= 0 else None for index in self.values[name]
            ]
        return pd.DataFrame(table)

    def as_dict(self) -> dict[str, list]:
        """Columns of the table as JSON holds them: None where there is no solution."""
        table = self.to_dataframe().astype(object)
        return table.where(table.notna() & ~table.isin([np.inf]), None).to_dict("list")

    def as_csv(self) -> str:
        """The table as CSV, with ten significant digits."""
        return self.to_dataframe().to_csv(index=False, float_format="%.10g", lineterminator="\n")
