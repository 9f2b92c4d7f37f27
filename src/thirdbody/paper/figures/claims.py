"""Overview of the verdicts: the statements of each figure in a row, missed ones in words."""

import math
import textwrap
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from matplotlib.lines import Line2D

from thirdbody.paper.places import part_of_paper
from thirdbody.paper.typeset import mathtext
from thirdbody.plotting.drawing import TWO_COLUMNS, Drawing
from thirdbody.plotting.panels import CURVE, Panel, Series

LINE_INCHES = 0.22  # height of a line, of which each has up to two of text
LETTERS = 76  # in a line of text
KEY_INCHES = 1.5  # of the title, the axis and the key
MARGIN = 0.35  # beside the least and the largest score
AGREEMENT = 0.75  # fraction of the ensemble from which a marker is filled
# verdict: colour of its marker; dark and light, so that they differ in grey
COLOURS = {
    "holds": "C5",
    "fails": "C1",
    "contradicted by the paper itself": "C4",
}
DISTANCES = (0, 0.5, 1, 3, 10, 100, 1000)  # ticks, in tolerances


def score_of(distance: float) -> float:
    """The score of a ``distance`` in tolerances, as in ``thirdbody.paper.claims.claim``."""
    return distance if distance <= 1.0 else 1.0 + math.log(distance)


LAST = score_of(DISTANCES[-1])  # larger scores are drawn here


class Line(NamedTuple):
    """A line of the figure: a part of the paper with the statements that hold, or one of the others, which
    has no marker if it is not tested."""

    text: str
    rows: Sequence[Mapping]
    is_part: bool


def plot(rows: Sequence[Mapping]) -> Drawing:
    """The score of each statement, from rows of the table ``claims``: those that hold on one line
    per figure of the paper, all others on separate lines below."""
    lines = _lines(rows)
    height = len(lines) * LINE_INCHES + KEY_INCHES
    figure = Drawing(figsize=(TWO_COLUMNS, height), layout="constrained")
    axes = figure.add_subplot()
    axes.set_title("Statements of the paper: those left of the line hold", loc="left")
    axes.set_yticks(range(len(lines)), [line.text for line in lines], fontsize=6)
    series = []
    for place, (line, text) in enumerate(zip(lines, axes.get_yticklabels(), strict=True)):
        if line.is_part:
            axes.axhspan(place - 0.5, place + 0.5, color="0.94", linewidth=0, zorder=0)
            text.set_fontweight("bold")
        for row in line.rows:
            score = min(row["score"], LAST)
            series.append(Series(CURVE, row["id"], np.array([score]), np.array([place])))
            look = {"color": COLOURS[row["verdict"]], "marker": "o" if _is_predicted(row) else "D"}
            if row["ensemble_agree"] < AGREEMENT * row["ensemble_size"]:
                look["markerfacecolor"] = "white"
            axes.plot(score, place, linestyle="none", zorder=2, **look)
    axes.axvline(1.0, color="black", linewidth=0.8, zorder=1.5)
    axes.set(xlim=(-MARGIN, LAST + MARGIN), ylim=(len(lines) - 0.5, -0.5))
    axes.set_xticks([score_of(each) for each in DISTANCES], [*DISTANCES[:-1], "1000+"])
    axes.tick_params(axis="y", length=0)
    axes.set_xlabel("Deviation in tolerances, logarithmic beyond 1")
    figure.legend(handles=_key(rows), loc="outside lower center", ncols=3)
    figure.panels = [Panel("", "score", "line", series, letter="A")]
    return figure


def _lines(rows) -> list[Line]:
    """The lines in the order of the paper."""
    parts: dict[str, list] = {}
    for row in rows:
        parts.setdefault(part_of_paper(row["place"]), []).append(row)
    lines = []
    for part, group in parts.items():
        verdicts = [row["verdict"] for row in group]
        held = verdicts.count("holds")
        judged = held + verdicts.count("fails")
        together = [row for row in group if row["verdict"] == "holds"]
        lines.append(Line(f"{part}: {held} of {judged} hold", together, is_part=True))
        others = [row for row in group if row["verdict"] != "holds"]
        for row in others:
            is_tested = row["verdict"] != "not tested"
            lines.append(Line(_sentence(row), [row] if is_tested else [], is_part=False))
    return lines


def _sentence(row) -> str:
    """A statement with its place, on at most two lines."""
    place = row["place"].partition(", section")[0]
    state = " (not tested)" if row["verdict"] == "not tested" else ""
    text = f"{place}{state}: {row['statement']}"
    lines = textwrap.wrap(text, LETTERS, max_lines=2, placeholder=" …", break_on_hyphens=False)
    return mathtext("\n".join(lines))


def _is_predicted(row) -> bool:
    """Whether a statement, if it is judged, holds when its figure is left out of the search for inputs."""
    return row["predicted"] != "fails"


def _key(rows) -> list[Line2D]:
    """Verdicts by colour with the number of statements, and the markers."""
    found = [row["verdict"] for row in rows]
    looks = {
        f"{verdict} ({found.count(verdict)})": {"color": colour, "marker": "s"}
        for verdict, colour in COLOURS.items()
        if verdict in found
    }
    count = sum(not _is_predicted(row) for row in rows)
    if count:
        looks[f"not predicted ({count})"] = {"color": "black", "marker": "D"}
    looks["ensemble divided"] = {"color": "black", "markerfacecolor": "white", "marker": "o"}
    return [Line2D([], [], label=text, linestyle="none", **look) for text, look in looks.items()]
