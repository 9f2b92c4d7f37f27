"""Figures 1 and 2: the three-body interface and its contact modes, with stretched heights."""

from collections.abc import Callable

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from thirdbody.beside import toml_beside
from thirdbody.data.netcdf import PlainDataset
from thirdbody.figures.curves import add_key
from thirdbody.figures.drawing import CURVE, Drawing, Panel, Series, empty_panels
from thirdbody.figures.scales import label, shared_notes
from thirdbody.figures.sections import PARTICLES, Section, condition_of, panels_of
from thirdbody.model.regimes import CONTACT_MODES

INTERFACE, MODES = (7.0, 3.5), (7.0, 5.8)  # sizes of the figures [inches]
INTERFACE_SHAPE, MODES_SHAPE = 0.4, 0.76  # height over length of their sections on paper
STRETCH = 3.5  # of heights over lengths
MICROMETRE = 1e-6
SCALE = 7e-6  # length of the scale bar [m]

SUMMITS, LUBRICANT = "contact of summits", "lubricant"
ZONE = "elastic zone $h_e$"
NAMED = ("surface 1", "surface 2", LUBRICANT)  # on the drawing
CONTENT = toml_beside(__file__)
LOOKS, ARROWS, MODE_TITLES = CONTENT["patches"], CONTENT["arrows"], CONTENT["modes"]
MEAN_PLANE = {"color": "0.35", "linewidth": 0.6, "linestyle": (0, (6, 3))}


def plot_interface(data: PlainDataset) -> Drawing:
    """Figure 1: one section; ``ValueError`` without lubricant or particles."""
    (section,) = panels_of(data)
    condition = condition_of(section)
    if condition.is_dry or condition.is_two_body:
        raise ValueError(f"figure 1 shows particles in a lubricant, not {label(condition)}")
    title = ", ".join(shared_notes([condition]))
    figure = empty_panels([_panel(title, section)], INTERFACE, columns=1)
    (axes,) = figure.axes
    axes.set_title(title, loc="left")  # the only panel has no letter
    _draw_section(axes, figure.panels[0], section, INTERFACE_SHAPE)
    _draw_arrows(axes, section)
    _name_parts(axes, section)
    add_key(figure, _entries(*NAMED), f"heights stretched {STRETCH:g} times")
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
    figure = empty_panels(panels, MODES)
    for axes, panel, section in zip(figure.axes, figure.panels, sections, strict=True):
        _draw_section(axes, panel, section, MODES_SHAPE)
    add_key(
        figure, _entries(LUBRICANT), f"heights stretched {STRETCH:g} times", common, beside=True
    )
    return figure


def _entries(*left_out: str) -> list[Artist]:
    """The entries of the key."""
    looks = {text: look for text, look in LOOKS.items() if text not in left_out}
    kinds = {ZONE: lambda **look: Line2D([], [], **look)}
    return [kinds.get(text, Patch)(label=text, **look) for text, look in looks.items()]


def _panel(title, section: Section) -> Panel:
    """The lines of a section: surfaces, contacts of summits, and the circles of the particles,
    undeformed although they indent the surfaces where they are held."""
    position, touch = section["position"], section["surfaces_touch"]
    lines = {"surface 1": section["upper"], "surface 2": section["lower"]}
    if touch.any():
        lines[SUMMITS] = np.where(touch, section["lower"], np.nan)
    series = [Series(CURVE, name, position, line, look=LOOKS[name]) for name, line in lines.items()]
    angle = np.linspace(0.0, 2.0 * np.pi, 121)
    for x, y, size, carries_load in zip(*(section[name] for name in PARTICLES), strict=True):
        if not np.isnan(x):
            circle = x + 0.5 * size * np.cos(angle), y + 0.5 * size * np.sin(angle)
            state = "carries load" if carries_load else "free"
            look = LOOKS["particle that carries load" if carries_load else "free particle"]
            series.append(Series(CURVE, f"particle of {size:.4g} m; {state}", *circle, look=look))
    return Panel(title, "position", "height", series)


def _draw_section(axes: Axes, panel: Panel, section: Section, shape: float) -> None:
    """Draw the lines of a section, with stretched heights; ``shape`` is height over length on paper."""
    position, length = section["position"], section["position"][-1]
    middle, reach = 0.5 * section["separation"], 0.5 * shape * length / STRETCH
    edges = {"surface 1": middle + reach, "surface 2": middle - reach}
    if section["viscosity"] > 0.0:
        axes.fill_between(position, section["lower"], section["upper"], **LOOKS[LUBRICANT])
    for series in panel.series:
        if series.name in edges:
            axes.fill_between(series.x, series.y, edges[series.name], **series.look)
        elif series.name == SUMMITS:
            axes.plot(series.x, series.y, solid_capstyle="butt", **series.look)
        else:
            axes.fill(series.x, series.y, zorder=2.5, **series.look)
    axes.vlines(*_elastic_zones(section), **LOOKS[ZONE])
    axes.set(xlim=(0.0, length), ylim=(middle - reach, middle + reach), xticks=[], yticks=[])
    axes.set_aspect(STRETCH)
    height, end = middle - 0.9 * reach, 0.97 * length
    axes.plot([end - SCALE, end], [height, height], color="black", linewidth=2.0)
    axes.text(end - SCALE, height, f"{SCALE / MICROMETRE:g} µm  ", ha="right", va="center")
    axes.plot([end, end], [height, height + SCALE / STRETCH], color="black", linewidth=2.0)
    axes.text(
        end,
        height + SCALE / STRETCH,
        f"{SCALE / STRETCH / MICROMETRE:g} µm",
        ha="right",
        va="bottom",
    )
    facts = (
        f"d = {section['separation'] / MICROMETRE:.2f} µm, "
        f"$A_{{sa,t}}^*$ = {section['particle_contact_area_ratio']:.2f}, "
        f"$L_s$ = {section['solid_load_fraction']:.0%}"
    )
    axes.text(0.03, 0.95, facts, transform=axes.transAxes, va="top")


def _elastic_zones(section):
    """Position, and lower and upper end, of the gap above each particle that carries load through h_e."""
    x, height, size, carries = (section[name] for name in PARTICLES)
    above = np.interp(x, section["position"], section["upper"])
    top = height + 0.5 * size
    through = (carries > 0) & (above > top)
    return x[through], top[through], above[through]


def _name_parts(axes, section):
    """Names of the surfaces and of the lubricant on the drawing."""
    position, length = section["position"], section["position"][-1]
    bottom, top = axes.get_ylim()
    axes.text(0.97 * length, 0.55 * top, "surface 1", ha="right", va="center")
    axes.text(0.75 * length, 0.75 * bottom, "surface 2", ha="right", va="center")
    gap = section["upper"] - section["lower"]
    widest = np.argmax(gap)
    place = position[widest], 0.5 * (section["upper"] + section["lower"])[widest]
    beside = place[0] + 0.06 * length * (1 if place[0] < 0.5 * length else -1), 0.6 * bottom
    axes.annotate(LUBRICANT, place, beside, ha="center", va="top", arrowprops=ARROWS["leader"])


def _draw_arrows(axes, section):
    """The separation of the mean planes, and the load on both surfaces."""
    length, d = section["position"][-1], section["separation"]
    for height in (0.0, d):
        axes.axhline(height, **MEAN_PLANE)
    place = 0.03 * length
    axes.annotate("", (place, 0.0), (place, d), arrowprops=ARROWS["separation"])
    axes.text(place, 0.5 * d, "  $d$", va="center")
    bottom, top = axes.get_ylim()
    for end, start in ((0.5 * (d + top), 0.98 * top), (0.5 * bottom, 0.98 * bottom)):
        axes.annotate("", (0.5 * length, end), (0.5 * length, start), arrowprops=ARROWS["load"])
        axes.text(0.5 * length, 0.5 * (start + end), "   $F_t$", va="center")


SCHEMATICS: dict[str, Callable[[PlainDataset], Drawing]] = {
    "fig01": plot_interface,
    "fig02": plot_modes,
}
