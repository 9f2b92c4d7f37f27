"""The table of all conditions and results: name, symbol, unit, equation, and texts for figures.

Datasets, tables, figures, answers, the command and the page take names from this table.  Symbols
are those of the paper.  Units are SI, in the spelling of UDUNITS.
"""

import inspect
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.core import names
from thirdbody.core.regimes import FLAG_MEANINGS


@dataclass(frozen=True, kw_only=True)
class Variable:
    """A condition or a result: a row of the table.

    Attributes
    ----------
    name : str
        Name in ``Solution`` and in datasets.
    symbol : str
        Symbol in ASCII.
    unit : str
        SI unit.
    label : str
        Description in words: the ``long_name`` in datasets.
    equation : str
        Equation or section that defines the variable.
    comment : str
        Explanation of the values.
    title : str
        Heading in figures and on the page.
    axis_words : str
        Words before the symbol along an axis in figures.
    shown_unit : str
        Unit in figures and on the page.
    scale : float
        The ``shown_unit`` in SI.
    is_logarithmic : bool
        Whether the axis of the variable in figures is logarithmic.
    zones : str
        Flag that divides the values of a fraction into zones.
    """

    name: str
    symbol: str = "none"
    unit: str = "1"
    label: str = ""
    equation: str = "none"
    comment: str = ""
    title: str = ""
    axis_words: str = ""
    shown_unit: str = ""
    scale: float = 1.0
    is_logarithmic: bool = False
    zones: str = ""

    @property
    def meanings(self) -> tuple[str, ...]:
        """Names for the values 0, 1, ... of a flag; empty for a number."""
        return FLAG_MEANINGS.get(self.name, ())

    def to_si(self, values: ArrayLike) -> NDArray | float:
        """``values`` [``shown_unit``] in SI; a single number as a float.

        Results are the floats nearest to decimal numbers, 300.1 nm is 3.001e-07 m, and where there
        are more than nine decimals, to the quotient of floats.
        """
        numbers, per_unit = np.asarray(values, float), round(1.0 / self.scale)
        with np.errstate(over="ignore"):
            billionths = np.rint(1e9 * numbers)
        is_decimal = (billionths / 1e9 == numbers) & (np.abs(billionths) < 2.0**53)
        si = np.where(is_decimal, billionths / (1e9 * per_unit), numbers / per_unit)
        return si if si.ndim else si.item()

    def from_si(self, values: ArrayLike) -> NDArray:
        """``values`` [SI] in ``shown_unit``; the last digit may be wrong."""
        return np.divide(values, self.scale)


@dataclass(frozen=True, kw_only=True)
class Axis(Variable):
    """A condition, an axis of datasets.

    Attributes
    ----------
    alias : str
        Name of the argument in engineering units.
    alias_unit : str
        Unit of the alias.  It is ``scale`` in SI, except for ``load_N``: the F_t* of a newton
        depends on the inputs.
    column : str
        Name of the column in tables of the workflow.
    paper : pair of float
        Ends in the paper (Table 2) [``alias_unit``].  It has no speed of its own: U contains it.
    searched : pair of float
        Ends of searches [``alias_unit``]: the ends in the paper and a decade beyond.
    usual : pair of float
        Range of usual values [SI].  It is far wider than in the paper, but a number in another unit
        lies outside.
    """

    alias: str
    alias_unit: str
    column: str
    paper: tuple[float, float]
    searched: tuple[float, float]
    usual: tuple[float, float]

    @property
    def words(self) -> str:
        """The condition in words, as ``particle size``."""
        return (self.axis_words or self.name).lower()

    def values(self, numbers: Iterable[float]) -> NDArray[np.float64]:
        """``numbers`` [``alias_unit``] in SI, shape (n,), sorted and without duplicates."""
        return np.unique(self.to_si(decimal([*numbers])))


def decimal(values: ArrayLike, digits: int = 15) -> NDArray:
    """``values`` rounded to ``digits`` significant digits: without the noise of a conversion."""
    return np.vectorize(lambda value: float(f"{value:.{digits}g}"), otypes=[float])(values)


AnyVariable = TypeVar("AnyVariable", bound=Variable)


def _by_name(*variables: AnyVariable) -> dict[str, AnyVariable]:
    return {variable.name: variable for variable in variables}


AXES = _by_name(
    Axis(
        name="load",
        symbol="F_t*",
        label="dimensionless mean normal load",
        title="Dimensionless normal load",
        is_logarithmic=True,
        alias="load_N",
        alias_unit="N",
        column="load",
        paper=(0.04, 80.0),
        searched=(0.01, 1000.0),
        usual=(1e-13, 2e-2),
    ),
    Axis(
        name="viscosity",
        symbol="nu",
        unit="m2 s-1",
        label="kinematic viscosity of the lubricant, 0 when dry",
        title="Viscosity",
        axis_words="Viscosity",
        shown_unit="cSt",
        scale=1e-6,
        alias="viscosity_cSt",
        alias_unit="cSt",
        column="viscosity_m2_per_s",
        paper=(0.0, 150.0),
        searched=(1.0, 1000.0),
        usual=(3e-7, 1e-2),
    ),
    Axis(
        name="particle_diameter",
        symbol="x_a",
        unit="m",
        label="particle size, a label of the size distribution, 0 without particles",
        title="Particle size",
        axis_words="Particle size",
        shown_unit="nm",
        scale=1e-9,
        alias="particle_diameter_nm",
        alias_unit="nm",
        column="particle_diameter_m",
        paper=(0.0, 1000.0),
        searched=(10.0, 10_000.0),
        usual=(1e-9, 1e-3),
    ),
    Axis(
        name="roughness",
        symbol="sigma",
        unit="m",
        label="equivalent root mean square surface roughness",
        title="Roughness",
        axis_words="Roughness",
        shown_unit="nm",
        scale=1e-9,
        alias="roughness_nm",
        alias_unit="nm",
        column="roughness_m",
        paper=(100.0, 500.0),
        searched=(20.0, 2000.0),
        usual=(1e-9, 1e-3),
    ),
    Axis(
        name="particle_density",
        symbol="eta_a",
        unit="m-2",
        label="number of particles per unit area",
        title="Particle density",
        axis_words="Particle density",
        shown_unit="m-2",
        alias="particle_density_per_m2",
        alias_unit="m-2",
        column="particle_density_per_m2",
        paper=(1e10, 5e12),
        searched=(1e8, 1e14),
        usual=(1e6, 1e16),
    ),
)
# a sixth condition that is no axis: U in Eq. 8 contains only the product of viscosity and speed
SPEED = Axis(
    name="speed",
    symbol="u",
    unit="m s-1",
    label="entrainment speed, the mean of the speeds of both surfaces",
    title="Speed",
    axis_words="Entrainment speed",
    shown_unit="m/s",
    is_logarithmic=True,
    alias="speed_m_per_s",
    alias_unit="m/s",
    column="speed_m_per_s",
    paper=(0.0, np.inf),
    searched=(0.001, 100.0),
    usual=(1e-6, 200.0),
)
CONDITIONS = AXES | {SPEED.name: SPEED}
DIMENSIONS = tuple(AXES)  # of every dataset, in this order
CONDITION_AXES = tuple(AXES.values())[1:]  # all but the load

QUANTITIES = _by_name(
    Variable(
        name=names.TOTAL_CONTACT_AREA,
        symbol="A_t*",
        label="total real contact area over apparent area",
        equation="5",
        title="Real contact area",
        is_logarithmic=True,
    ),
    Variable(
        name=names.PARTICLE_CONTACT_AREA_RATIO,
        symbol="A_sa,t*",
        label="contact area of particles over total real contact area",
        equation="10",
        title="Contact area ratio of particles",
        zones=names.CONTACT_MODE,
    ),
    Variable(
        name=names.SURFACE_CONTACT_AREA_RATIO,
        symbol="A_ss,t*",
        label="contact area of summits over total real contact area",
        equation="10",
        title="Contact area ratio of surfaces",
    ),
    Variable(
        name=names.SOLID_LOAD_FRACTION,
        symbol="L_s",
        label="fraction of the load carried by the solids",
        equation="9",
        title="Load percentage of solid",
        shown_unit="%",
        scale=0.01,
        zones=names.LUBRICATION_REGIME,
    ),
    Variable(
        name=names.FLUID_LOAD_FRACTION,
        symbol="L_f",
        label="fraction of the load carried by the fluid",
        equation="9",
        title="Load percentage of fluid",
        shown_unit="%",
        scale=0.01,
    ),
    Variable(
        name=names.SEPARATION,
        symbol="d",
        unit="m",
        label="mean separation of the two surfaces",
        equation="4",
        title="Separation",
        shown_unit="nm",
        scale=1e-9,
    ),
    Variable(
        name=names.FILM_THICKNESS,
        symbol="H_c",
        label="central film thickness over ball radius",
        comment="of the gap, which solids hold open too; lambda is of the film alone: "
        "that of smooth bodies under the whole load, over sigma",
        equation="7",
        title="Film thickness",
        shown_unit="1e-4",
        scale=1e-4,
    ),
)

STATUS = names.SOLUTION_STATUS  # the flag that qualifies all other variables
STATUS_MEANINGS = {
    "converged": "the equations hold to the error asked for",
    "outside_film_formula": "the film carries more than a thousandth of the load "
    "where Eq. 7 has no meaning: it would grow with falling viscosity, "
    "is thicker than a hundredth of the ball's radius, "
    "or presses harder on the interface than the softer surface is",
    "coverage_exceeded": "particles would cover the whole interface in Eq. 4",
    "not_converged": "float64 does not promise the error asked for, "
    "and error_bound says what the values are good for",
    "area_exceeded": "the real contact area would be larger than the apparent one, A_t* > 1",
    "load_exceeded": "the load is more than what is carried at any separation of zero or more",
}
FLAGS = _by_name(
    Variable(
        name=names.LUBRICATION_REGIME,
        symbol="L_s",
        label="lubrication regime",
        equation="section 3.1",
    ),
    Variable(
        name=names.CONTACT_MODE,
        symbol="A_sa,t*",
        label="contact mode",
        equation="section 3.2",
    ),
    Variable(
        name=STATUS,
        label="status of the solution",
        equation="1-8",
        comment="; ".join(f"{status}: {meaning}" for status, meaning in STATUS_MEANINGS.items()),
    ),
)
NORMAL_LOAD = Variable(
    name="normal_load",
    symbol="F_t",
    unit="N",
    label="normal load",
    equation="1",
    title="Normal load",
    axis_words="Normal load",
    shown_unit="N",
    is_logarithmic=True,
)
ERROR_BOUND = Variable(
    name=names.ERROR_BOUND,
    label="bound on the relative error of every variable",
    comment="of numbers above 2.2e-308, below which float64 loses digits",
)
NUMBERS = QUANTITIES | {ERROR_BOUND.name: ERROR_BOUND}
VARIABLES = NUMBERS | FLAGS  # of datasets

# variables that figures and the page derive from the others
RELATIVE_AREA = "total_contact_area_over_two_body"
DERIVED = _by_name(
    Variable(
        name=RELATIVE_AREA,
        symbol="A_t* over dry two-body",
        label="total real contact area over that of dry two-body contact on the same surface",
        title="Area over that of dry two-body contact",
    ),
    Variable(
        name="diameter_ratio",
        symbol="x_a/sigma",
        title="Particle size over roughness",
    ),
    Variable(
        name="turning_point_ratio",
        symbol="A_sa,t* at the turning point",
        title="Where turning points occur",
        zones=names.CONTACT_MODE,
    ),
)

Documented = TypeVar("Documented", bound=Callable)


def with_table(documented: Documented) -> Documented:
    """Decorate a function or class whose docstring contains ``{conditions}`` or ``{variables}``.

    Rows of this table replace these words.  The signature of a function that takes ``**conditions``
    shows the names of the conditions.
    """
    conditions, variables = [], []
    for axis in CONDITIONS.values():
        alias = "" if axis.alias_unit == axis.unit else f"; ``{axis.alias}`` in {axis.alias_unit}"
        conditions += [
            f"{axis.name}, {axis.alias} : array_like",
            f"    The {axis.label}: {axis.symbol} [{axis.unit}]{alias}.",
            f"    Usual: {axis.usual[0]:g} to {axis.usual[1]:g} [{axis.unit}].",
        ]
    for variable in VARIABLES.values():
        symbol = f": {variable.symbol} [{variable.unit}]" if variable.name in QUANTITIES else ""
        variables += [f"{variable.name} : array", f"    The {variable.label}{symbol}."]
    for name, lines in (("{conditions}", conditions), ("{variables}", variables)):
        docstring = inspect.cleandoc(documented.__doc__ or "")  # Python before 3.13 keeps indents
        documented.__doc__ = docstring.replace(name, "\n".join(lines))
    if inspect.isfunction(documented):
        signature = inspect.signature(documented)
        *others, _ = signature.parameters.values()
        given = [
            inspect.Parameter(
                name, inspect.Parameter.KEYWORD_ONLY, default=None, annotation="ArrayLike | None"
            )
            for axis in CONDITIONS.values()
            for name in (axis.name, axis.alias)
        ]
        vars(documented)["__signature__"] = signature.replace(parameters=[*given, *others])
    return documented
