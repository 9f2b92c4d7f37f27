"""What questions get: an ``Answer``, in rows of a quantity and its range over the ensemble, or a ``Curve``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from io import StringIO
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from thirdbody.data.quantities import FLAGS, QUANTITIES
from thirdbody.data.spread import ENDS, spread
from thirdbody.solver.solution import Solution
from thirdbody.tabular import Tabular

if TYPE_CHECKING:
    import pandas as pd

Value = float | str | None  # a number, the name of a regime or mode, or nothing: it does not occur
DIGITS = 4
# a rule below the headings, in letters that every encoding has
RULED = "    \n    \n -- \n    \n    \n    \n    \n    \n"
WIDTH = 200  # columns of a text that is not on a terminal


@dataclass(frozen=True)
class Row:
    """One quantity of an answer: its name, as other data have it, and what it is in words.

    ``value`` is that with the inputs of the interface, in ``unit``, None where it does not occur; ``low`` and
    ``high`` are the 5 % and 95 % quantiles over the members of the ensemble in which it occurs, None of a
    name.  Of ``members`` so many ``agree``: they have a number too, or the same name, or nothing either.  In a
    comparison ``other`` is the value of the second interface, and the range that of the difference.
    """

    name: str
    quantity: str
    value: Value
    unit: str = ""
    low: float | None = None
    high: float | None = None
    agree: int = 0
    members: int = 0
    other: Value = None

    @classmethod
    def of(
        cls, name: str, quantity: str, value: Value, unit: str, of_members: Sequence[Value]
    ) -> Row:
        """The row of a quantity that has the values ``of_members`` over the ensemble."""
        numbers = [each for each in of_members if isinstance(each, float)]
        low, high = spread(numbers) or (None, None)
        same = (
            numbers if isinstance(value, float) else [each for each in of_members if each == value]
        )
        return cls(name, quantity, value, unit, low, high, len(same), len(of_members))

    @property
    def range_text(self) -> str:
        """The range over the ensemble as a table shows it."""
        parts = []
        if self.low is not None:
            parts.append(f"{text_of(self.low)} to {text_of(self.high)}")
        if self.agree < self.members or (self.members and isinstance(self.value, str)):
            parts.append(f"{self.agree} of {self.members}" + (" have none" * (self.value is None)))
        return ", ".join(parts)


def text_of(value: Value) -> str:
    """A value as a table shows it."""
    if value is None:
        return "none"
    return value if isinstance(value, str) else f"{value:.{DIGITS}g}"


def few_particles(per_m2: float, apparent_area: float, name: str = "particles") -> tuple[str, ...]:
    """A note where less than one particle is in the nominal area A_n [m2].

    Examples
    --------
    >>> few_particles(2500.0, 2.4e-6)
    ('0.006 particles in A_n = 2.4e-06 m2: most contacts have none',)
    """
    count = per_m2 * apparent_area
    if not 0.0 < count < 1.0:
        return ()
    return (f"{count:.2g} {name} in A_n = {apparent_area:.3g} m2: most contacts have none",)


@dataclass(frozen=True)
class Answer(Tabular):
    """What a question gets.

    ``title`` is the question as it was understood, ``rows`` the answer, ``notes`` what else is to be known
    and ``found`` whether what was asked for occurs.
    """

    title: str
    rows: tuple[Row, ...]
    notes: tuple[str, ...] = ()
    found: bool = True

    def as_dict(self) -> dict:
        """Plain data, as JSON holds it."""
        return asdict(self)

    def to_dataframe(self) -> pd.DataFrame:
        """The rows as a table, in the columns of ``Row``."""
        import pandas as pd

        return pd.DataFrame([asdict(row) for row in self.rows])

    def value(self, name: str) -> Value:
        """The value of the first row of a name; ``KeyError`` if there is no such row."""
        return {row.name: row.value for row in reversed(self.rows)}[name]

    def as_text(self, width: int = WIDTH, on_terminal: bool = False) -> str:
        """The title, a table and the notes, at most ``width`` columns wide."""
        from rich.box import Box
        from rich.console import Console
        from rich.table import Table

        compares = any(row.other is not None for row in self.rows)
        headings = (
            ["first", "second", "90 % of the change"] if compares else ["value", "90 % range"]
        )
        box = Box(RULED, ascii=True)
        table = Table("quantity", *headings, "unit", box=box, show_edge=False, pad_edge=False)
        for row in self.rows:
            values = [row.value, row.other] if compares else [row.value]
            table.add_row(row.quantity, *map(text_of, values), row.range_text, row.unit)
        notes = ["", *(f"  {note}" for note in self.notes)] if self.notes else []
        text = StringIO()
        console = Console(
            file=text, width=width, force_terminal=on_terminal, markup=False, highlight=False
        )
        for part in (self.title, "", table, *notes):
            console.print(part)
        return "\n".join(line.rstrip() for line in text.getvalue().splitlines())

    def __str__(self) -> str:
        return self.as_text()


@dataclass(frozen=True)
class Curve(Tabular):
    """What ``Interface.curve`` returns: arrays of shape (n,) over an axis.

    ``along`` is the axis by its name with a unit, and ``points`` are its values in that unit.  ``values`` are the
    variables by their names, SI, nan where there is no solution; ``low`` and ``high`` the 5 % and 95 %
    quantiles of numbers over the ensemble, empty without one.
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
            if name in self.low:
                table |= {f"{name}_low": self.low[name], f"{name}_high": self.high[name]}
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
