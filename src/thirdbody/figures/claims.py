"""The verdicts at a glance: one line a statement of the paper, grouped by where it stands."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from thirdbody.data.places import part_of_paper
from thirdbody.figures.drawing import CURVE, Drawing, Panel, Series

COLUMNS = 2
WIDTH = 9.2  # inches
LINE_INCHES = 0.115  # height of a statement's line
KEY_INCHES = 1.1  # of the key and the axis
GAP = 1.4  # lines between two groups
NO_SCORE = -0.35  # where a statement without a score stands
AGREEMENT = 0.75  # fraction of the ensemble from which a marker is filled
# verdict: colour of its marker; dark and light, so that grey tells hit and miss apart
COLOURS = {
    "holds": "C5",
    "fails": "C1",
    "not tested": "C3",
    "contradicted by the paper itself": "C4",
    "value withheld": "0.45",
}
MARKERS = {"calibration": "o", "validation": "D", "withheld": "x"}
DISTANCES = (0, 0.5, 1, 3, 10, 100, 1000)  # ticks, in tolerances


def score_of(distance: float) -> float:
    """The score of a ``distance`` in tolerances, as ``thirdbody.study.checks`` counts it."""
    return distance if distance <= 1.0 else 1.0 + math.log(distance)


LAST = score_of(DISTANCES[-1])  # scores beyond it are drawn here


def plot(rows: Sequence[Mapping]) -> Drawing:
    """The score of each statement of the paper, from rows of the table ``claims``.

    The colour is the verdict, the marker the role.  Hollow markers: the ensemble of inputs is
    divided.  Statements that do not hold are named.
    """
    columns = _columns(_groups(rows))
    lines = max(sum(map(_height, column.values())) for column in columns)
    size = WIDTH, lines * LINE_INCHES + KEY_INCHES
    figure = Figure(figsize=size, layout="constrained")
    panels = []
    for axes, letter, column in zip(figure.subplots(1, COLUMNS), "AB", columns, strict=True):
        placed = _placed(column)
        series = (
            Series(CURVE, row["id"], np.array([_score(row)]), np.array([line]))
            for line, row in placed
        )
        panels.append(Panel(letter, "", "score", "line", tuple(series)))
        _draw_groups(axes, column)
        for line, row in placed:
            _draw_statement(axes, line, row)
        _set_axes(axes, letter, lines)
    figure.legend(handles=_key(rows), loc="outside lower center", ncols=3)
    return Drawing(figure, tuple(panels))


def _groups(rows) -> dict:
    """Rows by the part of the paper that they belong to, in the order of the paper."""
    groups: dict[str, list] = {}
    for row in rows:
        groups.setdefault(part_of_paper(row["place"]), []).append(row)
    return groups


def _height(group) -> float:
    return len(group) + GAP


def _columns(groups: dict) -> list[dict]:
    """The groups in columns of about equal height, none divided."""
    height = sum(map(_height, groups.values())) / COLUMNS
    columns: list[dict] = [{} for _ in range(COLUMNS)]
    passed = 0.0
    for name, group in groups.items():
        middle = passed + 0.5 * _height(group)
        columns[min(int(middle / height), COLUMNS - 1)][name] = group
        passed += _height(group)
    return columns


def _placed(groups) -> list[tuple[float, Mapping]]:
    """Each row of the groups of a column with the line that it stands on."""
    placed, line = [], 0.5 * GAP
    for group in groups.values():
        placed += [(line + place + 0.5, row) for place, row in enumerate(group)]
        line += _height(group)
    return placed


def _draw_groups(axes, groups):
    """Shade every second group, and write beside each how many of its statements hold."""
    names, middles, start = [], [], 0.0
    for index, (name, group) in enumerate(groups.items()):
        end = start + _height(group)
        if index % 2 == 0:
            axes.axhspan(start, end, color="0.955", linewidth=0, zorder=0)
        verdicts = [row["verdict"] for row in group]
        held, judged = verdicts.count("holds"), verdicts.count("holds") + verdicts.count("fails")
        names.append(f"{name}\n{held} of {judged} hold")
        middles.append(0.5 * (start + end))
        start = end
    axes.set_yticks(middles, names)


def _score(row) -> float:
    """Where the marker of ``row`` stands."""
    missing = row["score"] is None or math.isnan(row["score"])
    return NO_SCORE if missing else min(row["score"], LAST)


def _draw_statement(axes: Axes, line: float, row: Mapping) -> None:
    """Line and marker of a statement, and its name where it does not hold."""
    score, colour = _score(row), COLOURS[row["verdict"]]
    axes.plot([0.0, max(score, 0.0)], [line, line], color=colour, linewidth=0.8, zorder=1)
    divided = row["ensemble_agree"] < AGREEMENT * row["ensemble_size"]
    face = "white" if divided else colour
    look = {"marker": MARKERS[row["role"]], "color": colour, "markerfacecolor": face}
    axes.plot(score, line, markeredgewidth=0.9, zorder=2, **look)
    if row["verdict"] in ("holds", "value withheld"):
        return
    behind = score < 0.5 * LAST
    axes.annotate(
        row["id"],
        (score, line),
        (4.0 if behind else -4.0, -0.3),
        textcoords="offset points",
        ha="left" if behind else "right",
        va="center",
        fontsize=6.5,
        bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.2, "alpha": 0.8},
        zorder=1.8,
    ).set_in_layout(False)


def _set_axes(axes, letter, lines):
    """The line up to which a statement holds, and ticks in tolerances."""
    axes.axvline(1.0, color="black", linewidth=0.8, zorder=1.5)
    axes.set(xlim=(2.0 * NO_SCORE, LAST - 2.0 * NO_SCORE), ylim=(lines, 0.0))
    axes.set_xticks([score_of(each) for each in DISTANCES], [*DISTANCES[:-1], "1000+"])
    axes.tick_params(axis="y", length=0)
    axes.set_xlabel("deviation in tolerances; logarithmic beyond 1")
    axes.set_title(f"({letter})", loc="left")


def _key(rows) -> list[Line2D]:
    """Verdicts by colour and roles by marker, each with its number of statements."""
    verdicts = [row["verdict"] for row in rows]
    roles = [row["role"] for row in rows]
    looks = [
        (f"{verdict} ({verdicts.count(verdict)})", {"color": colour, "marker": "s"})
        for verdict, colour in COLOURS.items()
        if verdict in verdicts
    ]
    looks += [
        (f"{role} ({roles.count(role)})", {"color": "black", "marker": marker})
        for role, marker in MARKERS.items()
        if role in roles
    ]
    hollow = {"color": "black", "markerfacecolor": "white", "marker": "o"}
    looks.append(("ensemble divided", hollow))
    return [Line2D([], [], label=text, linestyle="none", **look) for text, look in looks]
