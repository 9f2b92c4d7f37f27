"""The curves of a dataset: not every combination of its axes belongs to the figure."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from thirdbody.data.conditions import Condition, condition_key
from thirdbody.data.plain import PlainDataset
from thirdbody.data.quantities import curves_of
from thirdbody.figures.scales import label

AREA = "total_contact_area"
RELATIVE_AREA = "total_contact_area_over_two_body"


@dataclass(frozen=True, eq=False)
class Curve:
    """One curve of a dataset: its ``condition``, and its ``place`` behind the load axis; ``load`` and
    ``peak_ratio`` of its turning point, if it is known to have one; the ``reference`` of its area, dry
    two-body contact on the same surface, if the dataset has it."""

    data: PlainDataset
    condition: Condition
    place: tuple[int, ...]
    turning_point: Mapping[str, float]
    reference: Curve | None = None

    @property
    def label(self) -> str:
        """Name in the file of the drawn data."""
        return label(self.condition)

    def has(self, name: str) -> bool:
        """Whether there are values of the quantity ``name`` along the curve."""
        stored = AREA if name == RELATIVE_AREA else name
        return stored in self.data and bool(np.isfinite(self.values(name)).any())

    def values(self, name: str) -> NDArray[np.float64]:
        """Values of the quantity ``name`` along the curve, shape (loads,)."""
        if name == RELATIVE_AREA:
            reference = self.reference.values(AREA) if self.reference else np.nan
            return self.values(AREA) / reference
        values = self.data[name].values
        return values if values.ndim == 1 else values[(slice(None), *self.place)]

    def at(self, name: str, load: float) -> float:
        """The quantity ``name`` at a ``load``, interpolated over its logarithm; or one of the two numbers
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
    curves = [
        Curve(data, Condition(*values), tuple(place), found.get(condition_key(values), {}))
        for values, place in zip(conditions.T.tolist(), np.argwhere(shown).tolist(), strict=True)
    ]
    references = {
        curve.condition.roughness: curve
        for curve in curves
        if curve.condition.is_dry and curve.condition.is_two_body
    }
    return [replace(curve, reference=references.get(curve.condition.roughness)) for curve in curves]
