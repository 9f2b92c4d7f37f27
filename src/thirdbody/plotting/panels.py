"""What a figure shows, as data: curves, panels and their series."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from thirdbody.curves import Condition
from thirdbody.plotting.scales import label

CURVE = "curve"
LINE, OUTLINE = "line", "outline"  # how a series is drawn


@dataclass(frozen=True, eq=False)
class Curve:
    """One curve of a dataset: its condition; the values of each quantity over the load, shape
    (loads,); ``load`` and ``peak_ratio`` of its turning point, if it has one; and its line
    properties."""

    condition: Condition
    values: dict[str, NDArray]
    turning_point: Mapping[str, float]
    look: Mapping[str, Any] = field(default_factory=dict)

    @property
    def label(self) -> str:
        """Name in the file of the data drawn."""
        return label(self.condition)

    def has(self, name: str) -> bool:
        """Whether there are values of the quantity ``name`` along the curve."""
        return bool(np.isfinite(self.values.get(name, np.nan)).any())

    def at(self, name: str, load: float) -> float:
        """The quantity ``name`` at a ``load``, interpolated over ln load."""
        return float(np.interp(np.log(load), np.log(self.values["load"]), self.values[name]))


@dataclass(frozen=True, eq=False)
class Series:
    """Points [SI] of a panel under a name, the condition of their curve, and their properties in
    matplotlib.  The kind is ``CURVE``, "band", "turning points", ...
    """

    kind: str
    name: str
    x: NDArray
    y: NDArray
    curve: Condition | None = None
    look: Mapping[str, Any] = field(default_factory=dict)
    drawn_as: str = LINE

    @property
    def labels(self) -> set[str]:
        """Labels of its entries in the key."""
        return {self.look["label"]} if "label" in self.look else set()


@dataclass(frozen=True, eq=False)
class Panel:
    """A panel: title, quantities on its axes, and series.

    ``letter`` is set when it is drawn.  A logarithmic axis of a fraction begins at ``least``; 0 is
    for a linear axis.  ``conditions`` are those that no other panel has."""

    title: str
    x: str
    y: str
    series: list[Series]
    letter: str = ""
    least: float = 0.0
    conditions: str = ""

    def of_kind(self, kind: str) -> list[Series]:
        """The series of one kind."""
        return [one for one in self.series if one.kind == kind]
