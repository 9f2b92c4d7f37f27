"""How figures write numbers and conditions: titles of keys, notes on panels, labels of curves."""

from __future__ import annotations

from collections.abc import Sequence

from thirdbody.data.conditions import AXES, CONDITION_AXES, Condition

SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
NOTED = ("viscosity", "roughness", "particle_diameter", "particle_density")  # in this order


def power_text(value: float) -> str:
    """``value`` as a power of ten, four digits at most: 5×10¹⁰, 10¹¹."""
    mantissa, exponent = f"{value:.3e}".split("e")
    power = "10" + str(int(exponent)).translate(SUPERSCRIPTS)
    return power if float(mantissa) == 1.0 else f"{float(mantissa):g}×{power}"


def unit_text(parameter: str) -> str:
    """Engineering unit of one of the four conditions."""
    return AXES[parameter].unit.translate(SUPERSCRIPTS)


def parameter_title(parameter: str) -> str:
    """Title of a key whose curves differ in ``parameter``: a condition, or the ``diameter_ratio``."""
    if parameter == "diameter_ratio":
        return "Diameter over roughness xₐ/σ"
    name = parameter.replace("_", " ").capitalize()
    return f"{name} {AXES[parameter].sign} ({unit_text(parameter)})"


def value_text(parameter: str, value: float) -> str:
    """``value`` [SI] of ``parameter`` in the unit of its title."""
    if parameter in ("particle_density", "load") and value:
        return power_text(value)
    number = AXES[parameter].from_si(value) if parameter in AXES else value
    return f"{number:.10g}"


def note(parameter: str, value: float) -> str:
    """``value`` [SI] of a condition with its symbol and unit: σ = 300 nm, dry."""
    if parameter == "viscosity" and value == 0.0:
        return "dry"
    unit = "" if parameter == "load" else f" {unit_text(parameter)}"
    return f"{AXES[parameter].sign} = {value_text(parameter, value)}{unit}"


def shared_notes(conditions: Sequence[Condition]) -> list[str]:
    """The notes that all of ``conditions`` with particles have in common."""
    rows = [
        [note(name, getattr(one, name)) for name in NOTED]
        for one in conditions
        if not one.is_two_body
    ]
    return [column[0] for column in zip(*rows, strict=True) if len(set(column)) == 1]


def label(condition: Condition) -> str:
    """All four conditions, as the file of the drawn data names a curve."""
    return "; ".join(
        f"{axis.symbol} = {axis.from_si(value):.10g} {axis.unit}"
        for axis, value in zip(CONDITION_AXES, condition, strict=True)
    )
