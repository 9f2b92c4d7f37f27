"""The curves that a dataset shows: not every combination of its axes belongs to the figure."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from thirdbody.data.conditions import Condition
from thirdbody.data.netcdf import shown_combinations
from thirdbody.figures.sheet.naming import label

AREA = "total_contact_area"
AREA_OVER_TWO_BODY = "total_contact_area_over_two_body"


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
        """Values along the curve, shape (loads,).

        Parameters
        ----------
        data : xarray.Dataset
            The dataset of the curve.
        name : str
            A variable of it, or ``AREA_OVER_TWO_BODY``: A_t* over that of dry two-body contact at
            the same load and roughness.

        Raises
        ------
        ValueError
            If the dataset holds no such two-body contact.
        """
        if name == AREA_OVER_TWO_BODY:
            roughness, references = self.condition.roughness, two_body_areas(data)
            if roughness not in references:
                raise ValueError(f"no dry two-body contact at a roughness of {roughness:g} m")
            return self.values(data, AREA) / references[roughness]
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


def two_body_areas(data: xr.Dataset) -> dict[float, NDArray[np.float64]]:
    """A_t* of dry two-body contact over the loads, by the roughness [m] that ``data`` has it for."""
    return {
        curve.condition.roughness: curve.values(data, AREA)
        for curve in shown_curves(data)
        if curve.condition.is_dry and curve.condition.is_two_body
    }
