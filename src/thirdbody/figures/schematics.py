"""Figures 1 and 2: the three-body interface and its contact modes, drawn to scale."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from thirdbody.data.netcdf import PlainDataset
from thirdbody.figures.curves import CELL, add_key, key_title
from thirdbody.figures.drawing import CURVE, Drawing, Panel, Series, grid_of_axes
from thirdbody.figures.scales import label, shared_notes
from thirdbody.figures.sections import PARTICLES, Section, condition_of, panels_of
from thirdbody.model.regimes import CONTACT_MODES

INTERFACE = 7.0, 3.1  # cell of figure 1 [inches]
MARGINS = 0.1, 0.1, 0.1, 0.3
KEY_INCHES = 0.55  # below figure 1
MICROMETRE = 1e-6

SURFACE_1, SURFACE_2, LUBRICANT, NO_LUBRICANT = "0.83", "0.70", "#D6ECF8", "white"
FREE = {"markerfacecolor": "#F6D58A", "markeredgecolor": "0.2", "markeredgewidth": 0.7}
CARRYING = {"markerfacecolor": "C4", "markeredgecolor": "C1", "markeredgewidth": 1.8}
TOUCHING = {"color": "C1", "linewidth": 3.2, "solid_capstyle": "butt"}
OUTLINE = {"color": "0.2", "linewidth": 0.8}
MEAN_PLANE = {"color": "0.35", "linewidth": 0.6, "linestyle": (0, (6, 3))}
SPAN = {"arrowstyle": "<|-|>", "color": "black", "linewidth": 0.8, "shrinkA": 0, "shrinkB": 0}
PUSH = SPAN | {"arrowstyle": "-|>", "linewidth": 2.0, "mutation_scale": 14}
BOX = {"marker": "s", "markeredgecolor": "0.2", "markeredgewidth": 0.7}
KEY = {
    "surface 1": BOX | {"markerfacecolor": SURFACE_1},
    "surface 2": BOX | {"markerfacecolor": SURFACE_2},
    "lubricant": BOX | {"markerfacecolor": LUBRICANT},
    "particle that carries load": CARRYING | {"marker": "o"},
    "free particle": FREE | {"marker": "o"},
}
# the modes of figure 2 in the order of its panels
MODES = {"surface_surface": "s-s mode", "particle_surface": "p-s mode", "hybrid": "hybrid mode"}


def plot_interface(data: PlainDataset) -> Drawing:
    """Figure 1: one section of the lubricated three-body interface; ``ValueError`` without lubricant or
    particles."""
    (section,) = panels_of(data)
    condition = condition_of(section)
    if condition.is_dry or condition.is_two_body:
        raise ValueError(f"figure 1 shows particles in a lubricant, not {label(condition)}")
    figure = grid_of_axes(1, INTERFACE, MARGINS, columns=1, below=KEY_INCHES)
    title = ", ".join(shared_notes([condition]))
    axes = _draw_section(figure, title, section)
    axes.set_title(title, loc="left", y=1.0)  # the only panel has no letter
    _draw_arrows(axes, section)
    add_key(figure, _entries(KEY), "", beside=False)
    return figure


def plot_modes(data: PlainDataset) -> Drawing:
    """Figure 2: a section for each of ``MODES``, in this order; ``ValueError`` if the model finds a
    different mode than a panel shows."""
    sections = panels_of(data)
    figure = grid_of_axes(len(MODES), CELL, MARGINS)
    common = shared_notes([condition_of(section) for section in sections])
    for letter, section, mode in zip("ABC", sections, MODES, strict=True):
        condition, found = condition_of(section), CONTACT_MODES[section["contact_mode"]]
        if found != mode:
            raise ValueError(
                f"figure 2{letter} shows the {mode} mode; at its conditions "
                f"({label(condition)}) the model finds {found}"
            )
        own = (text for text in shared_notes([condition]) if text not in common)
        _draw_section(figure, ", ".join((MODES[mode], *own)), section)
    title = key_title("lengths and heights to one scale", common)
    looks = {text: look for text, look in KEY.items() if text != "lubricant"}
    add_key(figure, _entries(looks), title, beside=True)
    return figure


def _entries(looks) -> list[Line2D]:
    """Legend entries."""
    entries = [
        Line2D([], [], label=text, linestyle="none", markersize=9.0, **look)
        for text, look in looks.items()
    ]
    return [*entries, Line2D([], [], label="contact of summits", **TOUCHING)]


def _draw_section(figure: Drawing, title: str, section: Section) -> Axes:
    """Draw a section, lengths and heights to the same scale: surfaces, contacts of summits, and
    particles, undeformed although they indent the surfaces where they are held."""
    series: list[Series] = []
    axes = figure.add_panel(Panel(title, "position", "height", series))
    position, length = section["position"], section["position"][-1]
    box = axes.get_window_extent()
    middle, reach = 0.5 * section["separation"], 0.5 * length * box.height / box.width
    axes.set(xlim=(0.0, length), ylim=(middle - reach, middle + reach), xticks=[], yticks=[])
    axes.set_facecolor(NO_LUBRICANT if section["viscosity"] == 0.0 else LUBRICANT)
    lines = {"surface 1": section["upper"], "surface 2": section["lower"]}
    edges = (middle + reach, SURFACE_1), (middle - reach, SURFACE_2)
    for heights, (edge, colour) in zip(lines.values(), edges, strict=True):
        axes.fill_between(position, heights, edge, color=colour, linewidth=0)
        axes.plot(position, heights, **OUTLINE)
    if section["surfaces_touch"].any():
        touching = np.where(section["surfaces_touch"], section["lower"], np.nan)
        lines["contact of summits"] = touching
        axes.plot(position, touching, **TOUCHING)
    series += [Series(CURVE, name, position, heights) for name, heights in lines.items()]
    angle = np.linspace(0.0, 2.0 * np.pi, 121)
    particles = zip(*(section[name] for name in PARTICLES), strict=True)
    for x, y, size, carries_load in (each for each in particles if not np.isnan(each[0])):
        outline = x + 0.5 * size * np.cos(angle), y + 0.5 * size * np.sin(angle)
        state, look = ("carries load", CARRYING) if carries_load else ("free", FREE)
        series.append(Series(CURVE, f"particle of {size:.4g} m; {state}", *outline))
        colour, edge, width = look.values()
        axes.fill(*outline, facecolor=colour, edgecolor=edge, linewidth=width, zorder=2.5)
    height, end = middle - 0.9 * reach, 0.97 * length
    axes.plot([end - MICROMETRE, end], [height, height], color="black", linewidth=2.0)
    axes.text(end - MICROMETRE, height, "1 µm  ", ha="right", va="center")
    facts = (
        f"d = {section['separation'] / MICROMETRE:.2f} µm, "
        f"$A_{{sa,t}}^*$ = {section['particle_contact_area_ratio']:.2f}, "
        f"$L_s$ = {section['solid_load_fraction']:.0%}"
    )
    axes.text(0.03, 0.95, facts, transform=axes.transAxes, va="top")
    return axes


def _draw_arrows(axes, section):
    """The separation of the mean planes, and the load on both surfaces."""
    length, d = section["position"][-1], section["separation"]
    for height in (0.0, d):
        axes.axhline(height, **MEAN_PLANE)
    place = 0.03 * length
    axes.annotate("", (place, 0.0), (place, d), arrowprops=SPAN)
    axes.text(place, 0.5 * d, "  $d$", va="center")
    bottom, top = axes.get_ylim()
    for end, start in ((0.5 * (d + top), 0.98 * top), (0.5 * bottom, 0.98 * bottom)):
        axes.annotate("", (0.5 * length, end), (0.5 * length, start), arrowprops=PUSH)
        axes.text(0.5 * length, 0.5 * (start + end), "   $F_t$", va="center")


SCHEMATICS: dict[str, Callable[[PlainDataset], Drawing]] = {
    "fig01": plot_interface,
    "fig02": plot_modes,
}
