"""The curves of a dataset: not every combination of its axes belongs to the figure."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from thirdbody.data.conditions import Condition, condition_key
from thirdbody.data.plain import PlainDataset, Variable
from thirdbody.data.quantities import curves_of
from thirdbody.figures.scales import label

AREA = "total_contact_area"
AREA_OVER_TWO_BODY = "total_contact_area_over_two_body"


@dataclass(frozen=True, eq=False)
class Curve:
    """One curve of a dataset: its ``condition``, its ``place`` behind the load axis, and ``load`` and
    ``peak_ratio`` of its turning point, if it is known to have one."""

    data: PlainDataset
    condition: Condition
    place: tuple[int, ...]
    turning_point: Mapping[str, float]

    @property
    def label(self) -> str:
        """Name in the file of the drawn data."""
        return label(self.condition)

    def values(self, name: str) -> NDArray[np.float64]:
        """Values of the variable ``name`` along the curve, shape (loads,)."""
        values = self.data[name].values
        return values if values.ndim == 1 else values[(slice(None), *self.place)]

    def at(self, name: str, load: float) -> float:
        """The variable ``name`` at a ``load``, interpolated over its logarithm; or one of the two numbers
        of a panel of turning points, which are the same at all loads."""
        if name == "diameter_ratio":
            return self.condition.diameter_ratio
        if name == "turning_point_ratio":
            return self.turning_point["peak_ratio"]
        loads = np.log(self.values("load"))
        return float(np.interp(np.log(load), loads, self.values(name)))


def curves_in(data: PlainDataset, turning_points: Iterable[Mapping] = ()) -> list[Curve]:
    """The curves of ``data``, in the order of its axes; ``turning_points`` have the four conditions."""
    found = {
        condition_key(each[name] for name in Condition._fields): each for each in turning_points
    }
    conditions, shown = curves_of(data)
    return [
        Curve(data, Condition(*values), tuple(place), found.get(condition_key(values), {}))
        for values, place in zip(conditions.T.tolist(), np.argwhere(shown).tolist(), strict=True)
    ]


def with_relative_area(data: PlainDataset) -> PlainDataset:
    """``data`` with A_t* over that of dry two-body contact at the same load and roughness, unless it has
    no areas, or a surface no such contact."""
    if AREA not in data:
        return data
    curves = curves_in(data)
    references = {
        curve.condition.roughness: curve.values(AREA)
        for curve in curves
        if curve.condition.is_dry and curve.condition.is_two_body
    }
    if any(curve.condition.roughness not in references for curve in curves):
        return data
    reference = np.column_stack([references[value] for value in data["roughness"].values])
    area = data[AREA]
    relative = area.values / reference[:, np.newaxis, np.newaxis, :, np.newaxis]
    return data.assign({AREA_OVER_TWO_BODY: Variable(area.dims, relative)})
