"""The five conditions as axes of datasets, columns of tables and keys of the configuration."""

from collections.abc import Iterable, Mapping
from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from thirdbody.units import CONDITIONS, ENGINEERING, UNITS


class Axis(NamedTuple):
    """One condition: ``name`` in ``thirdbody.solve`` and datasets, ``column`` in tables, ``symbol``
    in ASCII and ``sign`` as printed in figures.

    ``units`` are SI in UDUNITS spelling; ``key`` is the key of configuration and claims, in the
    engineering unit ``unit``, which is ``scale`` in SI.
    """

    name: str
    column: str
    symbol: str
    sign: str
    long_name: str
    units: str
    key: str
    unit: str
    scale: float

    @classmethod
    def of(cls, name: str) -> Self:
        """The axis of a condition, from ``thirdbody/units.toml``."""
        described = CONDITIONS[name]
        # the load has no unit of its own: newtons also depend on the inputs
        key = name if name == "load" else ENGINEERING[name]
        return cls(
            name=name,
            **{each: described[each] for each in ("column", "symbol", "sign", "long_name")},
            units=UNITS[name].text,
            key=key,
            unit=UNITS[key].text,
            scale=UNITS[key].scale,
        )

    def to_si(self, value: float) -> float:
        """The float in SI nearest to the decimal ``value`` [engineering unit]: 300 nm is 3e-07 m."""
        return float(f"{value * self.scale:.12g}")

    def values(self, given: Iterable[float]) -> NDArray[np.float64]:
        """``given`` values [engineering unit] in SI, shape (n,): increasing and unique."""
        return np.unique(np.array([self.to_si(value) for value in given]))

    def from_si(self, value: float) -> float:
        """``value`` [SI] in the engineering unit, for texts: the last digit may differ."""
        return value / self.scale


AXES = {name: Axis.of(name) for name in CONDITIONS}
DIMENSIONS = tuple(AXES)  # of every dataset, in this order


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
        return cls(*(AXES[name].to_si(given[AXES[name].key]) for name in cls._fields))

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


CONDITION_AXES = tuple(AXES[name] for name in Condition._fields)  # all but the load


def condition_key(values: Iterable[float | None]) -> tuple[str, ...]:
    """A key of conditions that ignores the rounding of files."""
    return tuple("" if value is None else f"{value:.9g}" for value in values)


def row_key(row: Mapping) -> tuple[str, ...]:
    """The ``condition_key`` of the curve in a row of a table."""
    return condition_key(row[axis.column] for axis in CONDITION_AXES)
