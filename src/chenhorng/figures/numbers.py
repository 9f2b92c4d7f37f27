"""Draw the numbers that the paper prints, and computed limits."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from thirdbody.plotting.crowding import NAME_SIZE, NEAR, in_axes, keep_apart
from thirdbody.plotting.load_curves import curve_name
from thirdbody.plotting.panels import CURVE, Panel, Series

UPRIGHT = "upright"  # how a number along x alone is drawn
BAR = "_bar"  # label of the bar of a number, which has no entry in the key
SAME = 0.005  # numbers closer than this are one with more or fewer digits, in their size
NAME_LOOK = {"fontsize": NAME_SIZE, "rotation": 90}  # of the name of a vertical line


@dataclass(frozen=True, eq=False)
class Number(Series):
    """A number at a point, at a level, or along x alone (``UPRIGHT``).  ``tolerance`` has x and y
    of both its ends."""

    drawn_as: str = "number"
    tolerance: tuple[NDArray, NDArray] | None = None
    tolerance_look: Mapping[str, Any] = field(default_factory=dict)

    @property
    def labels(self) -> set[str]:
        return super().labels | {self.tolerance_look.get("label", "")}


def draw_numbers(axes: Axes, panel: Panel) -> None:
    """Draw points with bars and levels with strips, then vertical lines; equal lines once."""
    numbers = [series for series in panel.series if isinstance(series, Number)]
    for number in numbers:
        if number.tolerance and number.drawn_as != UPRIGHT:
            axes.plot(number.x, number.y, **number.look)
            if number.x.size > 1:
                axes.fill_between(number.x, *number.tolerance[1], **number.tolerance_look)
            else:
                axes.plot(*number.tolerance, label=BAR, **number.tolerance_look)
    names = {one.curve: curve_name(one) for one in panel.of_kind(CURVE)}
    drawn: list[Number] = []
    for number in numbers:
        if number.drawn_as == UPRIGHT and not any(_is_same(number, one) for one in drawn):
            drawn.append(number)
            _draw_upright(axes, number, names.get(number.curve), panel.x == "load")


def _draw_upright(axes, number, name, is_low):
    """Draw vertical lines with a strip for the tolerance, and a name where fewer curves are."""
    for x in number.x:
        axes.axvline(x, **number.look)
    if not number.tolerance:
        return
    axes.axvspan(*number.tolerance[0], **number.tolerance_look)
    if name is not None:
        y = 0.02 if is_low else 0.98
        look = NAME_LOOK | {"color": number.look["color"]}
        look |= {"va": "bottom", "ha": "left"} if is_low else {"va": "top", "ha": "right"}
        look |= {"xycoords": axes.get_xaxis_transform(), "textcoords": "offset points"}
        x, gap = (number.tolerance[0][1], 2.0) if is_low else (number.x[0], -2.0)
        axes.annotate(name, (x, y), (gap, 0.0), **look)


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
