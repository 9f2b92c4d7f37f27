"""Curves over the load: their conditions, in tables and in the configuration, and the variables and
panels of their figures."""

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
    """Conditions of a curve over the load: ν [m2/s], x_a [m], σ [m] and η_a [m-2].

    ν is 0 in dry contact, x_a or η_a in two-body contact.
    """

    viscosity: float
    particle_diameter: float
    roughness: float
    particle_density: float

    @classmethod
    def of(cls, given: Mapping[str, float]) -> Self:
        """The condition from numbers by alias, as in a configuration; ``KeyError`` if a number is
        missing."""
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
    """The condition with colours in a figure over the load, and the conditions with panels.

    ``levels`` has the values of all conditions.  Every value of the first condition has a colour,
    every combination of values of the others has panels.  Dry contact is black, and two-body
    contact is in all panels.
    """
    varying = [name for name in OF_PARTICLES if len(levels[name] - {0.0}) > 1]
    media = levels["viscosity"]
    if len(media - {0.0}) > 1 or (len(media) > 1 and not varying):
        varying.insert(0, "viscosity")
    if len(levels["roughness"]) > 1:
        varying.append("roughness")
    colours, *panels = varying or ["viscosity"]
    return colours, panels


def variables_over_load(levels: Mapping[str, Set[float]]) -> tuple[str, ...]:
    """The variables in a figure over the load: areas, and load fraction and film unless all is
    dry."""
    return LUBRICATED if has_film(np.array([*levels["viscosity"]])).any() else ALL_DRY


def condition_key(values: Iterable[float | None]) -> tuple[str, ...]:
    """A key for conditions, equal for numbers that differ only by rounding in files."""
    return tuple("" if value is None else f"{value:.9g}" for value in values)


def row_key(row: Mapping) -> tuple[str, ...]:
    """The ``condition_key`` of the curve in a row of a table."""
    return condition_key(row[axis.column] for axis in CONDITION_AXES)
