"""Whether the printed particle term can satisfy Figures 4, 6 and 11 together."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from thirdbody.figures.sheet.panel import FURNITURE, Panel

SIZE = (7.0, 4.1)  # inches
# axes of each panel as shares of the figure, and the names of what they show
PANELS = {
    "A": ((0.075, 0.2, 0.35, 0.74), ("mean_score_figures_4_and_6", "mean_score_figure_11")),
    "B": ((0.66, 0.2, 0.33, 0.74), ("share_that_holds", "reading")),
}
TOGETHER = ("Figure 4", "Figure 6")
AGAINST = "Figure 11"
DISTRIBUTIONS = {
    "uncentred": {"color": "C5", "marker": "o"},
    "centred": {"color": "C1", "marker": "s"},
    "gap_convolved": {"color": "C3", "marker": "^"},
}
FILLINGS = {"printed": "full", "free": "none"}
TERMS = {"printed": "p = 1, as printed", "free": "p free"}
AIM = 90.0  # per cent of the statements
DIGIT_SIZE = 4.2  # of markers that are numbers: size a digit, points
LIFTS = (-0.28, 0.0, 0.28)  # of Figures 4, 6 and 11 on the line of a reading
GUIDE = {"color": "0.55", "linewidth": 0.6, "linestyle": ":", "label": FURNITURE, "zorder": 0.5}


def plot(rows: Sequence[Mapping]) -> Figure:
    """Whether any reading can meet both sides of the conflict.

    Parameters
    ----------
    rows : sequence of Mapping
        Rows of the table ``conflict``.

    Notes
    -----
    A: mean score on Figures 4 and 6 against that on Figure 11, one point a member of each
    ensemble.  B: share of the statements of each figure that hold, at the best inputs of each
    reading, with its range over the ensemble.
    """
    readings: dict[str, list] = {}
    for row in rows:
        readings.setdefault(row["reading"], []).append(row)
    figure = Figure(figsize=SIZE)
    for letter, (box, names) in PANELS.items():
        figure.add_axes(Panel(figure, box, letter, *names))
    members, shares = figure.axes
    for place, some in enumerate(readings.values()):
        _draw_members(members, some)
        _draw_shares(shares, place, some)
    _frame_members(members)
    _frame_shares(shares, [_name(some[0]) for some in readings.values()])
    _draw_key(figure)
    return figure


def _name(row) -> str:
    sizes, term = row["size_distribution"].replace("_", "-"), TERMS[row["particle_term"]]
    return f"{sizes}, {row['summit_plane']}, {term.removesuffix(', as printed')}"


def _draw_members(panel, rows):
    """One point a member: its mean score on either side of the conflict."""
    scores: dict = {}
    for row in rows:
        sides = scores.setdefault(row["member"], ([], []))
        sides[row["part"] == AGAINST].append(row["score"])
    points = np.array([[np.mean(side) for side in sides] for sides in scores.values()])
    style = DISTRIBUTIONS[rows[0]["size_distribution"]] | {"linestyle": "none"}
    filling = {"fillstyle": FILLINGS[rows[0]["particle_term"]], "markeredgewidth": 0.6}
    panel.add_line(Line2D(*points.T, label=_name(rows[0]), **style, **filling))


def _draw_shares(panel, place, rows):
    """The number of each figure where its share is, on a line over the range of the ensemble."""
    colour = DISTRIBUTIONS[rows[0]["size_distribution"]]["color"]
    for part, lift in zip((*TOGETHER, AGAINST), LIFTS, strict=True):
        held: dict = {}
        for row in rows:
            if row["part"] == part:
                held.setdefault(row["member"], []).append(row["score"] <= 1.0)
        shares = [100.0 * np.mean(some) for some in held.values()]
        ends = min(shares), max(shares)
        panel.hlines(place + lift, *ends, color=colour, linewidth=0.8, label=FURNITURE, zorder=1)
        number = part.split()[-1]
        style = {"marker": f"$\\mathrm{{{number}}}$", "markersize": DIGIT_SIZE * len(number) ** 0.6}
        style |= {"color": "black", "markeredgewidth": 0.15, "linestyle": "none"}
        label = f"{_name(rows[0])}; {part}"
        panel.add_line(Line2D(shares[:1], [place + lift], label=label, **style))


def _frame_members(panel):
    panel.autoscale_view()
    panel.set(xlim=(0.0, None), ylim=(0.0, None))
    panel.locator_params(nbins=5)
    panel.axhline(1.0, **GUIDE)
    panel.axvline(1.0, **GUIDE)
    panel.xaxis.set_visible(True)
    panel.yaxis.set_visible(True)
    panel.set_xlabel("mean score, Figures 4 and 6")
    panel.set_ylabel("mean score, Figure 11")
    panel.add_title("Members of the ensembles")


def _frame_shares(panel, names):
    """``names`` of the readings, in pairs that differ in the particle term."""
    panel.set(xlim=(0.0, 103.0), ylim=(len(names) - 0.5, -0.5))
    panel.axvline(AIM, **GUIDE)
    for place in range(0, len(names), 4):
        shade = {"color": "0.955", "linewidth": 0, "zorder": 0, "label": FURNITURE}
        panel.axhspan(place - 0.5, place + 1.5, **shade)
    panel.xaxis.set_visible(True)
    panel.yaxis.set_visible(True)
    panel.set_yticks(range(len(names)), names)
    panel.tick_params(axis="y", length=0)
    panel.set_xlabel("statements that hold (%)")
    panel.add_title("Best inputs and range, by figure")


def _draw_key(figure):
    """Size distributions by colour and shape, the particle term by filling."""
    black = {"color": "black", "marker": "o"}
    entries = [(name.replace("_", "-"), style) for name, style in DISTRIBUTIONS.items()]
    entries += [(text, black | {"fillstyle": FILLINGS[term]}) for term, text in TERMS.items()]
    handles = [Line2D([], [], linestyle="none", label=text, **style) for text, style in entries]
    figure.legend(handles=handles, loc="lower center", ncols=len(handles), handlelength=1.0)
