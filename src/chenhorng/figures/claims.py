"""Draw the verdicts: a bar for each part of the paper."""

from collections.abc import Mapping, Sequence

import numpy as np

from chenhorng.claims.words import COLOURS, counted_once, counts_by_part
from chenhorng.figures.captions import FIGURES
from thirdbody.plotting.drawing import TWO_COLUMNS, Drawing, empty_panels
from thirdbody.plotting.panels import CURVE, Panel, Series

BAR_INCHES = 0.21  # height of a bar
AROUND = 0.7  # height of title and axis [inches]
SIZE = 7.0  # of numbers in bars [points]
DARK = {COLOURS["holds"], COLOURS["fails"]}  # on which numbers are white


def plot(rows: Sequence[Mapping]) -> Drawing:
    """The number of statements with each verdict, a bar for each part of the paper, from rows of
    the table ``claims``."""
    by_part = counts_by_part(rows)
    place = np.arange(len(by_part))
    words = FIGURES["claims"]
    counts = {
        verdict: np.array([own[verdict] for own in by_part.values()], float) for verdict in COLOURS
    }
    series = [Series(CURVE, verdict, each, place.astype(float)) for verdict, each in counts.items()]
    held, tested = counted_once((row["cluster"] or row["id"], row["verdict"]) for row in rows)
    title = words["panel"].format(held=held, tested=tested, all=len(rows))
    panel = Panel(title, "statements", "part", series)
    size = TWO_COLUMNS, BAR_INCHES * len(by_part) + AROUND
    figure = empty_panels([panel], size, columns=1)
    (axes,) = figure.axes
    left = np.zeros(len(by_part))
    for verdict, each in counts.items():
        colour, label = COLOURS[verdict], f"{verdict} ({each.sum():g})"
        bars = axes.barh(place, each, left=left, height=0.75, color=colour, label=label)
        texts = [f"{count:g}" if count else "" for count in each]
        ink = "white" if colour in DARK else "black"
        axes.bar_label(bars, texts, label_type="center", color=ink, fontsize=SIZE)
        left += each
    axes.set_yticks(place, [*by_part])
    axes.set(xlim=(0.0, left.max()), ylim=(len(by_part) - 0.5, -0.5), xlabel=words["scale"])
    axes.tick_params(axis="y", length=0)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(loc="center right")
    return figure
