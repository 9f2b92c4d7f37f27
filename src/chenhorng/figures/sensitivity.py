"""Sensitivity to each unprinted input: a heat map of elasticities."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh

from chenhorng.figures.captions import FIGURES
from chenhorng.sheets import result_name
from thirdbody.notes import wrapped
from thirdbody.plotting.drawing import TWO_COLUMNS, Drawing, empty_panels
from thirdbody.plotting.panels import CURVE, Panel, Series
from thirdbody.symbols import mathtext

ROW = 0.19  # height of a row [inches]
BESIDE = 2.1  # inches for the names of the results, the title and the note
LETTERS = 100  # in a line of the note
SIZE = 7.0  # of numbers and notes [points]
END = 3.0  # of the colours, beyond which values lie
LEAST = 0.05  # elasticity whose number is printed
DARK = 0.45  # lightness of a cell below which its text is white
LIGHTNESS = (0.299, 0.587, 0.114)  # weights of red, green, blue: ITU-R BT.601
CORNERS = np.array([(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)])  # of a cell
NUMBERS = "no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten"


def plot(rows: Sequence[Mapping], symbols: Mapping[str, str]) -> Drawing:
    """Elasticities of results over inputs, from rows of the table ``sensitivity``; inputs have
    ``symbols`` in ASCII, and a row if they have an elasticity that is not negligible."""
    missing = dict.fromkeys(result_name(row) for row in rows if not row["input"])
    rows = [row for row in rows if row["elasticity"] is not None]
    weights = _weights(rows)
    inputs = [name for name, weight in weights.items() if weight >= LEAST]
    rows = [row for row in rows if row["input"] in inputs]
    results = list(dict.fromkeys(map(result_name, rows)))
    values = np.full((len(inputs), len(results)), np.nan)
    series = []
    for row in rows:
        cell = inputs.index(row["input"]), results.index(result_name(row))
        values[cell] = row["elasticity"]
        name = f"{results[cell[1]]}; {row['input']}; {row['elasticity']:.10g}"
        series.append(Series(CURVE, name, *(CORNERS + cell[::-1]).T))
    decisive = len({*np.argmax(np.abs(values), axis=0).tolist()})
    words = FIGURES["sensitivity"]
    title = words["panel"].format(NUMBERS[decisive])
    figure = empty_panels(
        [Panel(title, "result", "elasticity", series)],
        (TWO_COLUMNS, ROW * len(inputs) + BESIDE),
        columns=1,
    )
    (axes,) = figure.axes
    mesh = _draw_cells(axes, values)
    bar = figure.colorbar(mesh, ax=axes, extend="both", pad=0.01, aspect=30)
    bar.outline.set_visible(False)
    bar.set_label(words["scale"], fontsize=SIZE)
    names = [_input_name(name, symbols.get(name, "")) for name in inputs]
    axes.set_yticks(np.arange(len(inputs)) + 0.5, names)
    style: dict[str, Any] = {"rotation": 40, "ha": "right", "rotation_mode": "anchor"}
    axes.set_xticks(np.arange(len(results)) + 0.5, map(mathtext, results), **style)
    negligible = [_input_name(name, "") for name in weights if name not in inputs]
    notes = {
        words["faint"].format(LEAST): negligible,
        words["missing"]: missing,
    }
    texts = [f"{what} {', '.join(each)}." for what, each in notes.items() if each]
    lines = "\n".join(wrapped(text, width=LETTERS) for text in texts)
    figure.supxlabel(mathtext(lines), fontsize=SIZE, x=0.02, ha="left")
    return figure


def _input_name(name, symbol) -> str:
    """An input in words, with its symbol if it has one."""
    words = name.replace("_", " ")
    return " ".join(filter(None, (words, mathtext(symbol, is_symbol=True))))


def _weights(rows) -> dict[str, float]:
    """The largest elasticity of each input, in decreasing order."""
    weights: dict[str, float] = {}
    for row in rows:
        weights[row["input"]] = max(weights.get(row["input"], 0.0), abs(row["elasticity"]))
    return dict(sorted(weights.items(), key=lambda item: -item[1]))


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
            style: dict[str, Any] = {"ha": "center", "va": "center_baseline", "fontsize": SIZE}
            style["color"] = "white" if dark else "black"
            axes.text(column + 0.5, line + 0.55, text.replace("-", "−"), **style)
    return mesh
