"""Figures 1 and 2: the three-body interface and its contact modes, with stretched heights."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from chenhorng.figures.captions import SENTENCES
from chenhorng.figures.sections import PARTICLES, STRETCH, Section, condition_of
from thirdbody.core.film import has_film
from thirdbody.core.regimes import CONTACT_MODES
from thirdbody.plotting.drawing import TWO_COLUMNS, Drawing, empty_panels
from thirdbody.plotting.panels import CURVE, Panel, Series
from thirdbody.plotting.scales import label, shared_notes
from thirdbody.symbols import mathtext

INTERFACE, MODES = 3.55, 2.9  # heights of the figures [inches]
INTERFACE_SHAPE, MODES_SHAPE = 0.42, 0.92  # height over length of their sections on paper
MICROMETRE = 1e-6
SCALE = 0.5e-6  # height of the scale bar [m]
# where names have their middles, in lengths of a section, so that they fit
INTERFACE_NAMES, MODES_NAMES = (0.2, 0.66), (0.36, 0.48)

SUMMITS, LUBRICANT = "contact of summits", "lubricant"
PARTICLE = "particle under load"
# titles of the modes in the order of the panels of figure 2
MODE_TITLES = {
    "surface_surface": "s-s mode",
    "particle_surface": "p-s mode",
    "hybrid": "hybrid mode",
}
# how matplotlib draws what they show
LOOKS: dict[str, dict[str, Any]] = {
    "surface 1": {"facecolor": "0.86", "edgecolor": "0.2", "linewidth": 0.8},
    "surface 2": {"facecolor": "0.76", "edgecolor": "0.2", "linewidth": 0.8},
    LUBRICANT: {"facecolor": "#D6ECF8", "edgecolor": "0.2", "linewidth": 0.8, "zorder": 2.3},
    PARTICLE: {"facecolor": "C4", "edgecolor": "C1", "linewidth": 1.8},
    "free particle": {"facecolor": "#F6D58A", "edgecolor": "0.2", "linewidth": 0.3},
    SUMMITS: {"color": "C1", "linewidth": 3.2, "zorder": 2.4},
}
FROM_END_TO_END = {"shrinkA": 0, "shrinkB": 0}
LEADER = FROM_END_TO_END | {"arrowstyle": "-", "color": "0.2", "linewidth": 0.7}
HEIGHT = FROM_END_TO_END | {"arrowstyle": "<|-|>", "color": "black", "linewidth": 0.8}
LOAD = FROM_END_TO_END | {
    "arrowstyle": "-|>",
    "color": "black",
    "linewidth": 2.0,
    "mutation_scale": 14,
}
MEAN_PLANE = {"color": "0.35", "linewidth": 0.6, "linestyle": (0, (6, 3)), "zorder": 2.4}
READING = SENTENCES["schematics"].format(STRETCH)


def plot_interface(sections: Sequence[Section]) -> Drawing:
    """Figure 1: one section; ``ValueError`` without lubricant or particles."""
    (section,) = sections
    condition = condition_of(section)
    if condition.is_dry or condition.is_two_body:
        raise ValueError(f"figure 1 shows particles in a lubricant, not {label(condition)}")
    title = ", ".join(shared_notes([condition]))
    figure = empty_panels([_panel(title, section)], (TWO_COLUMNS, INTERFACE), columns=1)
    (axes,) = figure.axes
    _draw_section(axes, figure.panels[0], section, INTERFACE_SHAPE)
    _draw_arrows(axes, section)
    _name_parts(axes, section, INTERFACE_NAMES)
    figure.supxlabel(READING, fontsize="medium")
    return figure


def plot_modes(sections: Sequence[Section]) -> Drawing:
    """Figure 2: a section for each of ``MODE_TITLES``; ``ValueError`` if its mode is another."""
    common = shared_notes([condition_of(section) for section in sections])
    panels = []
    for letter, section, mode in zip("ABC", sections, MODE_TITLES, strict=True):
        condition, found = condition_of(section), CONTACT_MODES[section["contact_mode"]]
        if found != mode:
            raise ValueError(
                f"figure 2{letter} shows the {mode} mode; at its conditions "
                f"({label(condition)}) the model finds {found}"
            )
        own = (text for text in shared_notes([condition]) if text not in common)
        panels.append(_panel(", ".join((MODE_TITLES[mode], *own)), section))
    figure = empty_panels(panels, (TWO_COLUMNS, MODES), columns=3)
    for axes, panel, section in zip(figure.axes, figure.panels, sections, strict=True):
        _draw_section(axes, panel, section, MODES_SHAPE)
        _name_parts(axes, section, MODES_NAMES)
    figure.supxlabel(mathtext(", ".join(common)) + f"\n{READING}", fontsize="medium")
    return figure


def _panel(title, section: Section) -> Panel:
    """A panel with the surfaces, contacts of summits and particles, which are round on paper."""
    position, touch = section["position"], section["surfaces_touch"]
    lines = {"surface 1": section["upper"], "surface 2": section["lower"]}
    if touch.any():
        lines[SUMMITS] = np.where(touch, section["lower"], np.nan)
    series = [Series(CURVE, name, position, line, look=LOOKS[name]) for name, line in lines.items()]
    angle = np.linspace(0.0, 2.0 * np.pi, 121)
    for x, y, size, carries_load in zip(*(section[name] for name in PARTICLES), strict=True):
        circle = x + 0.5 * STRETCH * size * np.cos(angle), y + 0.5 * size * np.sin(angle)
        state = "carries load" if carries_load else "free"
        look = LOOKS[PARTICLE if carries_load else "free particle"]
        series.append(Series(CURVE, f"particle of {size:.4g} m; {state}", *circle, look=look))
    return Panel(title, "position", "height", series)


def _draw_section(axes: Axes, panel: Panel, section: Section, shape: float) -> None:
    """Draw a section with stretched heights; ``shape`` is height over length on paper."""
    position, length = section["position"], section["position"][-1]
    middle, reach = 0.5 * section["separation"], 0.5 * shape * length / STRETCH
    edges = {"surface 1": middle + reach, "surface 2": middle - reach}
    if has_film(section["viscosity"]):
        axes.fill_between(position, section["lower"], section["upper"], **LOOKS[LUBRICANT])
    for series in panel.series:
        if series.name in edges:
            axes.fill_between(series.x, series.y, edges[series.name], **series.look)
        elif series.name == SUMMITS:
            axes.plot(series.x, series.y, solid_capstyle="round", **series.look)
        else:
            axes.fill(series.x, series.y, zorder=2.5, **series.look)
    axes.set(xlim=(0.0, length), ylim=(middle - reach, middle + reach), xticks=[], yticks=[])
    axes.set_aspect(STRETCH)
    corner, end = middle - 0.92 * reach, 0.78 * length
    start = end - STRETCH * SCALE
    bar = [start, end, end], [corner, corner, corner + SCALE]
    axes.plot(*bar, color="black", linewidth=1.5, zorder=4)
    across, up = f"{STRETCH * SCALE / MICROMETRE:g} µm", f"{SCALE / MICROMETRE:g} µm"
    axes.text(start, corner, f"{across} ", ha="right", va="center", zorder=4)
    axes.text(end, corner + 0.5 * SCALE, f" {up}", ha="left", va="center", zorder=4)
    facts = [
        f"F_t = {section['normal_load']:.3g} N",
        f"d = {section['separation'] / MICROMETRE:.2f} µm",
        f"A_sa,t* = {section['particle_contact_area_ratio']:.2f}",
    ]
    if has_film(section["viscosity"]):
        facts.append(f"L_s = {100.0 * section['solid_load_fraction']:.0f} %")
    axes.set_xlabel(mathtext(", ".join(facts)), fontsize="medium")


def _name_parts(axes, section, ends):
    """Name the parts.  Lines lead to a contact of summits and to a particle that touches both
    surfaces; the middles of these two names lie between the ``ends``."""
    position, length = section["position"], section["position"][-1]
    for name, height in (("surface 1", 0.95), ("surface 2", 0.05)):
        look = {"va": "top" if height > 0.5 else "bottom", "transform": axes.transAxes}
        axes.text(0.02, height, name, **look)
    bottom, top = axes.get_ylim()
    above, below = section["upper"].max(), section["lower"].min()
    highest, lowest = np.interp([0.84, 0.16], [0.0, 1.0], [bottom, top])  # beside names of surfaces
    middle = 0.5 * (section["upper"] + section["lower"])
    touching = np.flatnonzero(section["surfaces_touch"])
    if touching.size:
        first = np.split(touching, np.flatnonzero(np.diff(touching) > 1) + 1)[0]
        place = first[first.size // 2]
        beside = (
            np.clip(position[place] / length, *ends) * length,
            min(0.5 * (above + top), highest),
        )
        _point_at(axes, SUMMITS, (position[place], middle[place]), beside)
    if section["touching"]:
        x, y = (section[name][0] for name in PARTICLES[:2])
        beside = np.clip(x / length, *ends) * length, max(0.85 * below + 0.15 * bottom, lowest)
        _point_at(axes, PARTICLE, (x, y), beside)
    if has_film(section["viscosity"]):
        widest = np.argmax(section["upper"] - section["lower"])
        axes.text(position[widest], middle[widest], LUBRICANT, ha="center", va="center", zorder=4)


def _point_at(axes, text, place, beside):
    look = {"ha": "center", "va": "center", "arrowprops": LEADER, "zorder": 4}
    axes.annotate(text, place, beside, **look)
    axes.plot(*place, "o", color=LEADER["color"], markersize=2.2, zorder=4)


def _draw_arrows(axes, section):
    """Draw the mean planes, their separation, the depth of the elastic zone, and the load."""
    length, d = section["position"][-1], section["separation"]
    for height in (0.0, d):
        axes.axhline(height, **MEAN_PLANE)
    _draw_height(axes, 1.02, 0.0, d, "d")
    _draw_height(axes, 1.06, d - section["elastic_depth"], d, "h_e")
    bottom, top = axes.get_ylim()
    for end, start in ((0.6 * top + 0.4 * d, 0.98 * top), (0.6 * bottom, 0.98 * bottom)):
        axes.annotate("", (0.5 * length, end), (0.5 * length, start), arrowprops=LOAD)
        axes.text(0.52 * length, 0.5 * (start + end), mathtext("F_t"), va="center")


def _draw_height(axes, place, low, high, symbol):
    """An arrow from ``low`` to ``high`` with its symbol, at a ``place`` in widths of the panel."""
    across = axes.get_yaxis_transform()
    ends = {"xycoords": across, "textcoords": across, "annotation_clip": False}
    axes.annotate("", (place, low), (place, high), arrowprops=HEIGHT, **ends)
    axes.text(place, 0.5 * (low + high), f" {mathtext(symbol)}", va="center", transform=across)


SCHEMATICS: dict[str, Callable[[Sequence[Section]], Drawing]] = {
    "fig01": plot_interface,
    "fig02": plot_modes,
}
