"""Pareto fronts: the cost of each headline statement to all others, for every interpretation."""

import math
import textwrap
from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib import rcParams

from thirdbody.figures.claims import score_of
from thirdbody.figures.drawing import CURVE, Drawing, Panel, Series, empty_panels

COLUMNS = 3
CELL = 2.4, 1.55  # of a panel with its labels [inches]
LETTERS = 30  # in a line of a title
DISTANCES = (0, 0.5, 1, 2, 5, 20)  # ticks, in tolerances
ABOVE = 25.0  # the objective is drawn up to this much above the least
FIRST, OTHERS = {"linewidth": 1.6, "zorder": 3}, {"linewidth": 0.9, "zorder": 2}


def plot(interpretations: Sequence[Mapping]) -> Drawing:
    """The front of each headline statement against all others, one line per interpretation;
    ``interpretations`` are the contents of calibrated files, the first of which is drawn on top."""
    statements = list(dict.fromkeys(name for each in interpretations for name in each["fronts"]))
    panels = []
    for statement in statements:
        title = "\n".join(textwrap.wrap(statement, LETTERS))
        series = tuple(_front(each, statement) for each in interpretations)
        panels.append(Panel(title, "score", "objective_without_it", series))
    rows = math.ceil(len(statements) / COLUMNS)
    figure = empty_panels(panels, (COLUMNS * CELL[0], rows * CELL[1] + 0.5), COLUMNS)
    for axes, panel in zip(figure.axes, panels, strict=True):
        for front in panel.series:
            look = FIRST if front is panel.series[0] else OTHERS
            axes.plot(front.x, front.y, drawstyle="steps-post", label=front.name, **look)
        axes.axvline(1.0, color="black", linewidth=0.7, zorder=1.5)
        axes.set_xticks([score_of(each) for each in DISTANCES], DISTANCES)
        least = min(front.y.min() for front in panel.series if front.y.size)
        axes.set(xlim=(-0.05, score_of(DISTANCES[-1])), ylim=(least - 1.0, least + ABOVE))
    figure.supxlabel("deviation in tolerances", fontsize=rcParams["axes.labelsize"])
    figure.supylabel("objective of all other statements", fontsize=rcParams["axes.labelsize"])
    figure.legend(*axes.get_legend_handles_labels(), loc="outside upper center", ncols=2)
    return figure


def _front(interpretation, statement) -> Series:
    """The front of one statement, extended to the largest distance."""
    front = np.array(interpretation["fronts"].get(statement, ())).reshape(-1, 2)
    if front.size:
        front = np.vstack([front, [score_of(DISTANCES[-1]), front[-1, 1]]])
    return Series(CURVE, interpretation["interpretation"], *front.T)
