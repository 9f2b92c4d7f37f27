"""Draw the verdicts: a bar for each figure of the paper, then the statements that do not hold."""

import textwrap
from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes

from chenhorng.figures.captions import FIGURES
from chenhorng.places import part_of_paper
from thirdbody.plotting.drawing import TWO_COLUMNS, Drawing
from thirdbody.plotting.panels import CURVE, Panel, Series
from thirdbody.symbols import mathtext

BAR_INCHES, LINE_INCHES = 0.21, 0.13  # heights of a bar and of a line of text
AROUND = 1.3  # height of titles, axis and key [inches]
LETTERS = 112  # in a line of text
GAP = 0.5  # between sentences, in lines
SIZE = 7.0  # of sentences [points]
# verdict: colour of its part of a bar; they differ in grey too
COLOURS = {
    "holds": "C5",
    "fails": "C1",
    "contradicted by the paper itself": "C4",
    "not tested": "0.8",
}


def plot(rows: Sequence[Mapping]) -> Drawing:
    """The number of statements with each verdict, a bar for each part of the paper, and the
    statements that do not hold, from rows of the table ``claims``."""
    parts = list(dict.fromkeys(part_of_paper(row["place"]) for row in rows))
    sentences = [(row, _sentence(row)) for row in rows if row["verdict"] != "holds"]
    lines = sum(len(each) + GAP for _, each in sentences)
    heights = BAR_INCHES * len(parts), LINE_INCHES * lines
    figure = Drawing(figsize=(TWO_COLUMNS, sum(heights) + AROUND), layout="constrained")
    bars, texts = figure.subplots(2, height_ratios=heights)
    figure.panels = [Panel("", "statements", "part", _draw_bars(bars, rows, parts), letter="A")]
    texts.set_title(FIGURES["claims"]["others"], loc="left")
    texts.set(xlim=(0.0, 1.0), ylim=(lines, 0.0))
    texts.set_axis_off()
    below = 0.0
    for row, each in sentences:
        texts.plot(0.008, below + 0.5, "s", color=COLOURS[row["verdict"]], clip_on=False)
        texts.text(0.025, below, mathtext("\n".join(each)), fontsize=SIZE, va="top")
        below += len(each) + GAP
    return figure


def _draw_bars(axes: Axes, rows: Sequence[Mapping], parts: Sequence[str]) -> list[Series]:
    """A bar of each part, with the number of statements of each verdict."""
    place = np.arange(len(parts))
    left = np.zeros(len(parts))
    series = []
    for verdict, colour in COLOURS.items():
        of_verdict = [part_of_paper(row["place"]) for row in rows if row["verdict"] == verdict]
        counts = np.array([of_verdict.count(part) for part in parts], float)
        label = f"{verdict} ({len(of_verdict)})"
        bars = axes.barh(place, counts, left=left, height=0.75, color=colour, label=label)
        texts = [f"{count:g}" if count else "" for count in counts]
        ink = "black" if verdict == "not tested" or colour == "C4" else "white"
        axes.bar_label(bars, texts, label_type="center", color=ink, fontsize=SIZE)
        series.append(Series(CURVE, verdict, counts, place.astype(float)))
        left += counts
    axes.set_title(FIGURES["claims"]["panel"].format(len(rows)), loc="left")
    axes.set_yticks(place, parts)
    axes.set(
        xlim=(0.0, left.max()), ylim=(len(parts) - 0.5, -0.5), xlabel=FIGURES["claims"]["scale"]
    )
    axes.tick_params(axis="y", length=0)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(loc="center right")
    return series


def _sentence(row) -> list[str]:
    """The lines of a statement with its place and verdict."""
    place = row["place"].partition(", section")[0]
    return textwrap.wrap(
        f"{place}, {row['verdict']}: {row['statement']}", LETTERS, break_on_hyphens=False
    )
