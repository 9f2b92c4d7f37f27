"""Text of numbers and conditions in figures, and the variables of their axes; nothing is drawn
here.
"""

from collections.abc import Sequence

from thirdbody.core.regimes import BOUNDARY_LIMIT, FULL_FILM_LIMIT, PARTICLE_LIMIT, SURFACE_LIMIT
from thirdbody.curves import Condition
from thirdbody.symbols import mathtext, power_text, unicode
from thirdbody.variables import CONDITION_AXES, CONDITIONS, DERIVED, NORMAL_LOAD, QUANTITIES

ABSENT = {"viscosity": "dry", "particle_diameter": "two-body", "particle_density": "two-body"}
NOTED = ("viscosity", "roughness", "particle_diameter", "particle_density")  # in this order


def unit_text(parameter: str) -> str:
    """Engineering unit of one of the four conditions."""
    return unicode(CONDITIONS[parameter].alias_unit)


def parameter_title(parameter: str) -> str:
    """Title of a legend of curves that differ in a condition or the ``diameter_ratio``."""
    if parameter == "diameter_ratio":
        return f"{DERIVED[parameter].title} {unicode(DERIVED[parameter].symbol)}"
    condition = CONDITIONS[parameter]
    return f"{condition.title} {unicode(condition.symbol)} ({unit_text(parameter)})"


def value_text(parameter: str, value: float) -> str:
    """``value`` [SI] of ``parameter`` in the unit of its title."""
    if parameter in ("particle_density", "load") and value:
        return power_text(value)
    if parameter not in CONDITIONS:
        return str(float(f"{value:.10g}"))  # 1.0 beside 1.1
    return f"{CONDITIONS[parameter].from_si(value):.10g}"


def note(parameter: str, value: float) -> str:
    """``value`` [SI] of a condition with its symbol and unit: σ = 300 nm, dry, two-body."""
    if value == 0.0 and parameter in ABSENT:
        return ABSENT[parameter]
    unit = "" if parameter == "load" else f" {unit_text(parameter)}"
    return f"{unicode(CONDITIONS[parameter].symbol)} = {value_text(parameter, value)}{unit}"


def shared_notes(conditions: Sequence[Condition]) -> list[str]:
    """The notes common to all ``conditions`` with particles."""
    rows = [
        [note(name, getattr(one, name)) for name in NOTED]
        for one in conditions
        if not one.is_two_body
    ]
    return [column[0] for column in zip(*rows, strict=True) if len(set(column)) == 1]


def label(condition: Condition) -> str:
    """All four conditions, the name of a curve in the file of the data drawn."""
    return "; ".join(
        f"{axis.symbol} = {axis.from_si(value):.10g} {axis.alias_unit}"
        for axis, value in zip(CONDITION_AXES, condition, strict=True)
    )


# limits between contact modes or lubrication regimes, and their names from the lowest on
ZONES = {
    "contact_mode": ((SURFACE_LIMIT, PARTICLE_LIMIT), ("s-s", "hybrid", "p-s")),
    "lubrication_regime": ((FULL_FILM_LIMIT, BOUNDARY_LIMIT), ("F.L.", "M.L.", "B.L.")),
}
SCALES = CONDITIONS | QUANTITIES | {NORMAL_LOAD.name: NORMAL_LOAD} | DERIVED


def panel_title(x: str, y: str) -> str:
    """Title of a panel of ``y`` over ``x``."""
    over = (
        ""
        if x in ("load", "normal_load", "diameter_ratio")
        else f" over {unicode(SCALES[x].symbol)}"
    )
    return SCALES[y].title + over


def axis_label(name: str) -> str:
    """Label of an axis: words, symbol and unit, with mathematics of matplotlib."""
    variable = SCALES[name]
    unit = variable.shown_unit and f"({unicode(variable.shown_unit)})"
    symbol = mathtext(variable.symbol, is_symbol=True)
    return " ".join(filter(None, (variable.axis_words, symbol, unit)))


def quantity(name: str) -> str:
    """The title of a scale within a sentence."""
    title = SCALES[name].title
    return title[0].lower() + title[1:]


def axis_text(name: str, value: float) -> str:
    """``value`` [SI] with the unit of its axis and two digits: 89 %, 1.8×10⁻⁴."""
    variable = SCALES[name]
    rounded = float(f"{value / variable.scale:.2g}")
    if variable.zones and rounded < 1e-3:  # none of a fraction
        rounded = 0.0
    is_power = 0.0 < rounded < 1e-3 or rounded >= 1e3
    number = power_text(rounded) if is_power else f"{rounded:g}"
    if name == "film_thickness":
        return f"{number}×{power_text(variable.scale)}"
    return f"{number} {unicode(variable.shown_unit)}".rstrip()
