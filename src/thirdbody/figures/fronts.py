"""What it costs the other statements that one of them holds, under every reading."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib import rcParams
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from thirdbody.figures.claims import score_of
from thirdbody.figures.sheet.panel import FURNITURE, Panel

COLUMNS = 3
CELL = 3.1, 1.9  # inches of a panel with its labels
MARGINS = {"left": 0.5, "right": 0.1, "bottom": 0.42, "top": 0.28}  # inches
KEY_LINE = 0.15  # inches of a line of the key
DISTANCES = (0, 0.5, 1, 2, 5, 20)  # in tolerances, on the axis
ABOVE = 25.0  # the objective is drawn up to so much above the least
DASHES = ("-", (0, (4, 1.5)))  # two turns through the colours


def plot(readings: Sequence[Mapping]) -> Figure:
    """The front of each chief statement against all others, a line a reading.

    Parameters
    ----------
    readings : sequence of Mapping
        Contents of the calibrated files; the first one is drawn above the others.
    """
    statements = list(dict.fromkeys(name for each in readings for name in each["fronts"]))
    rows, lines = -(-len(statements) // COLUMNS), -(-len(readings) // COLUMNS)
    key = KEY_LINE * (lines + 1)
    size = COLUMNS * CELL[0], rows * CELL[1] + key
    figure = Figure(figsize=size)
    for place, statement in enumerate(statements):
        row, column = divmod(place, COLUMNS)
        corner = column * CELL[0] + MARGINS["left"], size[1] - (row + 1) * CELL[1]
        box = (
            corner[0] / size[0],
            (corner[1] + MARGINS["bottom"]) / size[1],
            (CELL[0] - MARGINS["left"] - MARGINS["right"]) / size[0],
            (CELL[1] - MARGINS["bottom"] - MARGINS["top"]) / size[1],
        )
        letter = chr(ord("A") + place)
        panel = figure.add_axes(Panel(figure, box, letter, "score", "objective_without_it"))
        _draw_fronts(panel, statement, readings)
        panel.write(0.0, 1.0, f"({letter})  {statement}", y_points=4, va="bottom")
    figure.legend(
        handles=[
            Line2D([], [], label=each["reading"], **_look(n)) for n, each in enumerate(readings)
        ],
        loc="lower center",
        ncols=COLUMNS,
        borderpad=0.3,
        fontsize=6.5,
    )
    return figure


def _look(place) -> dict:
    """How the line of a reading looks: the first is heavy."""
    colours = rcParams["axes.prop_cycle"].by_key()["color"]
    turn, colour = divmod(place, len(colours))
    width = 1.6 if place == 0 else 0.9
    return {"color": colours[colour], "linestyle": DASHES[turn % 2], "linewidth": width}


def _draw_fronts(panel, statement, readings):
    """The fronts of one statement, and the line up to which it holds."""
    fronts = [np.array(each["fronts"].get(statement, ())).reshape(-1, 2) for each in readings]
    last, least = score_of(DISTANCES[-1]), min(front[:, 1].min() for front in fronts if front.size)
    for place, (reading, front) in enumerate(zip(readings, fronts, strict=True)):
        # what was seen this near the statement is good for all that is farther
        line = np.vstack([front, [last, front[-1, 1]]]) if front.size else front
        panel.plot(
            *line.T,
            drawstyle="steps-post",
            label=reading["reading"],
            zorder=3 if place == 0 else 2,
            **_look(place),
        )
    panel.axvline(1.0, color="black", linewidth=0.7, label=FURNITURE, zorder=1.5)
    for axis in (panel.xaxis, panel.yaxis):
        axis.set_visible(True)
    panel.set_xticks([score_of(each) for each in DISTANCES], list(map(str, DISTANCES)))
    panel.set(xlim=(-0.05, last), ylim=(least - 1.0, least + ABOVE))
    panel.tick_params(labelsize=6)
    panel.set_xlabel("deviation in tolerances", fontsize=7, labelpad=1)
    panel.set_ylabel("objective of all others", fontsize=7, labelpad=2)
