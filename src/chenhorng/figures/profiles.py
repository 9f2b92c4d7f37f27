"""Profiles of the objective: a quantity that the statements determine is a narrow valley."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import groupby

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from chenhorng.figures.captions import FIGURES
from thirdbody.plotting.drawing import TWO_COLUMNS, Drawing, empty_panels
from thirdbody.plotting.panels import CURVE, LINE, Panel, Series
from thirdbody.symbols import mathtext

SIZE = TWO_COLUMNS, 4.4  # inches
COLUMNS = 3
HIGHEST = 20.0  # of the axis, above the least objective [1]
LOGARITHMIC = "participation", "mean_square", "summit_parameter"
TOTAL = "total"  # how the interpretations with W of F_t begin
LOOKS = {False: {"color": "C0", "marker": "o"}, True: {"color": "C1", "marker": "s", "ls": "--"}}


def plot(rows: Sequence[Mapping], acceptance: float) -> Drawing:
    """The rise of the objective above its least over each quantity, from rows of the table
    ``profiles``, with the line up to which a set is acceptable, ``acceptance`` [1].

    The least is that of a panel, as searches end at different heights.
    """
    words = FIGURES["profiles"]
    panels, titles = [], words["panels"]
    for along in dict.fromkeys(row["along"] for row in rows):
        series = [*_series([row for row in rows if row["along"] == along])]
        panels.append(Panel(_title(titles[along], series[0], acceptance), along, "rise", series))
    figure = empty_panels(panels, SIZE, columns=COLUMNS)
    for axes, panel in zip(figure.axes, figure.panels, strict=True):
        _draw(axes, panel, acceptance)
        axes.set_xlabel(mathtext(words["axes"][panel.x]))
    for axes in figure.axes[::COLUMNS]:
        axes.set_ylabel(words["scale"])
    handles = figure.axes[0].get_legend_handles_labels()
    figure.legend(*handles, loc="outside lower center", ncols=len(handles[0]), handlelength=2.5)
    return figure


def acceptable_ends(x: NDArray, rise: NDArray, acceptance: float) -> tuple[float, float]:
    """The ends of the levels ``x``, increasing, between which the ``rise`` is at most
    ``acceptance`` [1], interpolated; the first or last level where the valley is open."""
    inside = np.flatnonzero(rise <= acceptance)
    if not inside.size:
        return (np.nan, np.nan)
    first, last = inside[[0, -1]]
    low, high = x[first], x[last]
    if first:
        low = np.interp(acceptance, rise[[first, first - 1]], x[[first, first - 1]])
    if last < len(x) - 1:
        high = np.interp(acceptance, rise[[last, last + 1]], x[[last, last + 1]])
    return float(low), float(high)


def _series(rows) -> Iterator[Series]:
    """The profile of each interpretation along a quantity; W of F_f first."""
    least = min(row["objective"] for row in rows)
    for name, group in groupby(rows, key=lambda row: row["interpretation"]):
        levels, objectives = np.array([[row["level"], row["objective"]] for row in group]).T
        look = LOOKS[name.startswith(TOTAL)]
        look = look | {"label": mathtext(FIGURES["profiles"]["loads"][name.startswith(TOTAL)])}
        yield Series(CURVE, name, levels, objectives - least, look=look, drawn_as=LINE)


def _title(text, series, acceptance) -> str:
    """The title of a panel: the acceptable levels, and whether the valley is open at an end."""
    low, high = acceptable_ends(series.x, series.y, acceptance)
    return text.format(f"{low:.2g}", f"{high:.2g}")


def _draw(axes: Axes, panel: Panel, acceptance: float) -> None:
    low, high = acceptable_ends(panel.series[0].x, panel.series[0].y, acceptance)
    if np.isfinite(low):
        axes.axvspan(low, high, color="C0", alpha=0.12, lw=0)
    words = FIGURES["profiles"]["acceptable"]
    axes.axhline(acceptance, color="0.3", lw=0.8, ls=":", label=words)
    for series in panel.series:
        axes.plot(series.x, series.y, markersize=3, **series.look)
    axes.set_ylim(-0.5, HIGHEST)
    if panel.x in LOGARITHMIC:
        axes.set_xscale("log")
        levels = panel.series[0].x[::2]
        axes.set_xticks(levels, [f"{level:g}" for level in levels])
        axes.minorticks_off()
