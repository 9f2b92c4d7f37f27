"""Sensitivity to each unprinted input: a heat map of elasticities."""

import textwrap
from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh

from thirdbody.paper.sheets import result_name
from thirdbody.plotting.drawing import TWO_COLUMNS, Drawing, empty_panels
from thirdbody.plotting.panels import CURVE, Panel, Series

ROW = 0.17  # height of a row [inches]
BESIDE = 2.0  # inches for the names of the results, the title and the note
LETTERS = 110  # in a line of the note
TITLE = "Sensitivities: elasticities, d ln(result)/d ln(input)"
END = 3.0  # of the colours, beyond which values lie
LEAST = 0.05  # elasticity whose number is printed
DARK = 0.45  # lightness of a cell below which its text is white
LIGHTNESS = (0.299, 0.587, 0.114)  # weights of red, green, blue: ITU-R BT.601
CORNERS = np.array([(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)])  # of a cell


def plot(rows: Sequence[Mapping]) -> Drawing:
    """Elasticities of results over inputs, from rows of the table ``sensitivity``."""
    missing = dict.fromkeys(result_name(row) for row in rows if not row["input"])
    rows = [row for row in rows if row["elasticity"] is not None]
    inputs = _by_weight(rows)
    results = list(dict.fromkeys(map(result_name, rows)))
    values = np.full((len(inputs), len(results)), np.nan)
    series = []
    for row in rows:
        cell = inputs.index(row["input"]), results.index(result_name(row))
        values[cell] = row["elasticity"]
        name = f"{results[cell[1]]}; {row['input']}; {row['elasticity']:.10g}"
        series.append(Series(CURVE, name, *(CORNERS + cell[::-1]).T))
    panels = [Panel(TITLE, "result", "elasticity", series)]
    figure = empty_panels(panels, (TWO_COLUMNS, ROW * len(inputs) + BESIDE), columns=1)
    (axes,) = figure.axes
    mesh = _draw_cells(axes, values)
    bar = figure.colorbar(mesh, ax=axes, extend="both", pad=0.01, aspect=30)
    bar.outline.set_visible(False)
    axes.set_yticks(np.arange(len(inputs)) + 0.5, [name.replace("_", " ") for name in inputs])
    style = {"rotation": 40, "ha": "right", "rotation_mode": "anchor"}
    axes.set_xticks(np.arange(len(results)) + 0.5, results, **style)
    if missing:
        text = textwrap.fill(f"Without a value at the default: {'; '.join(missing)}.", LETTERS)
        figure.supxlabel(text, fontsize=7, x=0.02, ha="left")
    return figure


def _by_weight(rows) -> list[str]:
    """The inputs in decreasing order of their largest elasticity."""
    weights = {}
    for row in rows:
        weights[row["input"]] = max(weights.get(row["input"], 0.0), abs(row["elasticity"]))
    return sorted(weights, key=weights.__getitem__, reverse=True)


def _draw_cells(axes: Axes, values: np.ndarray) -> QuadMesh:
    """A coloured cell for each value, with its number if it is not negligible."""
    mesh = axes.pcolormesh(
        values, cmap="RdBu", vmin=-END, vmax=END, edgecolors="white", linewidth=0.6
    )
    axes.invert_yaxis()
    axes.tick_params(length=0)
    axes.spines[:].set_visible(False)
    for (line, column), value in np.ndenumerate(values):
        if abs(value) >= LEAST:
            dark = np.dot(mesh.to_rgba(value)[:3], LIGHTNESS) < DARK
            text = f"{value:.2f}" if abs(value) < 0.995 else f"{value:#.2g}".rstrip(".")
            style = {"ha": "center", "va": "center_baseline", "fontsize": 6}
            style["color"] = "white" if dark else "black"
            axes.text(column + 0.5, line + 0.55, text.replace("-", "−"), **style)
    return mesh
