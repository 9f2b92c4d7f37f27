"""The variables of the datasets: name, symbol, unit, equation and meaning of each.

Datasets, tables, figures, answers and the nomenclature page take all of it from here; the conditions,
which are given and not computed, stand in ``thirdbody.data.conditions``.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from thirdbody.data.conditions import Condition
from thirdbody.model.regimes import FLAG_MEANINGS

if TYPE_CHECKING:
    from thirdbody.data.plain import PlainDataset

# what each status says of a point
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
STATUS = "solution_status"  # the flag that says how to take all other variables
# What stands where a figure shows no point: the fill values of NetCDF.  Of a flag it is a value with a
# meaning, not_shown: xarray would turn integers with missing values into floats.
FILL_FLOAT = 9.969209968386869e36
FILL_FLAG = np.int8(-127)


@dataclass(frozen=True)
class Quantity:
    """One variable: how data files describe it.

    Attributes
    ----------
    name : str
        Variable of datasets and attribute of ``thirdbody.Solution``.
    symbol : str
        Symbol of the paper in plain letters, ``none`` where it has none.
    units : str
        SI unit, spelt as UDUNITS reads it.
    long_name : str
        What it is.
    equation : str
        Equation or section of the paper that defines it, ``none`` if none does.
    largest : float
        It is between 0 and this.
    meanings : tuple of str
        Of a flag, what its values 0, 1, ... stand for; empty for a number.
    comment : str
        What else there is to say of it, or nothing.
    """

    name: str
    symbol: str
    units: str
    long_name: str
    equation: str
    largest: float = math.inf
    meanings: tuple[str, ...] = ()
    comment: str = ""


NORMAL_LOAD = Quantity("normal_load", "F_t", "N", "normal load", "1")
ERROR_BOUND = Quantity(
    "error_bound",
    "none",
    "1",
    "bound on the relative error of every variable",
    "none",
    comment="of numbers above 2.2e-308, below which float64 loses digits",
)
SEPARATION_COUNT = Quantity(
    "separation_count",
    "none",
    "1",
    "at how many separations the forces balance",
    "1-2",
    comment=f"0: without values; {FILL_FLAG}: not shown",
)


def _by_name(*quantities: Quantity) -> dict[str, Quantity]:
    return {quantity.name: quantity for quantity in quantities}


def _flag(name: str, symbol: str, long_name: str, equation: str, comment: str = "") -> Quantity:
    return Quantity(name, symbol, "1", long_name, equation, math.inf, FLAG_MEANINGS[name], comment)


QUANTITIES = _by_name(
    Quantity("total_contact_area", "A_t*", "1", "total real contact area over apparent area", "5"),
    Quantity(
        "particle_contact_area_ratio",
        "A_sa,t*",
        "1",
        "contact area of particles over total real contact area",
        "10",
        largest=1.0,
    ),
    Quantity(
        "surface_contact_area_ratio",
        "A_ss,t*",
        "1",
        "contact area of summits over total real contact area",
        "10",
        largest=1.0,
    ),
    Quantity(
        "solid_load_fraction", "L_s", "1", "fraction of the load carried by the solids", "9", 1.0
    ),
    Quantity(
        "fluid_load_fraction", "L_f", "1", "fraction of the load carried by the fluid", "9", 1.0
    ),
    Quantity("separation", "d", "m", "mean separation of the two surfaces", "4"),
    Quantity("film_thickness", "H_c", "1", "central film thickness over ball radius", "7"),
)
FLAGS = _by_name(
    _flag("lubrication_regime", "L_s", "lubrication regime", "section 3.1"),
    _flag("contact_mode", "A_sa,t*", "contact mode", "section 3.2"),
    _flag(
        STATUS,
        "none",
        "status of the solution",
        "1-8",
        "; ".join(f"{status}: {meaning}" for status, meaning in STATUS_MEANINGS.items()),
    ),
)
# numbers and flags of every dataset of a figure, and all that a dataset can hold
NUMBERS = QUANTITIES | _by_name(ERROR_BOUND)
CONTRACT = (*NUMBERS, *FLAGS)
VARIABLES = NUMBERS | FLAGS | _by_name(SEPARATION_COUNT)


def curves_of(dataset: PlainDataset) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """The curves that a dataset shows, any point with a status: what is held along each, SI, in the order
    of ``Condition``, shape (4, curves); and their index in a variable behind its axis of loads,
    ``values[:, index]``."""
    status = dataset[STATUS].values
    # nan where xarray has masked points, of which it makes floats
    shown = (np.isfinite(status) & (status != FILL_FLAG)).any(axis=0)
    axes = [dataset[name].values for name in Condition._fields]
    conditions = np.stack([grid[shown] for grid in np.meshgrid(*axes, indexing="ij")])
    return conditions, shown
