"""Figures 1 and 2: the three-body interface and its contact modes, drawn true to scale."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from thirdbody.figures.section_file import Section
from thirdbody.figures.sheet.key import draw_key
from thirdbody.figures.naming import label, notes, shared_notes
from thirdbody.figures.sheet.panel import FURNITURE, Panel, panel_figure

MODE_EDGES = {"left": 0.03, "right": 0.97, "bottom": 0.03, "top": 0.89}
INTERFACE_SIZE = (7.0, 3.0)  # of figure 1 [inches]
INTERFACE_BOX = (0.02, 0.03, 0.96, 0.88)
SCALE_BAR = 1e-6  # [m]
MICROMETRE = 1e-6

SURFACE_1, SURFACE_2, LUBRICANT, NO_LUBRICANT = "0.83", "0.70", "#D6ECF8", "white"
FREE = {"facecolor": "#F6D58A", "edgecolor": "0.2", "linewidth": 0.7}
BEARING = {"facecolor": "C4", "edgecolor": "C1", "linewidth": 1.8}
TOUCHING = {"color": "C1", "linewidth": 3.2, "solid_capstyle": "butt"}
OUTLINE = {"color": "0.2", "linewidth": 0.8}
MEAN_PLANE = {"color": "0.35", "linewidth": 0.6, "linestyle": (0, (6, 3)), "label": FURNITURE}
LEADER = {"color": "0.2", "linewidth": 0.6, "label": FURNITURE}
ARROW = {"color": "black", "linewidth": 0.8, "shrinkA": 0, "shrinkB": 0}

# the modes of figure 2 in the order of its panels
MODES = {"surface_surface": "s-s mode", "particle_surface": "p-s mode", "hybrid": "hybrid mode"}


def plot_interface(sections: Sequence[Section]) -> Figure:
    """Figure 1: the lubricated three-body interface.

    Parameters
    ----------
    sections : sequence of Section
        The one to draw.

    Raises
    ------
    ValueError
        Where there is no lubricant or there are no particles.
    """
    (section,) = sections
    state, condition = section.state, section.state.condition
    if condition.is_dry or condition.is_two_body:
        raise ValueError(f"figure 1 shows particles in a lubricant, not {label(condition)}")
    figure = Figure(figsize=INTERFACE_SIZE)
    panel = figure.add_axes(Panel(figure, INTERFACE_BOX, "A", "position", "height"))
    draw_section(panel, section)
    facts = f"d = {state.separation / MICROMETRE:.2f} µm, Lₛ = {state.solid_load_fraction:.0%}"
    title = ", ".join((*notes(condition), facts))
    panel.write(0.0, 1.0, title, y_points=4, va="bottom")
    panel.write(1.0, 1.0, "lengths and heights to one scale", y_points=4, va="bottom", ha="right")
    _name_parts(panel, section)
    return figure


def plot_modes(sections: Sequence[Section]) -> Figure:
    """Figure 2: the s-s, p-s and hybrid modes.

    Parameters
    ----------
    sections : sequence of Section
        One in each of ``MODES``, in this order.

    Raises
    ------
    ValueError
        Where the model finds another mode than the panel is to show.
    """
    figure = panel_figure([("position", "height")] * len(MODES), MODE_EDGES)
    common = shared_notes([section.state.condition for section in sections])
    for panel, section, mode in zip(figure.axes, sections, MODES, strict=True):
        state, condition = section.state, section.state.condition
        if state.contact_mode != mode:
            raise ValueError(
                f"figure 2{panel.letter} shows the {mode} mode; at its conditions "
                f"({label(condition)}) the model finds {state.contact_mode}"
            )
        draw_section(panel, section)
        own = (text for text in notes(condition) if text not in common)
        panel.add_title(", ".join((MODES[mode], *own)))
        facts = f"d = {state.separation / MICROMETRE:.2f} µm, "
        facts += f"Aₛₐ,ₜ* = {state.particle_contact_area_ratio:.2f}"
        panel.write(0.03, 0.96, facts, va="top")
    draw_key(figure, "lengths and heights to one scale", ", ".join(common), _mode_key())
    return figure


def _mode_key():
    round_mark = {"linestyle": "none", "marker": "o", "markersize": 9.0}
    marks = [
        round_mark
        | {"markerfacecolor": style["facecolor"], "markeredgecolor": style["edgecolor"]}
        | {"markeredgewidth": style["linewidth"]}
        for style in (BEARING, FREE)
    ]
    square = {"linestyle": "none", "marker": "s", "markersize": 9.0, "markeredgecolor": "0.2"}
    return [
        ("surface 1", square | {"markerfacecolor": SURFACE_1}),
        ("surface 2", square | {"markerfacecolor": SURFACE_2}),
        ("contact of summits", TOUCHING),
        ("particle that bears load", marks[0]),
        ("free particle", marks[1]),
    ]


def draw_section(panel: Panel, section: Section) -> None:
    """Fill ``panel`` with the section, lengths and heights to one scale."""
    state = section.state
    length = section.position[-1]
    width, height = panel.bbox.size
    reach = 0.5 * length * height / width
    bottom, top = 0.5 * state.separation - reach, 0.5 * state.separation + reach
    panel.set(xlim=(0.0, length), ylim=(bottom, top))
    panel.spines[:].set_visible(True)
    panel.patch.set_facecolor(NO_LUBRICANT if state.condition.is_dry else LUBRICANT)
    _draw_body(panel, section.position, section.upper, top, "surface 1", SURFACE_1)
    _draw_body(panel, section.position, section.lower, bottom, "surface 2", SURFACE_2)
    _draw_particles(panel, section.particles)
    if section.touches.any():
        contact = np.where(section.touches, section.lower, np.nan)
        panel.add_line(Line2D(section.position, contact, label="contact of summits", **TOUCHING))
    _draw_scale_bar(panel, length, bottom, top)


def _draw_body(panel, position, heights, end, name, colour):
    """The solid between its surface at ``heights`` and the edge of the panel at ``end``."""
    panel.fill_between(position, heights, end, color=colour, linewidth=0, label=FURNITURE)
    panel.add_line(Line2D(position, heights, label=name, **OUTLINE))


def _draw_particles(panel, particles):
    """Undeformed particles, which dent the surfaces where they are held."""
    angle = np.linspace(0.0, 2.0 * np.pi, 121)
    circle = np.column_stack((np.cos(angle), np.sin(angle)))
    looks = [BEARING if p.bears_load else FREE for p in particles]
    states = ["bears load" if p.bears_load else "free" for p in particles]
    panel.add_outlines(
        [(p.position, p.height) + 0.5 * p.diameter * circle for p in particles],
        [f"particle of {p.diameter:.4g} m; {s}" for p, s in zip(particles, states, strict=True)],
        **{f"{name}s": [look[name] for look in looks] for name in FREE},
        zorder=2.5,
    )


def _draw_scale_bar(panel, length, bottom, top):
    end, height = 0.97 * length, bottom + 0.05 * (top - bottom)
    start = end - SCALE_BAR
    bar = {"color": "black", "linewidth": 2.0, "label": FURNITURE}
    panel.add_line(Line2D([start, end], [height, height], **bar))
    text = f"{SCALE_BAR / MICROMETRE:g} µm  "
    panel.text(start, height, text, ha="right", va="center")


def _name_parts(panel, section):
    """Write what is what into figure 1."""
    length, d = section.position[-1], section.state.separation
    bottom, top = panel.get_ylim()
    above, below = 0.55 * top + 0.45 * d, 0.55 * bottom
    for height, name in ((above, "surface 1"), (below, "surface 2")):
        panel.text(0.04 * length, height, name, va="center")
    lubricant = _open_place(section)
    _point_out(panel, "lubricant", (lubricant[0], above), [lubricant], SURFACE_1)
    name = 0.68 * length, below
    near = sorted(section.particles, key=lambda particle: abs(particle.position - name[0]))[:2]
    _point_out(panel, "particles", name, [(p.position, p.height) for p in near], SURFACE_2)
    if section.touches.any():
        middle = np.flatnonzero(section.touches).mean().astype(int)
        contact = section.position[middle], section.lower[middle]
        _point_out(panel, "contact of summits", (contact[0], below), [contact], SURFACE_2)
    _draw_arrows(panel, length, d)


def _draw_arrows(panel, length, separation):
    """The separation between the mean planes, and the load on both surfaces."""
    for height in (0.0, separation):
        panel.axhline(height, **MEAN_PLANE)
    place = 0.03 * length
    span = ARROW | {"arrowstyle": "<|-|>"}
    panel.annotate("", (place, 0.0), (place, separation), arrowprops=span)
    panel.text(place, 0.5 * separation, "  d", style="italic", va="center")
    bottom, top = panel.get_ylim()
    push = ARROW | {"arrowstyle": "-|>", "linewidth": 2.0, "mutation_scale": 14}
    for end, start in ((0.5 * (separation + top), 0.98 * top), (0.5 * bottom, 0.98 * bottom)):
        panel.annotate("", (0.5 * length, end), (0.5 * length, start), arrowprops=push)
        panel.text(0.5 * length, 0.5 * (start + end), "   Fₜ", style="italic", va="center")


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


def _point_out(panel, name, place, targets, ground):
    """Write ``name`` at ``place``, on the colour ``ground``, with a thin line to each target."""
    for target in targets:
        panel.add_line(Line2D(*zip(place, target, strict=True), zorder=2.7, **LEADER))
    box = {"facecolor": ground, "linewidth": 0, "pad": 2}
    panel.text(*place, name, bbox=box, ha="center", va="center")
