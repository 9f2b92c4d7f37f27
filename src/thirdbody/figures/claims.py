"""The verdicts at a glance: one line a statement of the paper, grouped by where it stands."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib import rcParams
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from thirdbody.data.places import part_of_paper
from thirdbody.figures.sheet.panel import FURNITURE, POINTS_PER_INCH, NamedPoints, Panel

COLUMNS = 2
WIDTH = 7.0  # inches
LINE_POINTS = 5.2  # height of a statement's line
GAP = 1.4  # lines between two groups
MARGINS = {"top": 0.3, "bottom": 1.12, "left": 0.78, "right": 0.08}  # inches
NAME_SIZE = 4.6  # of the names of statements that do not hold, points
LETTER_WIDTH = 0.55  # of the size of type
NO_SCORE = -0.35  # where a statement without a score is put
AGREEMENT = 0.75  # share of the ensemble from which a marker is filled
# verdict: colour of its marker; dark and light, so that grey tells hit and miss apart
COLOURS = {
    "holds": "C5",
    "fails": "C1",
    "not tested": "C3",
    "contradicted by the paper itself": "C4",
}
# marker by the verdict when the figure of a statement is left out of the search
MARKERS = {"holds": "o", "": "o"}
OTHER_MARKER = "D"
# distance from the paper in tolerances; a score is that up to 1, and 1 + ln(distance) beyond
DISTANCES = (0, 0.5, 1, 3, 10, 100, 1000)
PREFIX = re.compile(r"fig0?(\d+)|conclusion|abstract-")  # of the statements' ids, before a panel


def plot(rows: Sequence[Mapping]) -> Figure:
    """The score of each statement of the paper.

    Parameters
    ----------
    rows : sequence of Mapping
        Rows of the table ``claims``.

    Notes
    -----
    The colour is the verdict; a diamond is a statement that does not hold when its figure is left out
    of the search for inputs; a hollow marker is one on which the ensemble of inputs is divided.
    Statements that do not hold are named.
    """
    columns = _halves(_groups(rows))
    lines = max(sum(_height(group) for group in column.values()) for column in columns)
    height = MARGINS["top"] + MARGINS["bottom"] + lines * LINE_POINTS / POINTS_PER_INCH
    figure = Figure(figsize=(WIDTH, height))
    for index, column in enumerate(columns):
        panel = _panel(figure, index, lines)
        _draw_groups(panel, column)
        _frame(panel, lines)
    _draw_key(figure, rows)
    return figure


def score_of(distance: float) -> float:
    """The score of a ``distance`` in tolerances, as ``thirdbody.study.checks`` counts it."""
    return distance if distance <= 1.0 else 1.0 + math.log(distance)


LAST = score_of(DISTANCES[-1])  # scores beyond it, and missing evidence, are drawn here


def _groups(rows) -> dict:
    """Rows by the part of the paper that they belong to, in the order of the paper."""
    groups: dict[str, list] = {}
    for row in rows:
        groups.setdefault(part_of_paper(row["place"]), []).append(row)
    return groups


def _height(group) -> float:
    return len(group) + GAP


def _halves(groups: dict) -> list[dict]:
    """The groups in ``COLUMNS`` columns of about equal height, none divided."""
    share = sum(map(_height, groups.values())) / COLUMNS
    columns = [{} for _ in range(COLUMNS)]
    passed = 0.0
    for name, group in groups.items():
        middle = passed + 0.5 * _height(group)
        columns[min(int(middle / share), COLUMNS - 1)][name] = group
        passed += _height(group)
    return columns


def _panel(figure, index, lines) -> Panel:
    width, height = figure.get_size_inches()
    column = width / COLUMNS
    box = (
        (index * column + MARGINS["left"]) / width,
        MARGINS["bottom"] / height,
        (column - MARGINS["left"] - MARGINS["right"]) / width,
        lines * LINE_POINTS / POINTS_PER_INCH / height,
    )
    panel = Panel(figure, box, "AB"[index], "score", "line")
    figure.add_axes(panel)
    panel.set_xlim(2.0 * NO_SCORE, LAST - 2.0 * NO_SCORE)
    panel.set_ylim(lines, 0.0)
    return panel


def _draw_groups(panel, groups):
    """The statements of each group on lines of their own, beside the count of those that hold."""
    line = 0.5 * GAP
    drawn = []
    for index, (name, group) in enumerate(groups.items()):
        end = line + len(group)
        if index % 2 == 0:
            shade = {"color": "0.955", "linewidth": 0, "zorder": 0, "label": FURNITURE}
            panel.axhspan(line - 0.5 * GAP, end + 0.5 * GAP, **shade)
        judged = [row for row in group if row["verdict"] in ("holds", "fails")]
        held = sum(row["verdict"] == "holds" for row in judged)
        text = f"{name}\n{held} of {len(judged)} hold"
        style = {"ha": "right", "va": "center", "fontsize": 6.5, "linespacing": 1.25}
        panel.text(-0.02, 0.5 * (line + end), text, transform=panel.get_yaxis_transform(), **style)
        drawn += [(_score(row), line + place + 0.5, row) for place, row in enumerate(group)]
        line = end + GAP
    _draw_statements(panel, drawn)


def _score(row) -> float:
    """Where the marker of ``row`` stands."""
    missing = row["score"] is None or math.isnan(row["score"])
    return NO_SCORE if missing else min(row["score"], LAST)


def _draw_statements(panel, drawn):
    """Markers at the scores of ``drawn``, triples of score, line and row; a statement that does not
    hold is named beside its marker."""
    looks: dict[tuple, list] = {}
    for score, line, row in drawn:
        divided = row["ensemble_agree"] < AGREEMENT * row["ensemble_size"]
        colour = COLOURS[row["verdict"]]
        looks.setdefault((_marker(row), colour, divided), []).append((score, line, row))
        if row["verdict"] != "holds":
            _write_name(panel, score, line, row)
    size = {"markersize": 3.1, "markeredgewidth": 0.8, "zorder": 2}
    for (marker, colour, divided), alike in looks.items():
        scores, lines, rows = zip(*alike, strict=True)
        ends = np.maximum(scores, 0.0)
        panel.hlines(lines, 0.0, ends, color=colour, linewidth=0.6, label=FURNITURE, zorder=1)
        look = {"marker": marker, "color": colour, **size}
        look |= {"markerfacecolor": "white"} if divided else {}
        names = [row["id"] for row in rows]
        panel.add_line(NamedPoints(list(zip(scores, lines, strict=True)), names, **look))


def _marker(row) -> str:
    return MARKERS.get(row["predicted"] or "", OTHER_MARKER)


def _write_name(panel, score, line, row):
    """The id of ``row`` without its figure, behind the marker or, where that is too near the edge,
    before it."""
    prefix = PREFIX.match(row["id"])
    same = prefix and prefix[1] in (None, part_of_paper(row["place"]).split()[-1])
    name = row["id"][prefix.end() :].lstrip("-") if same else row["id"]
    left, right = panel.get_xlim()
    room = panel.bbox.width / panel.figure.dpi * POINTS_PER_INCH * (right - score) / (right - left)
    behind = len(name) * LETTER_WIDTH * NAME_SIZE < room or score < 0.5 * (left + right)
    panel.annotate(
        name,
        (score, line),
        (3.5 if behind else -3.5, -0.3),
        textcoords="offset points",
        ha="left" if behind else "right",
        va="center",
        fontsize=NAME_SIZE,
        bbox=None if behind else {"facecolor": "white", "edgecolor": "none", "pad": 0.2},
    )


def _frame(panel, lines):
    """The line up to which a statement holds, and ticks in tolerances."""
    panel.axvline(1.0, color="black", linewidth=0.7, label=FURNITURE, zorder=1.5)
    panel.xaxis.set_visible(True)
    panel.set_xticks([score_of(each) for each in DISTANCES], [*DISTANCES[:-1], "1000\nor more"])
    panel.tick_params(labelsize=6)
    panel.set_xlabel("deviation in tolerances; logarithmic beyond 1", fontsize=7)
    panel.write(0.0, 1.0, f"({panel.letter})", y_points=4, va="bottom")


def _draw_key(figure, rows):
    """Verdicts by colour, each with its number of statements, and the markers."""
    entries = [
        Line2D([], [], color=colour, marker="s", label=f"{verdict} ({count})")
        for verdict, colour in COLOURS.items()
        if (count := sum(row["verdict"] == verdict for row in rows))
    ]
    if count := sum(_marker(row) == OTHER_MARKER for row in rows):
        label = f"not predicted ({count})"
        entries.append(Line2D([], [], color="black", marker=OTHER_MARKER, label=label))
    hollow = {"color": "black", "markerfacecolor": "white", "marker": "o"}
    entries.append(Line2D([], [], label="ensemble divided", **hollow))
    for entry in entries:
        entry.set(linestyle="none", markersize=rcParams["lines.markersize"])
    figure.legend(handles=entries, loc="lower center", ncols=4, borderpad=0.5, fontsize=7)
