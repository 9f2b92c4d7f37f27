"""How results respond to each unpublished input: heat maps of elasticities and total Sobol indices."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence

import matplotlib
import numpy as np
from matplotlib.colors import to_hex
from matplotlib.figure import Figure

from thirdbody.data.readable import MEASURES, result_name
from thirdbody.figures.sheet.panel import NamedOutlines, Panel

WIDTH = 7.0  # inches
CELL_INCHES = 0.17  # height of a row
MARGINS = {"top": 0.3, "left": 1.62, "right": 0.08, "between": 0.42, "names": 1.35, "note": 0.3}
LETTERS = 110  # in a line of the note
# measure: colour map, largest value that has a colour of its own, least that is written
SHADES = {"elasticity": ("RdBu", 3.0, 0.05), "sobol_total": ("Blues", 0.6, 0.015)}
DARK = 0.45  # lightness of a cell below which its number is white
LIGHTNESS = (0.299, 0.587, 0.114)  # weights of red, green, blue: ITU-R BT.601


def plot(rows: Sequence[Mapping]) -> Figure:
    """How every result responds to every input: elasticities above total Sobol indices.

    Parameters
    ----------
    rows : sequence of Mapping
        Rows of the table ``sensitivity``.
    """
    missing = dict.fromkeys(result_name(row) for row in rows if not row["input"])
    rows = [row for row in rows if row["input"]]
    inputs = _by_weight(rows)
    results = list(dict.fromkeys(result_name(row) for row in rows))
    map_height = CELL_INCHES * len(inputs)
    height = MARGINS["top"] + 2 * map_height + sum(MARGINS[n] for n in ("between", "names", "note"))
    figure = Figure(figsize=(WIDTH, height))
    top = height - MARGINS["top"]
    for letter, (measure, title) in zip("AB", MEASURES.items(), strict=True):
        box = (
            MARGINS["left"] / WIDTH,
            (top - map_height) / height,
            (WIDTH - MARGINS["left"] - MARGINS["right"]) / WIDTH,
            map_height / height,
        )
        panel = figure.add_axes(Panel(figure, box, letter, "result", measure))
        panel.set(xlim=(0.0, len(results)), ylim=(len(inputs), 0.0))
        panel.add_title(title)
        some = [row for row in rows if row["measure"] == measure and row["sensitivity"] is not None]
        _draw_cells(panel, some, inputs, results)
        _name_inputs(panel, inputs)
        top -= map_height + MARGINS["between"]
    _name_results(figure.axes[-1], results)
    if missing:
        text = f"Without a value at the default: {'; '.join(missing)}."
        figure.text(0.02, 0.02, textwrap.fill(text, LETTERS), fontsize=7, va="bottom")
    return figure


def _by_weight(rows) -> list[str]:
    """The inputs, those with the largest total index or else elasticity first."""
    largest: dict = {}
    for row in rows:
        weights = largest.setdefault(row["input"], dict.fromkeys(reversed(MEASURES), 0.0))
        weights[row["measure"]] = max(weights[row["measure"]], abs(row["sensitivity"] or 0.0))
    return sorted(largest, key=lambda name: tuple(largest[name].values()), reverse=True)


def _draw_cells(panel, rows, inputs, results):
    """A coloured cell for each response, and its number where it is not negligible."""
    if not rows:
        return
    name, end, least = SHADES[panel.y_name]
    values = np.array([row["sensitivity"] for row in rows])
    start = -end if panel.y_name == "elasticity" else 0.0
    shades = matplotlib.colormaps[name](np.clip((values - start) / (end - start), 0.0, 1.0))
    corners = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    places = [(results.index(result_name(row)), inputs.index(row["input"])) for row in rows]
    panel.add_collection(
        NamedOutlines(
            [corners + place for place in places],
            [f"{result_name(row)}; {row['input']}; {row['sensitivity']:.10g}" for row in rows],
            facecolors=[to_hex(shade) for shade in shades],
            edgecolors="white",
            linewidths=0.6,
        ),
        autolim=False,
    )
    style = {"ha": "center", "va": "center_baseline", "fontsize": 5.6}
    for (column, line), value, shade in zip(places, values, shades, strict=True):
        if abs(value) >= least:
            dark = np.dot(shade[:3], LIGHTNESS) < DARK
            text = f"{value:.2f}" if abs(value) < 1.0 else f"{value:.2g}"
            colour = "white" if dark else "black"
            panel.text(column + 0.5, line + 0.55, text.replace("-", "−"), color=colour, **style)


def _name_inputs(panel, inputs):
    style = {"ha": "right", "va": "center_baseline", "fontsize": 7}
    transform = panel.get_yaxis_transform()
    for place, name in enumerate(inputs):
        panel.text(-0.01, place + 0.55, name.replace("_", " "), transform=transform, **style)


def _name_results(panel, results):
    style = {"rotation": 40, "ha": "right", "va": "top", "rotation_mode": "anchor", "fontsize": 6.5}
    transform = panel.get_xaxis_transform()
    for place, name in enumerate(results):
        panel.text(place + 0.6, -0.03, name, transform=transform, **style)
