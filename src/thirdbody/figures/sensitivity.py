"""How results respond to each unpublished input: elasticities beside total Sobol indices."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from thirdbody.data.conditions import AXES
from thirdbody.figures.sheet.naming import note
from thirdbody.figures.sheet.panel import FURNITURE, NamedPoints, Panel

WIDTH = 7.0  # inches
LINE_INCHES = 0.032  # height of one result's line
GAP = 2.0  # lines between two inputs
MARGINS = {"top": 0.28, "bottom": 0.48}  # inches, without the key
KEY_ROW = 0.165  # inches
KEY_COLUMNS = 3
LETTERS = 20  # in a line of an input's name
KEY_WIDTH = 110  # characters of a line
# measure: letter, title, label of the axis, left and right edge of the axes as shares of the figure
PANELS = {
    "elasticity": ("A", "Elasticity", "d ln(result)/d ln(input)", 0.205, 0.635),
    "sobol_total": ("B", "Total Sobol index", "share of the variance", 0.665, 0.985),
}
LINEAR = 0.1  # elasticities are linear up to it, logarithmic beyond
# (result, level): marker and colour; curves that differ otherwise are told apart by the filling
LOOKS = {
    ("turning_point_load", None): ("o", "C5"),
    ("turning_point_ratio", None): ("*", "C0"),
    ("window_low", None): ("<", "C3"),
    ("window_high", None): (">", "C3"),
    ("transition_load", 0.9): ("s", "C1"),
    ("transition_load", 0.03): ("D", "C1"),
    ("transition_load", 0.95): ("^", "C6"),
    ("transition_load", 0.05): ("v", "C6"),
}
FILLINGS = ("full", "none", "bottom")
NAMES = {
    "turning_point_load": "turning point, load",
    "turning_point_ratio": "turning point, Aₛₐ,ₜ*",
    "window_low": "window, low end",
    "window_high": "window, high end",
    "solid_load_fraction": "load where Lₛ = {:g}",
    "particle_contact_area_ratio": "load where Aₛₐ,ₜ* = {:g}",
}
MARKER = {"markersize": 3.2, "markeredgewidth": 0.5}


def plot(rows: Sequence[Mapping]) -> Figure:
    """How every result responds to every input: elasticities beside total Sobol indices.

    Every result has its own line within the band of each input; the key lists the results from
    the top of a band downwards.

    Parameters
    ----------
    rows : sequence of Mapping
        Rows of the table ``sensitivity``.
    """
    missing = dict.fromkeys(_name(row) for row in rows if not row["input"])
    rows = [row for row in rows if row["input"]]
    inputs = _by_weight(rows)
    looks = _looks(rows)
    responses: dict[tuple, list] = {}
    for row in rows:
        if row["sensitivity"] is not None:
            responses.setdefault((row["measure"], _name(row)), []).append(row)
    band = len(looks) + GAP
    key_rows = math.ceil(len(looks) / KEY_COLUMNS)
    below = MARGINS["bottom"] + KEY_ROW * (key_rows + 0.7 + len(_absent(missing)))
    drawn = band * len(inputs) * LINE_INCHES
    figure = Figure(figsize=(WIDTH, MARGINS["top"] + drawn + below))
    for measure, (letter, title, label, left, right) in PANELS.items():
        box = left, below / figure.get_figheight(), right - left, drawn / figure.get_figheight()
        panel = figure.add_axes(Panel(figure, box, letter, measure, "line"))
        for place, (name, look) in enumerate(looks.items()):
            some = responses.get((measure, name), [])
            lines = [inputs.index(row["input"]) * band + place + 0.5 * GAP + 0.5 for row in some]
            _draw_responses(panel, lines, some, look)
        _frame(panel, len(inputs), band, title, label)
    _name_inputs(figure.axes[0], inputs, band)
    _draw_key(figure, looks, missing)
    return figure


def _name(row) -> str:
    """The result of ``row`` with what tells it from others."""
    name = NAMES[row["quantity"] or row["output"]].format(row["level"])
    if row["output"].startswith("window"):
        return f"{name}, {_condition('roughness', row)}"
    if row["output"].startswith("turning_point"):
        return f"{name}, {_condition('viscosity', row).removeprefix('ν = ')}"
    return f"{name}, {_condition('particle_diameter', row)}"


def _condition(name, row) -> str:
    return note(name, row[AXES[name].column])


def _looks(rows) -> dict:
    """Line properties of each result by its name."""
    looks: dict = {}
    alike: dict = {}
    for row in rows:
        if _name(row) not in looks:
            marker, colour = LOOKS[row["output"], row["level"]]
            place = alike[marker] = alike.get(marker, -1) + 1
            filling = FILLINGS[place % len(FILLINGS)]
            looks[_name(row)] = {"marker": marker, "color": colour, "fillstyle": filling} | MARKER
    return looks


def _by_weight(rows) -> list[str]:
    """The inputs, those with the largest total index or else elasticity first."""
    largest: dict = {}
    for row in rows:
        weights = largest.setdefault(row["input"], dict.fromkeys(reversed(PANELS), 0.0))
        weights[row["measure"]] = max(weights[row["measure"]], abs(row["sensitivity"] or 0.0))
    return sorted(largest, key=lambda name: tuple(largest[name].values()), reverse=True)


def _draw_responses(panel, lines, rows, look):
    """A marker at each sensitivity of one result, on a line from zero, over its error."""
    if not rows:
        return
    values = np.array([row["sensitivity"] for row in rows])
    stem = {"color": look["color"], "label": FURNITURE}
    panel.hlines(lines, 0.0, values, linewidth=0.4, zorder=1, **stem)
    if panel.x_name == "sobol_total":
        errors = np.array([row["error"] for row in rows])
        panel.hlines(
            lines, values - errors, values + errors, linewidth=1.0, alpha=0.5, zorder=1.5, **stem
        )
    names = [f"{_name(row)}; {row['input']}" for row in rows]
    panel.add_line(NamedPoints(list(zip(values, lines, strict=True)), names, zorder=2, **look))


def _frame(panel, inputs, band, title, label):
    """Scale and ticks, and a shade behind every other input."""
    for place in range(0, inputs, 2):
        shade = {"color": "0.955", "linewidth": 0, "zorder": 0, "label": FURNITURE}
        panel.axhspan(place * band, (place + 1) * band, **shade)
    panel.axvline(0.0, color="black", linewidth=0.6, label=FURNITURE, zorder=1)
    panel.autoscale_view(scaley=False)
    panel.set_ylim(inputs * band, 0.0)
    panel.xaxis.set_visible(True)
    if panel.x_name == "elasticity":
        panel.set_xscale("symlog", linthresh=LINEAR, linscale=0.6)
        ticks = [sign * size for size in (10.0, 1.0, 0.1) for sign in (-1, 1)]
        panel.set_xticks([0.0, *ticks], ["0", *(f"{tick:g}" for tick in ticks)])
    panel.set_xlabel(label, fontsize=8)
    panel.add_title(title)


def _absent(missing) -> list[str]:
    """Lines that name the results which do not occur at the default."""
    if not missing:
        return []
    return textwrap.wrap(f"Without a value at the default: {'; '.join(missing)}", KEY_WIDTH)


def _draw_key(figure, looks, missing):
    """Results by marker, from the top of a band downwards, and those that do not occur."""
    handles = [Line2D([], [], linestyle="none", label=name, **look) for name, look in looks.items()]
    title = "\n".join(_absent(missing)) or None
    style = {"ncols": KEY_COLUMNS, "handlelength": 1.0, "title_fontsize": 7}
    figure.legend(handles=handles, loc="lower center", title=title, **style)


def _name_inputs(panel, inputs, band):
    style = {"ha": "right", "va": "center", "transform": panel.get_yaxis_transform()}
    for place, name in enumerate(inputs):
        words = textwrap.fill(name.replace("_", " "), LETTERS)
        panel.text(-0.02, (place + 0.5) * band, words, fontsize=7.5, **style)
