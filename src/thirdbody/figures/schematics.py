"""Figures 1 and 2: the three-body interface and its contact modes, drawn true to scale."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from thirdbody.figures.curves import CELL, add_key, key_title
from thirdbody.figures.drawing import CURVE, Drawing, Panel, Series, grid_of_axes, title_axes
from thirdbody.figures.naming import label, shared_notes
from thirdbody.figures.sections import Section

INTERFACE, INTERFACE_MARGINS = (7.0, 3.1), (0.1, 0.1, 0.1, 0.3)  # cell of figure 1 [inches]
MODE, MODE_MARGINS = CELL, (0.1, 0.1, 0.1, 0.3)  # of figure 2
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


def plot_interface(sections: Sequence[Section]) -> Drawing:
    """Figure 1: one section of the lubricated three-body interface; ``ValueError`` without lubricant or
    particles."""
    (section,) = sections
    state, condition = section.state, section.state.condition
    if condition.is_dry or condition.is_two_body:
        raise ValueError(f"figure 1 shows particles in a lubricant, not {label(condition)}")
    figure = grid_of_axes(1, INTERFACE, INTERFACE_MARGINS, columns=1, below=KEY_INCHES)
    (axes,) = figure.axes
    facts = f"d = {state.separation / MICROMETRE:.2f} µm, $L_s$ = {state.solid_load_fraction:.0%}"
    panel = _panel("A", ", ".join((*shared_notes([condition]), facts)), section)
    axes.set_title(panel.title, loc="left", y=1.0)
    _draw_section(axes, section)
    _draw_arrows(axes, section)
    add_key(figure, _entries(KEY), "", beside=False)
    return Drawing(figure, (panel,))


def plot_modes(sections: Sequence[Section]) -> Drawing:
    """Figure 2: a section in each of ``MODES``, in this order; ``ValueError`` if the model finds another
    mode than a panel is to show."""
    figure = grid_of_axes(len(MODES), MODE, MODE_MARGINS)
    common = shared_notes([section.state.condition for section in sections])
    panels = []
    for letter, axes, section, mode in zip("ABC", figure.axes, sections, MODES, strict=True):
        state, condition = section.state, section.state.condition
        if state.contact_mode != mode:
            raise ValueError(
                f"figure 2{letter} shows the {mode} mode; at its conditions "
                f"({label(condition)}) the model finds {state.contact_mode}"
            )
        own = (text for text in shared_notes([condition]) if text not in common)
        panels.append(_panel(letter, ", ".join((MODES[mode], *own)), section))
        _draw_section(axes, section)
        title_axes(axes, panels[-1])
        facts = f"d = {state.separation / MICROMETRE:.2f} µm, "
        facts += f"$A_{{sa,t}}^*$ = {state.particle_contact_area_ratio:.2f}"
        axes.text(0.03, 0.95, facts, transform=axes.transAxes, va="top")
    title = key_title("lengths and heights to one scale", common)
    looks = {text: look for text, look in KEY.items() if text != "lubricant"}
    add_key(figure, _entries(looks), title, beside=True)
    return Drawing(figure, tuple(panels))


def _entries(looks) -> list[Line2D]:
    """Entries of the key."""
    entries = [
        Line2D([], [], label=text, linestyle="none", markersize=9.0, **look)
        for text, look in looks.items()
    ]
    return [*entries, Line2D([], [], label="contact of summits", **TOUCHING)]


def _panel(letter, title, section) -> Panel:
    """The lines of a section: surfaces, the contact of summits, outlines of particles."""
    lines = {"surface 1": section.upper, "surface 2": section.lower}
    if section.touches.any():
        lines["contact of summits"] = np.where(section.touches, section.lower, np.nan)
    series = [Series(CURVE, name, section.position, heights) for name, heights in lines.items()]
    for particle in section.particles:
        state = "carries load" if particle.carries_load else "free"
        name = f"particle of {particle.diameter:.4g} m; {state}"
        series.append(Series(CURVE, name, *_outline(particle)))
    return Panel(letter, title, "position", "height", tuple(series))


def _outline(particle):
    """Circle of an undeformed particle, which dents the surfaces where it is held."""
    angle = np.linspace(0.0, 2.0 * np.pi, 121)
    radius = 0.5 * particle.diameter
    return particle.position + radius * np.cos(angle), particle.height + radius * np.sin(angle)


def _draw_section(axes: Axes, section: Section) -> None:
    """Draw a section, lengths and heights to one scale."""
    position, length = section.position, section.position[-1]
    box = axes.get_window_extent()
    middle, reach = 0.5 * section.state.separation, 0.5 * length * box.height / box.width
    axes.set(xlim=(0.0, length), ylim=(middle - reach, middle + reach), xticks=[], yticks=[])
    axes.set_facecolor(NO_LUBRICANT if section.state.condition.is_dry else LUBRICANT)
    bodies = (section.upper, middle + reach, SURFACE_1), (section.lower, middle - reach, SURFACE_2)
    for heights, edge, colour in bodies:
        axes.fill_between(position, heights, edge, color=colour, linewidth=0)
        axes.plot(position, heights, **OUTLINE)
    for particle in section.particles:
        colour, edge, width = (CARRYING if particle.carries_load else FREE).values()
        look = {"facecolor": colour, "edgecolor": edge, "linewidth": width}
        axes.fill(*_outline(particle), **look, zorder=2.5)
    axes.plot(position, np.where(section.touches, section.lower, np.nan), **TOUCHING)
    height, end = middle - 0.9 * reach, 0.97 * length
    axes.plot([end - MICROMETRE, end], [height, height], color="black", linewidth=2.0)
    axes.text(end - MICROMETRE, height, "1 µm  ", ha="right", va="center")


def _draw_arrows(axes, section):
    """The separation of the mean planes, and the load on both surfaces."""
    length, d = section.position[-1], section.state.separation
    for height in (0.0, d):
        axes.axhline(height, **MEAN_PLANE)
    place = 0.03 * length
    axes.annotate("", (place, 0.0), (place, d), arrowprops=SPAN)
    axes.text(place, 0.5 * d, "  $d$", va="center")
    bottom, top = axes.get_ylim()
    for end, start in ((0.5 * (d + top), 0.98 * top), (0.5 * bottom, 0.98 * bottom)):
        axes.annotate("", (0.5 * length, end), (0.5 * length, start), arrowprops=PUSH)
        axes.text(0.5 * length, 0.5 * (start + end), "   $F_t$", va="center")


SCHEMATICS: dict[str, Callable[[Sequence[Section]], Drawing]] = {
    "fig01": plot_interface,
    "fig02": plot_modes,
}
