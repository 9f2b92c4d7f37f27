"""Text of numbers and conditions in figures, and the axis of each quantity, from ``scales.toml``."""

import re
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import LogLocator, NullLocator

from thirdbody.data.conditions import AXES, CONDITION_AXES, Condition
from thirdbody.model.regimes import BOUNDARY_LIMIT, FULL_FILM_LIMIT, PARTICLE_LIMIT, SURFACE_LIMIT
from thirdbody.toml_tables import toml_beside

SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
ABOVE_NEWTONS = 16.0  # points between the axes and their title
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


class Scale(NamedTuple):
    """The axis of one quantity, a row of ``scales.toml``: ``unit`` is that of the ticks in SI, ``zones``
    the key of ``ZONES`` into which a fraction is divided."""

    title: str
    label: str
    logarithmic: bool = False
    unit: float = 1.0
    zones: str = ""


# limits between contact modes or lubrication regimes, and their names from the lowest on
ZONES = {
    "modes": ((SURFACE_LIMIT, PARTICLE_LIMIT), ("s-s", "hybrid", "p-s")),
    "regimes": ((FULL_FILM_LIMIT, BOUNDARY_LIMIT), ("F.L.", "M.L.", "B.L.")),
}
ZONE = "0.955"  # of the middle one
ROWS = toml_beside(__file__)
SCALES = {name: Scale(**row) for name, row in ROWS.items()} | {
    axis.name: Scale(axis.name.replace("_", " "), parameter_title(axis.name), unit=axis.scale)
    for axis in CONDITION_AXES
}


def panel_title(x: str, y: str) -> str:
    """Title of a panel of ``y`` over ``x``."""
    symbol = SCALES[x].label.partition(" ")[0]
    over = "" if x in ("load", "normal_load", "diameter_ratio") else f" over {symbol}"
    return SCALES[y].title + over


def quantity(name: str) -> str:
    """The title of a scale within a sentence."""
    title = SCALES[name].title
    return title[0].lower() + title[1:]


def axis_text(name: str, value: float) -> str:
    """``value`` [SI] with the unit of its axis and two digits: 89 %, 1.8×10⁻⁴."""
    scale = SCALES[name]
    number = f"{value / scale.unit:.2g}"
    if name == "film_thickness":
        return f"{number}×{power_text(scale.unit)}"
    unit = re.search(r"\(([^$]+)\)$", scale.label)
    return f"{number} {unit[1]}" if unit else number


def set_scales(
    axes: Axes, x: str, y: str, newtons_per_load: float | None = None, least: float = 0.0
) -> None:
    """Set scales, ticks, labels and limits of axes after all data have been drawn; with
    ``newtons_per_load``, F_t/F_t* [N], a load axis shows newtons at the upper edge; a fraction is
    logarithmic from ``least`` on, if it is given."""
    axes.margins(x=0.02, y=0.04)
    limits = axes.dataLim
    for axis, name, (low, high) in (
        (axes.xaxis, x, limits.intervalx),
        (axes.yaxis, y, limits.intervaly),
    ):
        scale = SCALES[name]
        axis.set_label_text(scale.label)
        spread = 3.0 if scale.logarithmic else 10.0
        logarithmic = (scale.logarithmic or axis is axes.xaxis) and 0.0 < spread * low < high
        if logarithmic:
            axes.set(**{f"{axis.axis_name}scale": "log"})
            axis.set_major_formatter(lambda value, _: power_text(value))
        if scale.unit != 1.0:
            axis.set_major_formatter(_in_unit(axis, scale.unit))
            if logarithmic:
                axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
                axis.set_minor_locator(NullLocator())
    if SCALES[y].zones:
        over_sizes = x == "diameter_ratio"  # where tolerances are shaded
        top = limits.y1 if 0.0 < limits.y1 < 0.5 and not over_sizes else 1.0
        axes.set_ylim(-0.08 * top, 1.08 * top)
        if least:
            axes.set(yscale="log", ylim=(least, 1.3))
        _draw_zones(axes, SCALES[y], shaded=not over_sizes)
    if x == "load" and newtons_per_load is not None:
        ends = lambda load: load * newtons_per_load, lambda newtons: newtons / newtons_per_load
        upper = axes.secondary_xaxis("top", functions=ends)
        upper.xaxis.set_major_formatter("{x:g} N")
        upper.xaxis.set_minor_locator(NullLocator())
        upper.set_in_layout(False)  # the title leaves room for it
        axes.set_title(axes.get_title(loc="left"), loc="left", y=1.0, pad=ABOVE_NEWTONS)


def _in_unit(axis, unit):
    """Text of a tick in a unit, with as many decimals as the others."""

    def text(value, _):
        ticks = [f"{tick:.6g}" for tick in axis.get_majorticklocs() / unit]
        decimals = 0 if axis.get_scale() == "log" else max(len(t.partition(".")[2]) for t in ticks)
        return f"{value / unit:.{decimals}f}" if decimals else f"{value / unit:g}"

    return text


def _draw_zones(axes, scale, shaded):
    """The middle regime or mode shaded behind the curves, and the names of all at the right edge."""
    low, high = axes.get_ylim()
    limits, names = ZONES[scale.zones]
    if shaded:
        axes.axhspan(limits[0], min(limits[1], high), color=ZONE, linewidth=0.0, zorder=0.5)
    limits = [limit for limit in limits if limit < high]
    edges = axes.transScale.transform([(1.0, each) for each in (low, *limits, high)])[:, 1]
    middles = axes.transScale.inverted().transform(
        [(0.0, each) for each in 0.5 * (edges[1:] + edges[:-1])]
    )[:, 1]
    heights = np.diff(edges) / (edges[-1] - edges[0])
    zones = zip(middles, names, heights, strict=False)
    named = [(middle, name) for middle, name, height in zones if height > 0.05]
    right = axes.secondary_yaxis("right")
    right.set_yticks(*zip(*named, strict=True))
    right.yaxis.set_minor_locator(NullLocator())
    right.tick_params(length=0)
