"""Text of numbers and conditions in figures, and the axis of each quantity: title, label, unit,
scale, and limits of regimes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from matplotlib import rcParams
from matplotlib.axes import Axes
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter, NullLocator

from thirdbody.data.conditions import AXES, CONDITION_AXES, Condition
from thirdbody.model.regimes import BOUNDARY_LIMIT, FULL_FILM_LIMIT, PARTICLE_LIMIT, SURFACE_LIMIT

# of labels in fractions of the axes: fixed, because computing them from tick labels is slow
LABEL_PLACES = {"x": (0.5, -0.11), "y": (-0.18, 0.5)}
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
NOTED = ("viscosity", "roughness", "particle_diameter", "particle_density")  # in this order


def power_text(value: float) -> str:
    """``value`` as a power of ten, with at most four digits: 5×10¹⁰, 10¹¹."""
    mantissa, exponent = f"{value:.3e}".split("e")
    power = "10" + str(int(exponent)).translate(SUPERSCRIPTS)
    return power if float(mantissa) == 1.0 else f"{float(mantissa):g}×{power}"


def unit_text(parameter: str) -> str:
    """Engineering unit of one of the four conditions."""
    return AXES[parameter].unit.translate(SUPERSCRIPTS)


def parameter_title(parameter: str) -> str:
    """Title of a legend of curves that differ in a condition or the ``diameter_ratio``."""
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
        f"{axis.symbol} = {axis.from_si(value):.10g} {axis.unit}"
        for axis, value in zip(CONDITION_AXES, condition, strict=True)
    )


POWERS = FuncFormatter(lambda value, _: power_text(value))


class Scale(NamedTuple):
    """The axis of one quantity: title of its panels, label, and the unit of the ticks in SI; for a fraction
    also the ``limits`` between regimes or contact modes, and the names of these ``zones``."""

    title: str
    label: str
    logarithmic: bool = False
    unit: float = 1.0
    limits: tuple[float, ...] = ()
    zones: tuple[str, ...] = ()


MODES = {"limits": (SURFACE_LIMIT, PARTICLE_LIMIT), "zones": ("s-s", "hybrid", "p-s")}
REGIMES = {"limits": (FULL_FILM_LIMIT, BOUNDARY_LIMIT), "zones": ("F.L.", "M.L.", "B.L.")}
SCALES = {
    "load": Scale("Dimensionless normal load", "$F_t^*$", logarithmic=True),
    "normal_load": Scale("Normal load", "Normal load $F_t$ (N)", logarithmic=True),
    "total_contact_area": Scale("Real contact area", "$A_t^*$", logarithmic=True),
    "particle_contact_area_ratio": Scale(
        "Contact area ratio of particles", "$A_{sa,t}^*$", **MODES
    ),
    "solid_load_fraction": Scale("Load percentage of solid", "$L_s$ (%)", unit=0.01, **REGIMES),
    "film_thickness": Scale("Film thickness", "$H_c$ ($10^{-4}$)", unit=1e-4),
    "total_contact_area_over_two_body": Scale(
        "Area over that of dry two-body contact", "$A_t^*$ over dry two-body"
    ),
    "largest_particle_diameter": Scale(
        "Largest particle out of the p-s mode", "$x_a$ (nm)", logarithmic=True, unit=1e-9
    ),
    "least_viscosity": Scale(
        "Least viscosity out of boundary lubrication", "$ν$ (cSt)", logarithmic=True, unit=1e-6
    ),
    "diameter_ratio": Scale("Ratio of particle diameter to roughness", r"$x_a/\sigma$"),
    "turning_point_ratio": Scale(
        "Where turning points occur", "$A_{sa,t}^*$ at the turning point", **MODES
    ),
} | {
    axis.name: Scale(axis.name.replace("_", " "), parameter_title(axis.name), unit=axis.scale)
    for axis in CONDITION_AXES
}


def set_scales(axes: Axes, x: str, y: str, newtons_per_load: float | None = None) -> None:
    """Set scales, ticks, labels and limits of axes after all data have been drawn.

    ``x`` and ``y`` are quantities of ``SCALES``.  With ``newtons_per_load``, F_t/F_t* [N], a load
    axis shows newtons at the upper edge.
    """
    axes.margins(x=0.02, y=0.04)
    limits = axes.dataLim
    for axis, name, (low, high) in (
        (axes.xaxis, x, limits.intervalx),
        (axes.yaxis, y, limits.intervaly),
    ):
        scale = SCALES[name]
        axis.set_label_text(scale.label)
        axis.set_label_coords(*LABEL_PLACES[axis.axis_name])
        spreads = 0.0 < 3.0 * low < high if scale.logarithmic else 0.0 < 10.0 * low < high
        logarithmic = spreads and (scale.logarithmic or axis is axes.xaxis)
        if logarithmic:
            axes.set(**{f"{axis.axis_name}scale": "log"})
            axis.set_major_formatter(POWERS)
            axis.set_minor_locator(LogLocator(subs=(2.0, 5.0)))
            axis.set_minor_formatter(POWERS if high < 20.0 * low else NullFormatter())
        if scale.unit != 1.0:
            axis.set_major_formatter(lambda value, _, unit=scale.unit: f"{value / unit:g}")
            if logarithmic:
                axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
                axis.set_minor_locator(NullLocator())
    if SCALES[y].limits:
        highest = axes.dataLim.y1
        top = highest if 0.0 < highest < 0.5 else 1.0
        axes.set_ylim(-0.08 * top, 1.08 * top)
        _draw_limits(axes, SCALES[y])
    if x == "load" and newtons_per_load is not None:
        _draw_newtons(axes, newtons_per_load)


def _draw_newtons(axes, newtons_per_load):
    """Ticks in newtons at the upper edge; a secondary axis would take as long to draw as the first one."""
    ends = np.array(axes.get_xlim()) * newtons_per_load
    locator = LogLocator() if axes.get_xscale() == "log" else MaxNLocator(5)
    newtons = [tick for tick in locator.tick_values(*ends) if ends[0] <= tick <= ends[1]]
    loads = np.array(newtons) / newtons_per_load
    place = axes.get_xaxis_transform()
    axes.vlines(loads, 0.98, 1.0, color=rcParams["axes.edgecolor"], linewidth=0.6, transform=place)
    style = {"ha": "center", "fontsize": rcParams["xtick.labelsize"], "color": "black"}
    for load, tick in zip(loads, newtons, strict=True):
        axes.text(load, 1.03, f"{tick:g} N", transform=place, **style)


def _draw_limits(axes, scale):
    """Thin lines at the limits of regimes and modes, with their names at the right edge."""
    low, high = axes.get_ylim()
    style = {"transform": axes.get_yaxis_transform(), "va": "center", "fontsize": "small"}
    right = 1.03  # beside a mark at the last load
    for limit in scale.limits:
        if low < limit < high:
            axes.axhline(limit, color="0.55", linewidth=0.5, linestyle=":", zorder=1)
            axes.text(right, limit, f"{limit / scale.unit:g}", **style)
    edges = [low, *(min(limit, high) for limit in scale.limits), high]
    for zone, bottom, top in zip(scale.zones, edges, edges[1:], strict=False):
        if bottom < top:
            rotation = 270 if len(zone) > 4 else 0
            axes.text(right, 0.5 * (bottom + top), zone, rotation=rotation, **style)
