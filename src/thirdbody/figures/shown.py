"""The curves that a dataset shows: not every combination of its axes belongs to the figure."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from thirdbody.data.conditions import Condition
from thirdbody.data.netcdf import shown_combinations
from thirdbody.figures.sheet.naming import label


@dataclass(frozen=True)
class Curve:
    """One curve of a dataset: its ``condition`` and its ``place`` behind the load axis."""

    condition: Condition
    place: tuple[int, ...]

    @property
    def label(self) -> str:
        """What the file of the drawn data calls it."""
        return label(self.condition)

    def values(self, data: xr.Dataset, name: str) -> NDArray[np.float64]:
        """Values of the variable ``name`` along the curve, shape (loads,)."""
        values = data[name].values
        return values if values.ndim == 1 else values[(slice(None), *self.place)]


def shown_curves(data: xr.Dataset) -> list[Curve]:
    """The curves that ``data`` shows, in the order of its axes."""
    axes = [data[name].values for name in Condition._fields]
    return [
        Curve(
            Condition(*(float(axis[i]) for axis, i in zip(axes, place, strict=True))), tuple(place)
        )
        for place in np.argwhere(shown_combinations(data)).tolist()
    ]
