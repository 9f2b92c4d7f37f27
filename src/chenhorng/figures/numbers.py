"""Draw the numbers that the paper prints, and computed limits."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from thirdbody.plotting.crowding import NAME_SIZE, NEAR, in_axes, keep_apart
from thirdbody.plotting.load_curves import curve_name
from thirdbody.plotting.panels import CURVE, Panel, Series

UPRIGHT = "upright"  # how a number along x alone is drawn
BAR = "_bar"  # label of the bar of a number, which has no entry in the key
SAME = 0.005  # numbers closer than this are one with more or fewer digits, in their size
LEVEL, LEVEL_PAD = 0.08, 12.5  # of brackets over each other: in heights of a panel, and in points
BRACKET_NAME = {"facecolor": "white", "edgecolor": "none", "pad": 1.0}  # on its line


@dataclass(frozen=True, eq=False)
class Number(Series):
    """A number at a point, at a level, or along x alone (``UPRIGHT``).  ``tolerance`` has x and y
    of both its ends; ``words`` stand at a range of two numbers along x.  Once a point is drawn,
    ``lines`` has it and its bar."""

    drawn_as: str = "number"
    tolerance: tuple[NDArray, NDArray] | None = None
    tolerance_look: Mapping[str, Any] = field(default_factory=dict)
    words: str = ""
    lines: list[Line2D] = field(default_factory=list)

    @property
    def labels(self) -> set[str]:
        return super().labels | {self.tolerance_look.get("label", "")}


def draw_numbers(axes: Axes, panel: Panel) -> None:
    """Draw points with bars and levels with strips, then vertical lines; equal lines once."""
    numbers = [series for series in panel.series if isinstance(series, Number)]
    for number in numbers:
        if number.tolerance and number.drawn_as != UPRIGHT:
            lines = axes.plot(number.x, number.y, **number.look)
            if number.x.size > 1:
                axes.fill_between(number.x, *number.tolerance[1], **number.tolerance_look)
            else:
                lines += axes.plot(*number.tolerance, label=BAR, **number.tolerance_look)
                number.lines[:] = lines
    names = {one.curve: curve_name(one) for one in panel.of_kind(CURVE)}
    drawn: list[Number] = []
    for number in numbers:
        if number.drawn_as == UPRIGHT and not any(_is_same(number, one) for one in drawn):
            drawn.append(number)
            for x in number.x:
                axes.axvline(x, **number.look)
            if number.tolerance and number.tolerance_look:
                axes.axvspan(*number.tolerance[0], **number.tolerance_look)
    ranges: dict[tuple, list[Number]] = {}
    for number in drawn:
        ranges.setdefault((number.name, number.curve), []).append(number)
    ends = {key: np.concatenate([each.x for each in own]) for key, own in ranges.items()}
    pairs = sorted((key for key in ends if ends[key].size == 2), key=lambda key: np.ptp(ends[key]))
    for level, key in enumerate(pairs, 1):
        one = ranges[key][0]
        words = f"{one.words} for {names[one.curve]}" if one.curve in names else one.words
        _draw_bracket(axes, ends[key], words, one.look["color"], level)
    if pairs:
        title = axes.get_title(loc="left")
        axes.set_title(title, loc="left", y=1.0, pad=LEVEL_PAD * (len(pairs) + 0.8))
    single = [one for one in drawn if (one.name, one.curve) not in pairs and one.curve in names]
    for place, number in enumerate(single):  # beside its strip, the first at its left
        low, high = number.tolerance[0] if number.tolerance else number.x.repeat(2)
        x, gap, side = (high, 2.0, "left") if place else (low, -2.0, "right")
        look = {"color": number.look["color"], "fontsize": NAME_SIZE, "ha": side}
        look |= {"xycoords": axes.get_xaxis_transform(), "textcoords": "offset points"}
        axes.annotate(names[number.curve], (x, 0.0), (gap, 5.0), **look)


def _draw_bracket(axes, ends, words, colour, level):
    """Draw a bracket above the panel over both ends of a range, with its name."""
    (low, high), height = np.sort(ends), 1.0 + LEVEL * level
    look = {"transform": axes.get_xaxis_transform(), "color": colour}
    places = [low, low, high, high], [1.0, height, height, 1.0]
    axes.plot(*places, linewidth=0.8, clip_on=False, **look)
    look |= {"fontsize": NAME_SIZE, "ha": "center", "va": "center"}
    axes.text(ends.mean(), height, words, bbox=BRACKET_NAME, **look)


def _is_same(number, other) -> bool:
    """Whether two vertical lines are of the same number, printed with more or fewer digits."""
    is_like = number.look.get("label") == other.look.get("label")
    return is_like and bool(np.isclose(number.x[0], other.x[0], rtol=SAME, atol=0.0))


def hide_coinciding(axes: Axes) -> None:
    """Hide points of numbers that coincide with others, and bars that are short, repeat others, or
    have no point that is shown."""
    pairs = [(point, bar) for point, bar in pairwise(axes.lines) if bar.get_label() == BAR]
    keep_apart(axes, [point for point, _ in pairs])
    shown = {_ends(point) for point, _ in pairs if point.get_markevery() == [True]}
    drawn = set()
    for point, bar in pairs:
        is_long = np.ptp(in_axes(axes, bar), axis=0).max() > NEAR
        bar.set_visible(is_long and _ends(point) in shown and _ends(bar) not in drawn)
        drawn.add(_ends(bar))


def _ends(line) -> tuple[float, ...]:
    return tuple(np.ravel(line.get_xydata()).tolist())
