"""Answers to questions: ``Answer``, rows of quantities with ensemble ranges, and ``Curve``."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from io import StringIO
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from numpy.typing import NDArray

from thirdbody.ranges import spread
from thirdbody.tabular import Tabular

if TYPE_CHECKING:
    import pandas as pd

Value = float | str | None  # a number, the name of a regime or mode, or None: does not occur
DIGITS = 4
# a rule below the headings, in ASCII
RULED = "    \n    \n -- \n    \n    \n    \n    \n    \n"
HEADINGS = {
    f"{name}{end}": f"{name}{end} [{unit}]"
    for name, unit in (("separation", "m"), ("film_thickness", "1"))
    for end in ("", "_low", "_high")
}
WIDTH = 200  # columns of text that is not printed on a terminal


@dataclass(frozen=True)
class Row:
    """One quantity of an answer: its name in data files, and its description.

    ``value`` is computed with the inputs of the interface, in ``unit``; None if it does not occur.
    ``low`` and ``high`` are the 5 % and 95 % quantiles over the ensemble members in which it
    occurs; None for a name.  Of ``members`` members, ``agree`` also have a number, have the same
    name, or also have none.  In a comparison ``other`` is the value of the second interface, and
    the range is for the difference.
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
    ) -> Self:
        """The row of a quantity with the values ``of_members`` of the ensemble."""
        numbers = [each for each in of_members if isinstance(each, float)]
        low, high = spread(numbers) or (None, None)
        agree = len(numbers) if isinstance(value, float) else list(of_members).count(value)
        return cls(name, quantity, value, unit, low, high, agree, len(of_members))

    @property
    def range_text(self) -> str:
        """The range over the ensemble, formatted for a table."""
        parts = []
        if self.low is not None:
            parts.append(f"{_text(self.low)} to {_text(self.high)}")
        if self.agree < self.members or (self.members and isinstance(self.value, str)):
            parts.append(f"{self.agree} of {self.members}" + (" have none" * (self.value is None)))
        return ", ".join(parts)


def range_note(members: Sequence[Any]) -> str:
    """What a range is, once for an answer with ``members`` of the ensemble."""
    if not members:
        return (
            "no range: these inputs have no ensemble, or leave nothing in which its members differ"
        )
    return f"ranges are 5 to 95 % over {len(members)} sets of inputs that explain the paper about equally well"


def _text(value: Value) -> str:
    if value is None:
        return "none"
    return value if isinstance(value, str) else f"{value:.{DIGITS}g}"


def few_particles(per_m2: float, apparent_area: float, name: str = "particles") -> tuple[str, ...]:
    """A note if there is less than one particle in the nominal area A_n [m2]."""
    count = per_m2 * apparent_area
    note = f"{count:.2g} {name} in A_n = {apparent_area:.3g} m2: most contacts have none"
    return (note,) if 0.0 < count < 1.0 else ()


@dataclass(frozen=True)
class Answer(Tabular):
    """The answer to a question.

    ``title`` restates the question, ``rows`` are the results, ``notes`` further remarks, and
    ``found`` is whether the result exists.
    """

    title: str
    rows: tuple[Row, ...]
    notes: tuple[str, ...] = ()
    found: bool = True

    def as_dict(self) -> dict:
        """Plain data for JSON."""
        return asdict(self)

    def to_dataframe(self) -> "pd.DataFrame":
        """The rows as a table, in the columns of ``Row``."""
        import pandas as pd

        return pd.DataFrame(self.as_dict()["rows"])

    def value(self, name: str) -> Value:
        """The value of the row with a name; ``KeyError`` if there is none."""
        return {row.name: row.value for row in self.rows}[name]

    def as_text(self, width: int = WIDTH) -> str:
        """The title, a table and the notes, at most ``width`` columns wide."""
        from rich.box import Box
        from rich.console import Console
        from rich.table import Table

        headings = ["value", "range"]
        compares = any(row.other is not None for row in self.rows)
        if compares:
            headings = ["first", "second", "range of the change"]
        box = Box(RULED, ascii=True)
        table = Table("quantity", *headings, "unit", box=box, show_edge=False, pad_edge=False)
        for row in self.rows:
            values = [row.value, row.other] if compares else [row.value]
            table.add_row(row.quantity, *map(_text, values), row.range_text, row.unit)
        notes = ["", *(f"  {note}" for note in self.notes)] if self.notes else []
        console = Console(file=StringIO(), width=width, markup=False, highlight=False)
        for part in (self.title, "", table, *notes):
            console.print(part)
        return "\n".join(line.rstrip() for line in console.file.getvalue().splitlines())

    def __str__(self) -> str:
        return self.as_text()


@dataclass(frozen=True, eq=False)
class Curve(Tabular):
    """The result of ``Interface.curve``: a table ``values`` with a row per point.

    Its columns are the axis, by its name ``along`` with a unit; the variables, SI, nan without
    solution, each with ``_low`` and ``_high``, the ends of its ensemble range, if there is an
    ensemble; and regime, mode and status by name.
    """

    along: str
    values: "pd.DataFrame"

    @property
    def points(self) -> NDArray:
        """The values of the axis."""
        return self.values[self.along].to_numpy()

    def to_dataframe(self) -> "pd.DataFrame":
        """``values``, with units in headings: ``separation [m]``, ``film_thickness [1]``."""
        return self.values.rename(columns=HEADINGS)

    def as_dict(self) -> dict[str, list]:
        """Columns of the table for JSON: None where there is no solution."""
        table = self.values.astype(object)
        return table.where(table.notna() & ~table.isin([np.inf]), None).to_dict("list")

    def as_csv(self) -> str:
        """The table as CSV, with ten significant digits."""
        return self.to_dataframe().to_csv(index=False, float_format="%.10g", lineterminator="\n")

    def __str__(self) -> str:
        return self.as_csv().rstrip("\n")
