"""The conditions of an interface: how each is called, and in which units it is given.

The load and the four conditions that are held while it varies are the axes of every dataset.
Configuration and claims give them in engineering units, which the name of the key tells
(``viscosity_cSt``); arrays, files and tables hold SI.  Both are related here and nowhere else.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:  # tables are written without
    import numpy as np
    from numpy.typing import NDArray

CENTISTOKES = 1e-6  # [m2/s]
NANOMETRE = 1e-9  # [m]


@dataclass(frozen=True)
class Axis:
    """One condition of an interface: names, symbols and units.

    Attributes
    ----------
    name : str
        Argument of ``thirdbody.solve`` and dimension of every dataset.
    symbol : str
        Symbol of the paper in plain letters, as data files and labels of curves give it.
    sign : str
        The same symbol as figures print it.
    units : str
        SI unit, spelt as UDUNITS reads it.
    long_name : str
        What it is, for the attributes of datasets.
    column : str
        Column of tables, its name ending with the SI unit.
    description : str
        What it is, for the schema of tables.
    key : str
        Key of configuration and claims, its name ending with the engineering unit.
    unit : str
        Engineering unit, spelt like ``units``.
    scale : float
        Engineering unit in SI.
    """

    name: str
    symbol: str
    sign: str
    units: str
    long_name: str
    column: str
    description: str
    key: str
    unit: str
    scale: float

    def to_si(self, value: float) -> float:
        """The float nearest to the decimal number that ``value`` stands for in SI.

        A product with 1e-9 alone depends on how it is rounded (300 nm would be
        3.0000000000000004e-07 m); equal decimals must be equal conditions everywhere.

        Parameters
        ----------
        value : float
            In the engineering unit; its first twelve digits count.

        Returns
        -------
        float
            In the SI unit; nan stays nan.

        Examples
        --------
        >>> AXES["roughness"].to_si(300)
        3e-07
        >>> AXES["viscosity"].to_si(90)
        9e-05
        """
        return float(f"{value * self.scale:.12g}")

    def values(self, given: Iterable[float]) -> NDArray[np.float64]:
        """``given`` values [engineering unit] in SI, shape (n,): increasing, each once.

        Examples
        --------
        >>> AXES["viscosity"].values([90, 0, 90.0])
        array([0.e+00, 9.e-05])
        """
        import numpy as np

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
            units="1",
            long_name="dimensionless mean normal load",
            column="load",
            description="dimensionless mean normal load F_t*",
            key="load",
            unit="1",
            scale=1.0,
        ),
        Axis(
            name="viscosity",
            symbol="nu",
            sign="ν",
            units="m2 s-1",
            long_name="kinematic viscosity of the lubricant, 0 when dry",
            column="viscosity_m2_per_s",
            description="kinematic viscosity nu, 0 when dry",
            key="viscosity_cSt",
            unit="cSt",
            scale=CENTISTOKES,
        ),
        Axis(
            name="particle_diameter",
            symbol="x_a",
            sign="xₐ",
            units="m",
            long_name="mean diameter of the third particles, 0 without them",
            column="particle_diameter_m",
            description="mean particle diameter x_a, 0 without particles",
            key="particle_diameter_nm",
            unit="nm",
            scale=NANOMETRE,
        ),
        Axis(
            name="roughness",
            symbol="sigma",
            sign="σ",
            units="m",
            long_name="equivalent root mean square surface roughness",
            column="roughness_m",
            description="equivalent root mean square roughness sigma",
            key="roughness_nm",
            unit="nm",
            scale=NANOMETRE,
        ),
        Axis(
            name="particle_density",
            symbol="eta_a",
            sign="ηₐ",
            units="m-2",
            long_name="number of particles per unit area",
            column="particle_density_per_m2",
            description="particles per unit area eta_a",
            key="particle_density_per_m2",
            unit="m-2",
            scale=1.0,
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
        """The condition that a configuration gives.

        Parameters
        ----------
        given : Mapping
            A number for each key of the four axes; other keys are ignored.

        Raises
        ------
        KeyError
            If one of the four keys is missing.

        Examples
        --------
        >>> Condition.of(
        ...     {
        ...         "viscosity_cSt": 90,
        ...         "particle_diameter_nm": 500,
        ...         "roughness_nm": 300,
        ...         "particle_density_per_m2": 1e11,
        ...     }
        ... ).particle_diameter
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
