"""Figures 1 and 2: the three-body interface and its contact modes, with stretched heights."""

from collections.abc import Callable, Sequence

import numpy as np
from matplotlib.axes import Axes

from thirdbody.data.netcdf import PlainDataset
from thirdbody.figures.drawing import CURVE, TWO_COLUMNS, Drawing, Panel, Series, empty_panels
from thirdbody.figures.scales import label, shared_notes
from thirdbody.figures.sections import PARTICLES, Section, condition_of, panels_of
from thirdbody.model.regimes import CONTACT_MODES
from thirdbody.toml_tables import toml_beside

INTERFACE, MODES = (TWO_COLUMNS, 3.1), (TWO_COLUMNS, 3.2)  # sizes of the figures [inches]
INTERFACE_SHAPE, MODES_SHAPE = 0.4, 1.25  # height over length of their sections on paper
STRETCH = 8.0  # of heights over lengths
MICROMETRE = 1e-6
LEFT, RIGHT = 0.12, 0.25  # parts of the length: of the arrow of d, and of the names of the surfaces

SUMMITS, LUBRICANT, ZONE = "contact of summits", "lubricant", "elastic zone"
CARRYING, FREE = "particle that carries load", "free particle"
CONTENT = toml_beside(__file__)
LOOKS, ARROWS, MODE_TITLES = CONTENT["looks"], CONTENT["arrows"], CONTENT["modes"]
NAMES = CONTENT["names"]
MEAN_PLANE = {"color": "0.35", "linewidth": 0.6, "linestyle": (0, (6, 3))}
NOTE = "heights stretched {0:g} times, particles drawn round"


def plot_interface(data: PlainDataset) -> Drawing:
    """Figure 1: one section; ``ValueError`` without lubricant or particles."""
    (section,) = panels_of(data)
    condition = condition_of(section)
    if condition.is_dry or condition.is_two_body:
        raise ValueError(f"figure 1 shows particles in a lubricant, not {label(condition)}")
    title = ", ".join([*shared_notes([condition]), NOTE.format(STRETCH)])
    figure = empty_panels([_panel(title, section)], INTERFACE, columns=1)
    (axes,) = figure.axes
    axes.set_title(title, loc="left")  # the only panel has no letter
    _draw_section(axes, figure.panels[0], section, INTERFACE_SHAPE)
    _draw_load(axes, section)
    _name_parts(axes, section, (SUMMITS, CARRYING, FREE, ZONE, LUBRICANT))
    return figure


def plot_modes(data: PlainDataset) -> Drawing:
    """Figure 2: a section for each of ``MODE_TITLES``; ``ValueError`` if the model finds other modes."""
    sections = panels_of(data)
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
    figure = empty_panels(panels, MODES, columns=3)
    for axes, panel, section in zip(figure.axes, figure.panels, sections, strict=True):
        _draw_section(axes, panel, section, MODES_SHAPE)
        _name_parts(axes, section, (SUMMITS, CARRYING, ZONE))
    figure.supxlabel(", ".join([*common, NOTE.format(STRETCH)]), fontsize=8)
    return figure


def _panel(title, section: Section) -> Panel:
    """The lines of a section: surfaces, contacts of summits, and the outlines of the particles, drawn round,
    undeformed although they indent the surfaces where they are held; the smaller of two that would overlap
    is left out."""
    position, touch = section["position"], section["surfaces_touch"]
    lines = {"surface 1": section["upper"], "surface 2": section["lower"]}
    if touch.any():
        lines[SUMMITS] = np.where(touch, section["lower"], np.nan)
    series = [Series(CURVE, name, position, line, look=LOOKS[name]) for name, line in lines.items()]
    angle = np.linspace(0.0, 2.0 * np.pi, 121)
    for x, y, size, carries in _shown(section):
        outline = x + 0.5 * STRETCH * size * np.cos(angle), y + 0.5 * size * np.sin(angle)
        state = "carries load" if carries else "free"
        look = LOOKS[CARRYING if carries else FREE]
        series.append(Series(CURVE, f"particle of {size:.4g} m; {state}", *outline, look=look))
    return Panel(title, "position", "height", series)


def _shown(section) -> list[Sequence[float]]:
    """Position, height, size and whether it carries load of each particle that is drawn: those that carry load
    first, then the largest."""
    rows = [
        row for row in zip(*(section[name] for name in PARTICLES), strict=True) if row[0] == row[0]
    ]
    shown = []
    for x, height, size, carries in sorted(rows, key=lambda row: (-row[3], -row[2])):
        apart = (abs(x - x2) > 0.5 * STRETCH * (size + size2) for x2, _, size2, _ in shown)
        if all(apart):
            shown.append((x, height, size, carries))
    return shown


def _draw_section(axes: Axes, panel: Panel, section: Section, shape: float) -> None:
    """Draw the lines of a section, with stretched heights; ``shape`` is height over length on paper."""
    position, length = section["position"], section["position"][-1]
    middle, reach = 0.5 * section["separation"], 0.5 * shape * length / STRETCH
    edges = {"surface 1": middle + reach, "surface 2": middle - reach}
    if section["viscosity"] > 0.0:
        axes.fill_between(position, section["lower"], section["upper"], **LOOKS[LUBRICANT])
    for x, bottom, _, size in _elastic_zones(section):
        inside = np.abs(position - x) <= 0.5 * STRETCH * size
        above = np.maximum(section["upper"][inside], bottom)
        axes.fill_between(position[inside], bottom, above, **LOOKS[ZONE])
    for series in panel.series:
        if series.name in edges:
            axes.fill_between(series.x, series.y, edges[series.name], **series.look)
        elif series.name == SUMMITS:
            axes.plot(series.x, series.y, solid_capstyle="butt", **series.look)
        else:
            axes.fill(series.x, series.y, zorder=2.5, **series.look)
    axes.set(xlim=(0.0, length), ylim=(middle - reach, middle + reach), xticks=[], yticks=[])
    axes.set_aspect(STRETCH)
    _draw_separation(axes, section)
    facts = (
        f"$d$ = {section['separation'] / MICROMETRE:.2f} µm\n"
        f"$A_{{sa,t}}^*$ = {section['particle_contact_area_ratio']:.2f}, "
        f"$L_s$ = {section['solid_load_fraction']:.0%}"
    )
    axes.text(0.03, 0.96, facts, transform=axes.transAxes, va="top", fontsize=7)


def _elastic_zones(section) -> list[Sequence[float]]:
    """Position, lower and upper end, and width of what is left of the gap above each particle that carries
    load through h_e."""
    zones = []
    for x, height, size, carries in _shown(section):
        above, top = np.interp(x, section["position"], section["upper"]), height + 0.5 * size
        if carries and above > top:
            zones.append((x, height, above, size))
    return zones


def _name_parts(axes, section, parts):
    """Names of the surfaces, and of ``parts`` at the lower edge with lines that lead to them."""
    (left, right), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    beside = section["position"] > (1.0 - RIGHT) * right
    style, away = {"fontsize": 7, "ha": "right"}, 0.02 * (top - bottom)
    highest, lowest = section["upper"][beside].max(), section["lower"][beside].min()
    axes.text(0.98 * right, highest + away, "surface 1", va="bottom", **style)
    axes.text(0.98 * right, lowest - away, "surface 2", va="top", **style)
    places = {name: place for name, place in _places(section).items() if name in parts}
    named = sorted(places, key=lambda name: places[name][0])
    for index, name in enumerate(named):
        x = left + (right - left) * (index + 0.5) / len(named)
        text = (x, bottom + 0.03 * (top - bottom))
        style = {"ha": "center", "va": "bottom", "fontsize": 7, "zorder": 3.0}
        axes.annotate(NAMES[name], places[name], text, arrowprops=ARROWS["leader"], **style)


def _places(section) -> dict[str, tuple[float, float]]:
    """A place of each part that there is."""
    position, lower, upper = (section[name] for name in ("position", "lower", "upper"))
    places, touch = {}, np.flatnonzero(section["surfaces_touch"])
    if touch.size:
        middle = touch[touch.size // 2]
        places[SUMMITS] = position[middle], lower[middle]
    for name, kind in ((CARRYING, 1), (FREE, 0)):
        some = [row for row in _shown(section) if row[3] == kind]
        if some:
            x, height, _, _ = max(some, key=lambda row: row[2])
            places[name] = x, height
    zones = _elastic_zones(section)
    if zones:
        x, height, above, size = max(zones, key=lambda zone: zone[3])
        places[ZONE] = x, 0.5 * (height + 0.5 * size + above)
    covered = position < LEFT * position[-1]
    for x, _, size, _ in _shown(section):
        covered |= np.abs(position - x) < 0.6 * STRETCH * size
    widest = np.argmax(np.where(covered, 0.0, upper - lower))
    places[LUBRICANT] = position[widest], 0.5 * (lower + upper)[widest]
    return places


def _draw_separation(axes, section):
    """The separation of the mean planes."""
    length, d = section["position"][-1], section["separation"]
    for height in (0.0, d):
        axes.axhline(height, **MEAN_PLANE)
    axes.annotate("", (0.03 * length, 0.0), (0.03 * length, d), arrowprops=ARROWS["separation"])
    axes.text(0.03 * length, 0.5 * d, "  $d$", va="center")


def _draw_load(axes, section):
    """The load on both surfaces."""
    place, d = 0.6 * section["position"][-1], section["separation"]
    bottom, top = axes.get_ylim()
    for end, start in ((d + 0.35 * (top - d), 0.98 * top), (0.35 * bottom, 0.98 * bottom)):
        axes.annotate("", (place, end), (place, start), arrowprops=ARROWS["load"])
        axes.text(place, 0.5 * (start + end), "   $F_t$", va="center")


SCHEMATICS: dict[str, Callable[[PlainDataset], Drawing]] = {
    "fig01": plot_interface,
    "fig02": plot_modes,
}
