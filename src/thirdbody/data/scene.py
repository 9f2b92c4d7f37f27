"""A scene: the load axis and the groups of curves that one figure shows."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from thirdbody.data.conditions import AXES, CONDITION_AXES, Condition

RELATIVE_DIAMETER = "particle_diameter_per_roughness"  # key in the place of the diameter's own


def curve_groups(group: Mapping) -> list[Condition]:
    """The groups of curves that one entry of ``curves`` in ``config/scenes.yaml`` describes: a group is
    every combination of four axes, each 1-D and increasing, SI.

    Diameters relative to the roughness make a group of each roughness.
    """
    if RELATIVE_DIAMETER not in group:
        return [Condition(*(axis.values(group[axis.key]) for axis in CONDITION_AXES))]
    roughness, diameter = AXES["roughness"].key, AXES["particle_diameter"].key
    absolute = {name: values for name, values in group.items() if name != RELATIVE_DIAMETER}
    found = []
    for sigma in group[roughness]:
        diameters = [ratio * sigma for ratio in group[RELATIVE_DIAMETER]]
        found += curve_groups(absolute | {roughness: [sigma], diameter: diameters})
    return found


@dataclass(frozen=True)
class Scene:
    """What a dataset holds: its title, the load axis F_t* [1], shape (n,), increasing, and the groups of
    curves that are shown, each of arrays as of ``curve_groups``; a combination that stands in several
    groups is shown once."""

    title: str
    load: NDArray[np.float64]
    groups: tuple[Condition, ...]

    @classmethod
    def of(cls, scene: Mapping, newtons_per_load: float) -> Scene:
        """The scene of a valid entry of ``config/scenes.yaml``, with its load axis in newtons."""
        groups = [each for entry in scene["curves"] for each in curve_groups(entry)]
        load = load_values(scene["load_axis"], scene.get("named_loads", []), newtons_per_load)
        return cls(scene["title"], load, tuple(groups))

    @property
    def size(self) -> int:
        """Number of points."""
        return self.load.size * sum(math.prod(map(len, group)) for group in self.groups)

    def axis(self, name: str) -> NDArray[np.float64]:
        """Values of the dimension ``name`` over all groups, SI, shape (n,), increasing."""
        if name == "load":
            return self.load
        return np.unique(np.concatenate([getattr(group, name) for group in self.groups]))

    def placed(self, group: Condition) -> tuple[NDArray[np.intp], ...]:
        """Where the points of ``group`` stand in arrays over the five axes of the scene: five index arrays,
        as of ``numpy.ix_``."""
        positions = [
            np.searchsorted(self.axis(name), values) for name, values in group._asdict().items()
        ]
        return np.ix_(np.arange(self.load.size), *positions)


def load_values(
    axis: Mapping, named_loads: Iterable[float], newtons_per_load: float
) -> NDArray[np.float64]:
    """Values of the load axis [1]: as many as the ``axis`` counts, evenly spaced in their logarithm
    between its ends [N], joined by those ``named_loads`` [1] of the text that lie between them."""
    first, last = (AXES["load"].to_si(newtons / newtons_per_load) for newtons in axis["load_N"])
    spaced = np.geomspace(first, last, axis["count"])
    named = [value for value in named_loads if first <= value <= last]
    return np.unique(np.concatenate([spaced, named]))
