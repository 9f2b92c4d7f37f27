"""The variables of the datasets: name, symbol, unit, equation and meaning."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.data.conditions import Condition
from thirdbody.model.regimes import FLAG_MEANINGS

if TYPE_CHECKING:
    from thirdbody.data.netcdf import PlainDataset

# meaning of each status
STATUS_MEANINGS = {
    "converged": "the equations hold to the error asked for",
    "outside_film_formula": (
        "the film carries more than a thousandth of the load where Eq. 7 has no meaning: it would "
        "grow with falling viscosity, is thicker than a hundredth of the ball's radius, or presses "
        "harder on the interface than the softer surface is"
    ),
    "coverage_exceeded": "particles would cover the whole interface, in Eq. 4 or in Eq. 5",
    "not_converged": (
        "float64 does not promise the error asked for, and error_bound says what the values are "
        "good for"
    ),
    "several_separations": (
        "the forces balance at several separations, of which the largest is given: closing "
        "surfaces meet it first"
    ),
    "area_exceeded": "the real contact area would be larger than the apparent one, A_t* > 1",
    "load_exceeded": "the load is more than what is carried at any separation of zero or more",
}
STATUS = "solution_status"  # the flag that qualifies all other variables
# Values of points that a figure does not show: the fill values of NetCDF.  For a flag it is a value
# with a meaning, not_shown, because xarray converts integers with missing values to floats.
FILL_FLOAT = 9.969209968386869e36
FILL_FLAG = np.int8(-127)
ENDS = (0.05, 0.95)  # quantiles at the ends of the range over an ensemble


class Quantity(NamedTuple):
    """One variable of datasets and of ``thirdbody.Solution``: ``symbol`` of the paper in ASCII,
    ``equation`` or section that defines it, ``units`` SI in UDUNITS spelling.  Values are between 0
    and ``largest``."""

    name: str
    long_name: str
    symbol: str = "none"
    equation: str = "none"
    units: str = "1"
    largest: float = math.inf
    comment: str = ""

    @property
    def meanings(self) -> tuple[str, ...]:
        """Meanings of the values 0, 1, ... of a flag; empty for a number."""
        return FLAG_MEANINGS.get(self.name, ())


def _by_name(*quantities: Quantity) -> dict[str, Quantity]:
    return {quantity.name: quantity for quantity in quantities}


PARTICLES = "contact area of particles over total real contact area"
SUMMITS = "contact area of summits over total real contact area"
QUANTITIES = _by_name(
    Quantity("total_contact_area", "total real contact area over apparent area", "A_t*", "5"),
    Quantity("particle_contact_area_ratio", PARTICLES, "A_sa,t*", "10", largest=1.0),
    Quantity("surface_contact_area_ratio", SUMMITS, "A_ss,t*", "10", largest=1.0),
    Quantity(
        "solid_load_fraction", "fraction of the load carried by the solids", "L_s", "9", largest=1.0
    ),
    Quantity(
        "fluid_load_fraction", "fraction of the load carried by the fluid", "L_f", "9", largest=1.0
    ),
    Quantity("separation", "mean separation of the two surfaces", "d", "4", "m"),
    Quantity("film_thickness", "central film thickness over ball radius", "H_c", "7"),
)
NORMAL_LOAD = Quantity("normal_load", "normal load", "F_t", "1", "N")
ERROR_BOUND = Quantity(
    "error_bound",
    "bound on the relative error of every variable",
    comment="of numbers above 2.2e-308, below which float64 loses digits",
)
SEPARATION_COUNT = Quantity(
    "separation_count",
    "at how many separations the forces balance",
    equation="1-2",
    comment=f"0: without values; {FILL_FLAG}: not shown",
)
FLAGS = _by_name(
    Quantity("lubrication_regime", "lubrication regime", "L_s", "section 3.1"),
    Quantity("contact_mode", "contact mode", "A_sa,t*", "section 3.2"),
    Quantity(
        STATUS,
        "status of the solution",
        equation="1-8",
        comment="; ".join(f"{status}: {meaning}" for status, meaning in STATUS_MEANINGS.items()),
    ),
)
# numbers and flags in every dataset of a figure, and all possible variables of a dataset
NUMBERS = QUANTITIES | _by_name(ERROR_BOUND)
CONTRACT = (*NUMBERS, *FLAGS)
VARIABLES = NUMBERS | FLAGS | _by_name(SEPARATION_COUNT)


def curves_of(dataset: PlainDataset) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """The curves of a dataset, with at least one point with a status: their conditions, SI, in the
    order of ``Condition``, shape (4, curves); and their index in a variable after its load axis,
    ``values[:, index]``."""
    status = dataset[STATUS].values
    # nan where xarray has masked points, which it converts to floats
    shown = (np.isfinite(status) & (status != FILL_FLAG)).any(axis=0)
    axes = [dataset[name].values for name in Condition._fields]
    conditions = np.stack([grid[shown] for grid in np.meshgrid(*axes, indexing="ij")])
    return conditions, shown


def spread(values: Iterable[float]) -> tuple[float, float] | None:
    """The range of nine in ten of ``values``, those of an ensemble; None if there are none."""
    known = [value for value in values if np.isfinite(value)]
    if not known:
        return None
    low, high = np.quantile(known, ENDS)
    return float(low), float(high)
