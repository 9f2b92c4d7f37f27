"""An answer: rows of a quantity, its value, its range over the ensemble and its unit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass

from thirdbody.data.spread import spread

Value = float | str | None  # a number, the name of a regime or mode, or nothing: it does not occur
DIGITS = 4
NONE = "none"


@dataclass(frozen=True)
class Row:
    """One quantity of an answer.

    Attributes
    ----------
    name : str
        Its name, as other data have it.
    quantity : str
        What it is, in words.
    value : float, str or None
        With the inputs of the interface; None where it does not occur.
    unit : str
        Unit of ``value``, empty of a name.
    low, high : float or None
        The 5 % and 95 % quantiles over the members of the ensemble in which it occurs; None of a
        name.
    agree : int
        How many members have a number where ``value`` is one, or the same name, or nothing.
    members : int
        How many members there are.
    other : float, str or None
        In a comparison the value of the second interface; the range is that of the difference.
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
        """The row of a quantity that has ``of_members`` over the ensemble.

        Examples
        --------
        >>> row = Row.of("solid_load_fraction", "L_s", 0.5, "1", [0.4, 0.6, None])
        >>> row.agree, row.members
        (2, 3)
        """
        numbers = [each for each in of_members if isinstance(each, float)]
        low, high = spread(numbers) or (None, None)
        if isinstance(value, float):
            agree = len(numbers)
        else:
            agree = sum(each == value for each in of_members)
        return cls(name, quantity, value, unit, low, high, agree, len(of_members))

    @property
    def range_text(self) -> str:
        """The range over the ensemble as a table shows it."""
        parts = []
        if self.low is not None:
            parts.append(f"{shown(self.low)} to {shown(self.high)}")
        if self.agree < self.members or isinstance(self.value, str):
            parts.append(f"{self.agree} of {self.members}" + (" have none" * (self.value is None)))
        return ", ".join(parts)


def shown(value: Value) -> str:
    """A value as a table shows it.

    Examples
    --------
    >>> shown(0.000123456), shown(None), shown("mixed")
    ('0.0001235', 'none', 'mixed')
    """
    if value is None:
        return NONE
    return value if isinstance(value, str) else f"{value:.{DIGITS}g}"


@dataclass(frozen=True)
class Answer:
    """What a question gets.

    Attributes
    ----------
    title : str
        The question as it was understood.
    rows : tuple of Row
        The answer.
    notes : tuple of str
        What else is to be known: where it was searched, what the equations do not cover.
    found : bool
        Whether what was asked for occurs.
    """

    title: str
    rows: tuple[Row, ...]
    notes: tuple[str, ...] = ()
    found: bool = True

    def as_dict(self) -> dict:
        """Plain data, as JSON holds it."""
        return asdict(self)

    def value(self, name: str) -> Value:
        """The value of the first row of a name.

        Raises
        ------
        KeyError
            If there is no such row.
        """
        return {row.name: row.value for row in reversed(self.rows)}[name]

    def __str__(self) -> str:
        """The title, a table and the notes."""
        from tabulate import tabulate

        compares = any(row.other is not None for row in self.rows)
        values = ["first", "second", "90 % of the change"] if compares else ["value", "90 % range"]
        cells = [
            [
                row.quantity,
                shown(row.value),
                *([shown(row.other)] if compares else []),
                row.range_text,
                row.unit,
            ]
            for row in self.rows
        ]
        table = tabulate(
            cells, ["quantity", *values, "unit"], tablefmt="simple", disable_numparse=True
        )
        notes = ["", *(f"  {note}" for note in self.notes)] if self.notes else []
        return "\n".join([self.title, "", table, *notes])
