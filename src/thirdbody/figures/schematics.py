"""Figures 1 and 2: the three-body interface and its contact modes, drawn true to scale."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from thirdbody.figures.curves import CELL, add_key, key_title
from thirdbody.figures.drawing import CURVE, Drawing, Panel, Series, grid_of_axes, title_axes
from thirdbody.figures.naming import label, shared_notes
from thirdbody.figures.sections import Section

INTERFACE_SIZE = (7.0, 3.0)  # of figure 1 [inches]
INTERFACE_ASPECT, MODE_ASPECT = 0.38, 0.74  # height of a section over its length
MODE_MARGINS = 0.1, 0.1, 0.1, 0.3  # of a panel of figure 2 [inches]
MICROMETRE = 1e-6

SURFACE_1, SURFACE_2, LUBRICANT, NO_LUBRICANT = "0.83", "0.70", "#D6ECF8", "white"
FREE = {"markerfacecolor": "#F6D58A", "markeredgecolor": "0.2", "markeredgewidth": 0.7}
CARRYING = {"markerfacecolor": "C4", "markeredgecolor": "C1", "markeredgewidth": 1.8}
TOUCHING = {"color": "C1", "linewidth": 3.2, "solid_capstyle": "butt"}
OUTLINE = {"color": "0.2", "linewidth": 0.8}
MEAN_PLANE = {"color": "0.35", "linewidth": 0.6, "linestyle": (0, (6, 3))}
SPAN = {"arrowstyle": "<|-|>", "color": "black", "linewidth": 0.8, "shrinkA": 0, "shrinkB": 0}
PUSH = SPAN | {"arrowstyle": "-|>", "linewidth": 2.0, "mutation_scale": 14}
LEADER = {"arrowstyle": "-", "color": "0.2", "linewidth": 0.6, "shrinkA": 0, "shrinkB": 0}

# the modes of figure 2 in the order of its panels
MODES = {"surface_surface": "s-s mode", "particle_surface": "p-s mode", "hybrid": "hybrid mode"}


def plot_interface(sections: Sequence[Section]) -> Drawing:
    """Figure 1: one section of the lubricated three-body interface.

    Raises
    ------
    ValueError
        If there is no lubricant or there are no particles.
    """
    (section,) = sections
    state, condition = section.state, section.state.condition
    if condition.is_dry or condition.is_two_body:
        raise ValueError(f"figure 1 shows particles in a lubricant, not {label(condition)}")
    figure = Figure(figsize=INTERFACE_SIZE, layout="constrained")
    axes = figure.add_subplot()
    facts = f"d = {state.separation / MICROMETRE:.2f} µm, $L_s$ = {state.solid_load_fraction:.0%}"
    panel = _panel("A", ", ".join((*shared_notes([condition]), facts)), section)
    draw_section(axes, section, INTERFACE_ASPECT)
    axes.set_title(panel.title, loc="left")
    axes.set_title("to scale", loc="right")
    _name_parts(axes, section)
    return Drawing(figure, (panel,))


def plot_modes(sections: Sequence[Section]) -> Drawing:
    """Figure 2: a section in each of ``MODES``, in this order.

    Raises
    ------
    ValueError
        If the model finds another mode than the panel is to show.
    """
    figure = grid_of_axes(len(MODES), CELL, MODE_MARGINS)
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
        draw_section(axes, section, MODE_ASPECT)
        title_axes(axes, panels[-1])
        facts = f"d = {state.separation / MICROMETRE:.2f} µm, "
        facts += f"$A_{{sa,t}}^*$ = {state.particle_contact_area_ratio:.2f}"
        axes.text(0.03, 0.95, facts, transform=axes.transAxes, va="top")
    box = {"marker": "s", "markeredgecolor": "0.2", "markeredgewidth": 0.7}
    looks = {
        "surface 1": box | {"markerfacecolor": SURFACE_1},
        "surface 2": box | {"markerfacecolor": SURFACE_2},
        "particle that carries load": CARRYING | {"marker": "o"},
        "free particle": FREE | {"marker": "o"},
    }
    entries = [
        Line2D([], [], label=text, linestyle="none", markersize=9.0, **look)
        for text, look in looks.items()
    ]
    entries.append(Line2D([], [], label="contact of summits", **TOUCHING))
    title = key_title("lengths and heights to one scale", common)
    add_key(figure, entries, title, beside=True)
    return Drawing(figure, tuple(panels))


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


def draw_section(axes: Axes, section: Section, aspect: float) -> None:
    """Draw a section, lengths and heights to one scale, in axes of this height over width."""
    state, position = section.state, section.position
    length = position[-1]
    middle, reach = 0.5 * state.separation, 0.5 * aspect * length
    axes.set_box_aspect(aspect)
    axes.set(xlim=(0.0, length), ylim=(middle - reach, middle + reach), xticks=[], yticks=[])
    axes.set_facecolor(NO_LUBRICANT if state.condition.is_dry else LUBRICANT)
    bodies = (section.upper, middle + reach, SURFACE_1), (section.lower, middle - reach, SURFACE_2)
    for heights, edge, colour in bodies:
        axes.fill_between(position, heights, edge, color=colour, linewidth=0)
        axes.plot(position, heights, **OUTLINE)
    for particle in section.particles:
        colour, edge, width = (CARRYING if particle.carries_load else FREE).values()
        axes.fill(
            *_outline(particle), facecolor=colour, edgecolor=edge, linewidth=width, zorder=2.5
        )
    axes.plot(position, np.where(section.touches, section.lower, np.nan), **TOUCHING)
    height, end = middle - 0.9 * reach, 0.97 * length
    axes.plot([end - MICROMETRE, end], [height, height], color="black", linewidth=2.0)
    axes.text(end - MICROMETRE, height, "1 µm  ", ha="right", va="center")


def _name_parts(axes, section):
    """Write what is what into figure 1: surfaces, lubricant, particles, the separation, the load."""
    length, d = section.position[-1], section.state.separation
    bottom, top = axes.get_ylim()
    above, below = 0.55 * top + 0.45 * d, 0.55 * bottom
    axes.text(0.04 * length, above, "surface 1", va="center")
    axes.text(0.04 * length, below, "surface 2", va="center")
    gap = _open_place(section)
    _point_out(axes, "lubricant", (gap[0], above), [gap], SURFACE_1)
    name = 0.68 * length, below
    near = sorted(section.particles, key=lambda particle: abs(particle.position - name[0]))[:2]
    _point_out(axes, "particles", name, [(p.position, p.height) for p in near], SURFACE_2)
    if section.touches.any():
        middle = np.flatnonzero(section.touches).mean().astype(int)
        contact = section.position[middle], section.lower[middle]
        _point_out(axes, "contact of summits", (contact[0], below), [contact], SURFACE_2)
    for height in (0.0, d):
        axes.axhline(height, **MEAN_PLANE)
    place = 0.03 * length
    axes.annotate("", (place, 0.0), (place, d), arrowprops=SPAN)
    axes.text(place, 0.5 * d, "  $d$", va="center")
    for end, start in ((0.5 * (d + top), 0.98 * top), (0.5 * bottom, 0.98 * bottom)):
        axes.annotate("", (0.5 * length, end), (0.5 * length, start), arrowprops=PUSH)
        axes.text(0.5 * length, 0.5 * (start + end), "   $F_t$", va="center")


def _open_place(section):
    """Middle of the gap where it is widest, beside particles, arrows and the name of a surface."""
    position, length = section.position, section.position[-1]
    free = (position > 0.2 * length) & (position < 0.95 * length)
    taken = [(0.5 * length, 0.1 * length)]
    taken += [(p.position, 0.5 * p.diameter) for p in section.particles]
    for place, reach in taken:
        free &= np.abs(position - place) > reach
    widest = int(np.where(free, section.upper - section.lower, 0.0).argmax())
    return position[widest], 0.5 * (section.lower + section.upper)[widest]


def _point_out(axes, name, place, targets, ground):
    """Write ``name`` at ``place``, on the colour ``ground``, with a thin line to each target."""
    for target in targets:
        axes.annotate("", target, place, arrowprops=LEADER, zorder=2.7)
    box = {"facecolor": ground, "linewidth": 0, "pad": 2}
    axes.text(*place, name, bbox=box, ha="center", va="center", zorder=3)


SCHEMATICS: dict[str, Callable[[Sequence[Section]], Drawing]] = {
    "fig01": plot_interface,
    "fig02": plot_modes,
}
