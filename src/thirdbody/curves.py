"""Curves over the load: their conditions, in tables and keys of the configuration, and what a
figure shows of them.
"""

from collections.abc import Iterable, Mapping, Set
from typing import NamedTuple, Self

import numpy as np

from thirdbody.core.film import has_film
from thirdbody.core.particles import has_particles
from thirdbody.variables import AXES, CONDITION_AXES

OF_PARTICLES = "particle_diameter", "particle_density"
MOST_PANELS = 26  # of a figure: each has a letter
ALL_DRY = "particle_contact_area_ratio", "total_contact_area"
LUBRICATED = (*ALL_DRY, "solid_load_fraction", "film_thickness")


class Condition(NamedTuple):
    """Conditions of a curve over the load, SI: ν [m2/s], 0 in dry contact; mean x_a [m] and η_a
    [m-2], 0 in two-body contact; σ [m]."""

    viscosity: float
    particle_diameter: float
    roughness: float
    particle_density: float

    @classmethod
    def of(cls, given: Mapping[str, float]) -> Self:
        """The condition from a configuration, a number for each key; ``KeyError`` if one is
        missing.
        """
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
        return not has_film(np.asarray(self.viscosity))

    @property
    def is_two_body(self) -> bool:
        return not has_particles(*np.array([self.particle_diameter, self.particle_density]))


def colours_and_panels(levels: Mapping[str, Set[float]]) -> tuple[str, list[str]]:
    """The condition whose values have colours in a figure over the load, and the conditions of
    which each value has panels of its own, from the ``levels`` of all.  Dry contact is black, and
    two-body contact is in each panel."""
    varying = [name for name in OF_PARTICLES if len(levels[name] - {0.0}) > 1]
    media = levels["viscosity"]
    if len(media - {0.0}) > 1 or (len(media) > 1 and not varying):
        varying.insert(0, "viscosity")
    if len(levels["roughness"]) > 1:
        varying.append("roughness")
    colours, *panels = varying or ["viscosity"]
    return colours, panels


def variables_over_load(levels: Mapping[str, Set[float]]) -> tuple[str, ...]:
    """The variables that a figure over the load shows: areas, also load fractions and film unless
    all is dry.
    """
    return LUBRICATED if has_film(np.array([*levels["viscosity"]])).any() else ALL_DRY


def condition_key(values: Iterable[float | None]) -> tuple[str, ...]:
    """A key of conditions that ignores the rounding of files."""
    return tuple("" if value is None else f"{value:.9g}" for value in values)


def row_key(row: Mapping) -> tuple[str, ...]:
    """The ``condition_key`` of the curve in a row of a table."""
    return condition_key(row[axis.column] for axis in CONDITION_AXES)
