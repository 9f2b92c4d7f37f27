"""The grid of the atlas: five axes, all combinations of which are solved."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from thirdbody.configuration.axes import axis_values
from thirdbody.data.conditions import AXES, CONDITION_AXES
from thirdbody.data.dataset import Axes
from thirdbody.model.parameters import Parameters


@dataclass(frozen=True)
class AtlasGrid:
    """The conditions of the atlas.

    Attributes
    ----------
    newtons : array
        Normal loads F_t [N], increasing; the same for all inputs, of which A_n makes another F_t* each.
    conditions : mapping
        The other four axes by name [SI], increasing.
    """

    newtons: NDArray[np.float64]
    conditions: Mapping[str, NDArray[np.float64]]

    @classmethod
    def of(cls, axes: Mapping[str, Mapping]) -> AtlasGrid:
        """The grid that ``axes`` of ``config/atlas.yaml`` describe."""
        others = {axis.name: axis.values(axis_values(axes[axis.key])) for axis in CONDITION_AXES}
        return cls(np.array(axis_values(axes["load_N"])), others)

    def chunk(self, number: int, chunks: int) -> AtlasGrid:
        """The part ``number``, from 1 on, of so many: some of the roughnesses.

        Examples
        --------
        >>> roughness = np.array([1e-7, 2e-7, 3e-7])
        >>> AtlasGrid(np.ones(1), {"roughness": roughness}).chunk(2, 2).conditions["roughness"]
        array([3.e-07])
        """
        return self.with_roughness(np.array_split(self.conditions["roughness"], chunks)[number - 1])

    def with_roughness(self, roughness: NDArray) -> AtlasGrid:
        """The same on some surfaces [m]."""
        return replace(self, conditions={**self.conditions, "roughness": roughness})

    def with_density(self, density: NDArray) -> AtlasGrid:
        """The same with some particle densities [m-2]."""
        return replace(self, conditions={**self.conditions, "particle_density": density})

    def axes(self, parameters: Parameters) -> Axes:
        """All five axes by name [SI], in the order of every dataset; the load is F_t* [1]."""
        load = self.newtons / parameters.newtons_per_load
        return {"load": load} | {name: self.conditions[name] for name in list(AXES)[1:]}

    @property
    def shape(self) -> tuple[int, ...]:
        """Lengths of the five axes."""
        return (self.newtons.size, *(self.conditions[name].size for name in list(AXES)[1:]))
