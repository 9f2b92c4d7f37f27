"""How each variable stands on an axis: its title, symbol and scale, and the limits drawn across."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from thirdbody.data.conditions import AXES
from thirdbody.data.quantities import VARIABLES
from thirdbody.figures.naming import power_text
from thirdbody.figures.sheet.symbols import Symbol
from thirdbody.model.regimes import BOUNDARY_LIMIT, FULL_FILM_LIMIT, PARTICLE_LIMIT, SURFACE_LIMIT


@dataclass(frozen=True)
class Scale:
    """The axis of one variable.

    Attributes
    ----------
    name : str
        A variable, the axis ``load``, or what is derived from them.
    title : str
        What panels are called that show it.
    sign : str
        Its symbol in plain letters, unless it is a variable of datasets, which have theirs.
    logarithmic : bool
        Whether the axis is.
    unit : float
        What the labels of the ticks count in.
    unit_text : str
        That unit as the label of the axis prints it.
    share : bool
        Whether the axis runs from 0 to 1 where its curves do.
    plain : bool
        Whether the labels of a logarithmic axis are numbers with their unit, not powers of ten.
    limits, zones : tuple
        Limits of regimes or modes, and the names of what lies between them, both from below.
    """

    name: str
    title: str
    sign: str = ""
    logarithmic: bool = False
    unit: float = 1.0
    unit_text: str = ""
    share: bool = False
    plain: bool = False
    limits: tuple[float, ...] = ()
    zones: tuple[str, ...] = ()

    @property
    def symbol(self) -> Symbol:
        """The paper's symbol, with the unit."""
        return Symbol.of(self.sign or (AXES | VARIABLES)[self.name].symbol, self.unit_text)

    def ends(self, low: float, high: float) -> tuple[float, float]:
        """Ends of the axis around data from ``low`` to ``high``."""
        if self.logarithmic:
            margin = (high / low) ** 0.02
            return low / margin, high * margin
        if self.share:
            top = 1.08 * high if 0.0 < high < 0.5 else 1.0
            return -0.06 * top, 1.08 * top
        margin = 0.04 * (high - low)
        return low - margin, high + margin

    def ticks(self, low: float, high: float) -> tuple[NDArray, list[str], NDArray]:
        """Ticks of the axis from ``low`` to ``high``.

        Returns
        -------
        major, labels, minor
            Places of the major ticks and their labels, places of the minor ones.
        """
        return self._decades(low, high) if self.logarithmic else self._steps(low, high)

    def _decades(self, low, high):
        low, high = low / self.unit, high / self.unit
        first, last = math.ceil(math.log10(low)), math.floor(math.log10(high))
        decades = 10.0 ** np.arange(first - 1, last + 1)
        major, minor = 10.0 * decades[:-1], np.outer(decades, np.arange(2, 10)).ravel()
        if self.unit != 1.0:  # numbers of a few decades, which need more of them
            major = np.outer(decades, [1, 2, 5]).ravel()
            major = major[(major >= low) & (major <= high)]
        minor = minor[(minor > low) & (minor < high)]
        text = f"{{:g}} {self.unit_text}".format if self.plain else power_text
        text = text if self.unit == 1.0 else "{:g}".format
        return major * self.unit, [text(place) for place in major], minor * self.unit

    def _steps(self, low, high):
        places = MaxNLocator(6, steps=[1, 2, 5, 10]).tick_values(low, high)
        major = places[(places >= low) & (places <= high)]
        middle = 0.5 * (places[1:] + places[:-1])
        minor = middle[(middle > low) & (middle < high)]
        return major, [f"{place / self.unit:.6g}" for place in major], minor


SCALES = {
    scale.name: scale
    for scale in (
        Scale("load", "Dimensionless normal load", logarithmic=True),
        Scale("total_contact_area", "Real contact area", logarithmic=True),
        Scale(
            "particle_contact_area_ratio",
            "Contact area ratio of particles",
            share=True,
            limits=(SURFACE_LIMIT, PARTICLE_LIMIT),
            zones=("s-s", "hybrid", "p-s"),
        ),
        Scale(
            "solid_load_fraction",
            "Load percentage of solid",
            unit=0.01,
            unit_text="%",
            share=True,
            limits=(FULL_FILM_LIMIT, BOUNDARY_LIMIT),
            zones=("F.L.", "M.L.", "B.L."),
        ),
        Scale("film_thickness", "Film thickness", unit=1e-4, unit_text="10⁻⁴"),
        Scale(
            "total_contact_area_over_two_body",
            "Area over that of dry two-body contact",
            sign="A_t*",
            unit_text="over dry two-body",
        ),
        Scale(
            "largest_particle_diameter",
            "Largest particle out of the p-s mode",
            sign="x_a",
            unit=1e-9,
            unit_text="nm",
            logarithmic=True,
        ),
        Scale(
            "least_viscosity",
            "Least viscosity out of boundary lubrication",
            sign="ν",
            unit=1e-6,
            unit_text="cSt",
            logarithmic=True,
        ),
        Scale("diameter_ratio", "Particle diameter over roughness", sign="xₐ/σ"),
        Scale(
            "turning_point_ratio",
            "Where turning points occur",
            sign="A_sa,t*",
            unit_text="at the turning point",
            share=True,
            limits=(SURFACE_LIMIT, PARTICLE_LIMIT),
            zones=("s-s", "hybrid", "p-s"),
        ),
    )
}
# the upper edge of panels over the load
NEWTONS = Scale("normal_load", "Normal load", logarithmic=True, unit_text="N", plain=True)
