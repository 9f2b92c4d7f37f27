"""The five conditions as axes of datasets, columns of tables and keys of the configuration."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.units import ENGINEERING, UNITS


@dataclass(frozen=True)
class Axis:
    """One condition: names, symbols and units.

    ``name`` is the argument of ``thirdbody.solve`` and the dimension of every dataset; ``symbol`` and
    ``sign`` are the symbol of the paper in plain letters and as figures print it; ``column`` is the
    column of tables, its name ending with the SI unit; ``long_name`` says what it is in datasets.
    """

    name: str
    symbol: str
    sign: str
    long_name: str
    column: str

    @property
    def units(self) -> str:
        """SI unit, spelt as UDUNITS reads it."""
        return UNITS[self.name].text

    @property
    def key(self) -> str:
        """Key of configuration and claims, its name ending with the engineering unit."""
        return self.name if self.name == "load" else ENGINEERING[self.name]

    @property
    def unit(self) -> str:
        """Engineering unit of ``key``, spelt like ``units``."""
        return UNITS[self.key].text

    @property
    def scale(self) -> float:
        """Engineering unit in SI."""
        return UNITS[self.key].scale

    def to_si(self, value: float) -> float:
        """The float in SI that is nearest to the decimal ``value`` [engineering unit].

        Examples
        --------
        >>> AXES["roughness"].to_si(300)
        3e-07
        """
        return float(f"{value * self.scale:.12g}")

    def values(self, given: Iterable[float]) -> NDArray[np.float64]:
        """``given`` values [engineering unit] in SI, shape (n,): increasing, each once.

        Examples
        --------
        >>> AXES["viscosity"].values([90, 0, 90.0])
        array([0.e+00, 9.e-05])
        """
        return np.unique(np.array([self.to_si(value) for value in given]))

    def from_si(self, value: float) -> float:
        """``value`` [SI] in the engineering unit, for texts: it may differ in the last digit."""
        return value / self.scale


AXES = {
    axis.name: axis
    for axis in (
        Axis(
            name="load",
            symbol="F_t*",
            sign="Fₜ*",
            long_name="dimensionless mean normal load",
            column="load",
        ),
        Axis(
            name="viscosity",
            symbol="nu",
            sign="ν",
            long_name="kinematic viscosity of the lubricant, 0 when dry",
            column="viscosity_m2_per_s",
        ),
        Axis(
            name="particle_diameter",
            symbol="x_a",
            sign="xₐ",
            long_name="mean diameter of the third particles, 0 without them",
            column="particle_diameter_m",
        ),
        Axis(
            name="roughness",
            symbol="sigma",
            sign="σ",
            long_name="equivalent root mean square surface roughness",
            column="roughness_m",
        ),
        Axis(
            name="particle_density",
            symbol="eta_a",
            sign="ηₐ",
            long_name="number of particles per unit area",
            column="particle_density_per_m2",
        ),
    )
}
DIMENSIONS = tuple(AXES)  # of every dataset, in this order


class Condition(NamedTuple):
    """What is held along one curve while the load varies, SI.

    Attributes
    ----------
    viscosity : float
        ν [m2/s]; 0 is dry contact.
    particle_diameter : float
        Mean x_a [m]; 0 is two-body contact.
    roughness : float
        σ [m].
    particle_density : float
        η_a [m-2]; 0 is two-body contact.
    """

    viscosity: float
    particle_diameter: float
    roughness: float
    particle_density: float

    @classmethod
    def of(cls, given: Mapping[str, float]) -> Condition:
        """The condition of a configuration, a number for each key; ``KeyError`` if one is missing.

        Examples
        --------
        >>> given = {"viscosity_cSt": 90, "particle_diameter_nm": 500, "roughness_nm": 300}
        >>> Condition.of(given | {"particle_density_per_m2": 1e11}).particle_diameter
        5e-07
        """
        return cls(*(AXES[name].to_si(given[AXES[name].key]) for name in cls._fields))

    @property
    def columns(self) -> dict[str, float]:
        """The four numbers by the names of the columns of tables."""
        return {AXES[name].column: value for name, value in self._asdict().items()}

    @property
    def diameter_ratio(self) -> float:
        """x_a/σ [1], free of rounding."""
        return round(self.particle_diameter / self.roughness, 9)

    @property
    def is_dry(self) -> bool:
        """Whether there is no lubricant."""
        return self.viscosity == 0.0

    @property
    def is_two_body(self) -> bool:
        """Whether there are no particles."""
        return self.particle_diameter == 0.0 or self.particle_density == 0.0


CONDITION_AXES = tuple(AXES[name] for name in Condition._fields)  # all but the load


def condition_key(values: Iterable[float | None]) -> tuple[str, ...]:
    """Conditions free of the rounding of files."""
    return tuple("" if value is None else f"{value:.9g}" for value in values)


def row_key(row: Mapping) -> tuple[str, ...]:
    """The ``condition_key`` of the curve that a row of a table is about."""
    return condition_key(row[axis.column] for axis in CONDITION_AXES)
