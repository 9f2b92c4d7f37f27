"""Pareto fronts: the cost of each headline statement to all others, for every interpretation."""

import math
import textwrap
from collections.abc import Mapping, Sequence

import numpy as np

from thirdbody.figures.claims import score_of
from thirdbody.figures.drawing import ONE_COLUMN, Drawing, empty_panels
from thirdbody.figures.panels import CURVE, Panel, Series
from thirdbody.typeset import mathtext

COLUMNS = 2
CELL = ONE_COLUMN, 2.6  # of a panel with its labels [inches]
LETTERS = 44  # in a line of a title
DISTANCES = (0, 0.5, 1, 2, 5, 20)  # ticks, in tolerances
ABOVE = 25.0  # the objective is drawn up to this much above the least
FIRST, OTHERS = {"linewidth": 1.6, "zorder": 3}, {"linewidth": 0.9, "zorder": 2}


def plot(interpretations: Sequence[Mapping], sentences: Mapping[str, str]) -> Drawing:
    """The front of each headline statement against all others, one line per interpretation.

    ``interpretations`` are the contents of calibrated files, the first of which is drawn on top;
    ``sentences`` has the statements by id.
    """
    statements = list(dict.fromkeys(name for each in interpretations for name in each["fronts"]))
    panels = []
    for statement in statements:
        title = mathtext(textwrap.fill(sentences[statement], LETTERS))
        series = tuple(_front(each, statement) for each in interpretations)
        panels.append(Panel(title, "score", "objective_without_it", series))
    columns = min(COLUMNS, len(panels))
    rows = math.ceil(len(panels) / COLUMNS)
    figure = empty_panels(panels, (columns * CELL[0], rows * CELL[1]), columns)
    for axes, panel in zip(figure.axes, panels, strict=True):
        for front in panel.series:
            look = FIRST if front is panel.series[0] else OTHERS
            axes.plot(front.x, front.y, drawstyle="steps-post", label=front.name, **look)
        axes.axvline(1.0, color="black", linewidth=0.7, zorder=1.5)
        axes.set_xticks([score_of(each) for each in DISTANCES], DISTANCES)
        drawn = np.concatenate([front.y for front in panel.series])
        highest = min(drawn.max(), drawn.min() + ABOVE)
        axes.set(xlim=(-0.05, score_of(DISTANCES[-1])), ylim=(drawn.min() - 1.0, highest + 1.0))
        axes.set(xlabel="Deviation in tolerances", ylabel="Objective of all other statements")
    if len(interpretations) > 1:
        figure.axes[0].legend(title="Interpretation")
    return figure


def _front(interpretation, statement) -> Series:
    """The front of one statement, extended to the largest distance."""
    front = np.array(interpretation["fronts"].get(statement, ())).reshape(-1, 2)
    if front.size:
        front = np.vstack([front, [score_of(DISTANCES[-1]), front[-1, 1]]])
    return Series(CURVE, interpretation["interpretation"], *front.T)
