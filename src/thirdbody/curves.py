"""Curves over the load: their conditions, in tables and keys of the configuration, and those of a dataset."""

from collections.abc import Iterable, Mapping
from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from thirdbody.netcdf import FILL_FLAG, Dataset
from thirdbody.variables import AXES, CONDITION_AXES, STATUS


class Condition(NamedTuple):
    """Conditions of a curve over the load, SI: ν [m2/s], 0 in dry contact; mean x_a [m] and η_a
    [m-2], 0 in two-body contact; σ [m]."""

    viscosity: float
    particle_diameter: float
    roughness: float
    particle_density: float

    @classmethod
    def of(cls, given: Mapping[str, float]) -> Self:
        """The condition from a configuration, a number for each key; ``KeyError`` if one is missing."""
        return cls(*(float(axis.to_si(given[axis.alias])) for axis in CONDITION_AXES))

    @property
    def columns(self) -> dict[str, float]:
        return {AXES[name].column: value for name, value in self._asdict().items()}

    @property
    def diameter_ratio(self) -> float:
        """x_a/σ [1], without rounding noise."""
        return round(self.particle_diameter / self.roughness, 9)

    @property
    def is_dry(self) -> bool:
        return self.viscosity == 0.0

    @property
    def is_two_body(self) -> bool:
        return self.particle_diameter == 0.0 or self.particle_density == 0.0


def condition_key(values: Iterable[float | None]) -> tuple[str, ...]:
    """A key of conditions that ignores the rounding of files."""
    return tuple("" if value is None else f"{value:.9g}" for value in values)


def row_key(row: Mapping) -> tuple[str, ...]:
    """The ``condition_key`` of the curve in a row of a table."""
    return condition_key(row[axis.column] for axis in CONDITION_AXES)


def curves_of(dataset: Dataset) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """The curves of a dataset, with at least one point with a status: their conditions, SI, in the
    order of ``Condition``, shape (4, curves); and their index in a variable after its load axis,
    ``values[:, index]``."""
    status = dataset[STATUS].values
    # nan where xarray has masked points, which it converts to floats
    shown = (np.isfinite(status) & (status != FILL_FLAG)).any(axis=0)
    axes = [dataset[name].values for name in Condition._fields]
    conditions = np.stack([grid[shown] for grid in np.meshgrid(*axes, indexing="ij")])
    return conditions, shown
