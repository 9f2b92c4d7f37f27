"""Sensitivity to each unprinted input: heat maps of elasticities and total Sobol indices."""

import textwrap
from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh

from thirdbody.figures.drawing import TWO_COLUMNS, Drawing, empty_panels
from thirdbody.figures.panels import CURVE, Panel, Series
from thirdbody.readable import MEASURES, result_name

ROW = 0.17  # height of a row [inches]
BESIDE = 2.3  # inches for the names of the results, the titles and the note
ENDS = {"elasticity": "both", "sobol_total": "max"}  # of the colour bars, beyond which values lie
LETTERS = 110  # in a line of the note
# measure: colour map, values at its ends, smallest value that is printed
SHADES = {"elasticity": ("RdBu", (-3.0, 3.0), 0.05), "sobol_total": ("Blues", (0.0, 0.6), 0.015)}
DARK = 0.45  # lightness of a cell below which its text is white
LIGHTNESS = (0.299, 0.587, 0.114)  # weights of red, green, blue: ITU-R BT.601
CORNERS = np.array([(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)])  # of a cell


def plot(rows: Sequence[Mapping]) -> Drawing:
    """Elasticities above total Sobol indices, from rows of the table ``sensitivity``."""
    missing = dict.fromkeys(result_name(row) for row in rows if not row["input"])
    rows = [row for row in rows if row["input"]]
    inputs = _by_weight(rows)
    results = list(dict.fromkeys(map(result_name, rows)))
    values = {measure: np.full((len(inputs), len(results)), np.nan) for measure in MEASURES}
    series = {measure: [] for measure in MEASURES}
    for row in rows:
        measure, value = row["measure"], row["sensitivity"]
        if value is not None:
            place = inputs.index(row["input"]), results.index(result_name(row))
            values[measure][place] = value
            name = f"{results[place[1]]}; {row['input']}; {value:.10g}"
            series[measure].append(Series(CURVE, name, *(CORNERS + place[::-1]).T))
    panels = [Panel(title, "result", name, series[name]) for name, title in MEASURES.items()]
    figure = empty_panels(panels, (TWO_COLUMNS, 2 * ROW * len(inputs) + BESIDE), columns=1)
    for axes, measure in zip(figure.axes, MEASURES, strict=True):
        mesh = _draw_cells(axes, values[measure], measure)
        bar = figure.colorbar(mesh, ax=axes, extend=ENDS[measure], pad=0.01, aspect=30)
        bar.outline.set_visible(False)
        axes.set_yticks(np.arange(len(inputs)) + 0.5, [name.replace("_", " ") for name in inputs])
        axes.set_xticks([])
    style = {"rotation": 40, "ha": "right", "rotation_mode": "anchor"}
    axes.set_xticks(np.arange(len(results)) + 0.5, results, **style)
    if missing:
        text = textwrap.fill(f"Without a value at the default: {'; '.join(missing)}.", LETTERS)
        figure.supxlabel(text, fontsize=7, x=0.02, ha="left")
    return figure


def _by_weight(rows) -> list[str]:
    """The inputs in decreasing order of total index, then of elasticity."""
    weights = {row["input"]: dict.fromkeys(reversed(MEASURES), 0.0) for row in rows}
    for row in rows:
        largest, measure = weights[row["input"]], row["measure"]
        largest[measure] = max(largest[measure], abs(row["sensitivity"] or 0.0))
    return sorted(weights, key=lambda name: tuple(weights[name].values()), reverse=True)


def _draw_cells(axes: Axes, values: np.ndarray, measure: str) -> QuadMesh:
    """A coloured cell for each value, with its number if it is not negligible."""
    colours, (low, high), least = SHADES[measure]
    mesh = axes.pcolormesh(
        values, cmap=colours, vmin=low, vmax=high, edgecolors="white", linewidth=0.6
    )
    axes.invert_yaxis()
    axes.tick_params(length=0)
    axes.spines[:].set_visible(False)
    for (line, column), value in np.ndenumerate(values):
        if abs(value) >= least:
            dark = np.dot(mesh.to_rgba(value)[:3], LIGHTNESS) < DARK
            text = f"{value:.2f}" if abs(value) < 0.995 else f"{value:#.2g}".rstrip(".")
            style = {"ha": "center", "va": "center_baseline", "fontsize": 6}
            style["color"] = "white" if dark else "black"
            axes.text(column + 0.5, line + 0.55, text.replace("-", "−"), **style)
    return mesh
