"""What keeps a panel readable: levels written at their curves, and one mark where several would coincide."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from numpy.typing import NDArray

ROUNDS = 5  # loads at which levels are written
FEWEST = 2  # levels at one load
BESIDE, BELOW = 0.10, 0.055  # distances of texts, in widths and heights of a panel
NEAR = 0.03  # marks closer than this coincide, in widths and heights of a panel
FROM_MARKER = 0.035  # of a text, in widths and heights of a panel
BOX = {"facecolor": "white", "edgecolor": "none", "alpha": 0.75, "pad": 0.4}
TEXT = {"fontsize": 6, "zorder": 3.05, "ha": "center", "va": "center", "bbox": BOX}
GREY_TEXT = "0.3"  # at grey curves


def label_curves(axes: Axes, texts: Mapping[Line2D, str], marks: Sequence[Line2D] = ()) -> None:
    """Write ``texts`` on their lines over the same loads, where neighbours, markers and ``marks`` are far
    enough."""
    if len(texts) <= FEWEST:
        return
    lines = list(texts)
    places = np.array([_in_axes(axes, line) for line in lines])  # [lines, loads, 2]
    margins = 0.02 + 0.01 * max(map(len, texts.values())), 0.04
    inside = (np.abs(places - 0.5) < 0.5 - np.array(margins)).all(axis=2)
    for line, own, there in zip(lines, places, inside, strict=True):
        if (every := line.get_markevery()) is not None:
            markers = own[every[0] :: every[1]]
            distances = np.abs(own[:, None] - markers).max(axis=2)
            there &= (
                np.fmin.reduce(distances, axis=1) > FROM_MARKER
            )  # where a curve has no value: nan
    free = set(range(len(lines)))
    written = [place for mark in marks for place in _in_axes(axes, mark)]
    for _ in range(ROUNDS):
        candidates = range(places.shape[1])
        chosen = max((_that_fit(places, inside, free, written, at) for at in candidates), key=len)
        if len(chosen) < FEWEST:
            return
        for line, at in chosen:
            colour = lines[line].get_color()
            style = TEXT | {"color": GREY_TEXT if isinstance(colour, str) else colour}
            axes.text(*places[line, at], texts[lines[line]], transform=axes.transAxes, **style)
            written.append(places[line, at])
            free.remove(line)


def _that_fit(places, inside, free, written, at) -> list[tuple[int, int]]:
    """Lines, with the place ``at`` which their texts are apart from all curves' texts there, from the lowest on."""
    chosen, taken = [], list(written)
    for line in sorted(free, key=lambda line: places[line, at, 1]):
        place = places[line, at]
        others = np.delete(places[:, at, 1], line)
        clear = np.fmin.reduce(np.abs(others - place[1])) > 0.5 * BELOW
        if inside[line, at] and clear and _is_apart(place, taken, BESIDE, BELOW):
            chosen.append((line, at))
            taken.append(place)
    return chosen


def keep_apart(axes: Axes, marks: Sequence[Line2D]) -> None:
    """Hide points of ``marks`` that coincide with others of them."""
    kept = []
    for line in marks:
        stays = []
        for place in _in_axes(axes, line):
            stays.append(_is_apart(place, kept, NEAR, NEAR))
            kept += [place] if stays[-1] else []
        line.set_markevery(stays)


def hide_bars(axes: Axes, pairs: Sequence[tuple[Line2D, Line2D]]) -> None:
    """Of pairs of a mark and a bar, hide bars that have no mark that is shown, repeat others or are short."""
    shown = {_points(mark) for mark, _ in pairs if mark.get_markevery() in (None, [True])}
    drawn = set()
    for mark, bar in pairs:
        is_long = np.ptp(_in_axes(axes, bar), axis=0).max() > NEAR
        bar.set_visible(is_long and _points(mark) in shown and _points(bar) not in drawn)
        drawn.add(_points(bar))


def _points(line) -> tuple[float, ...]:
    return tuple(np.ravel(line.get_xydata()).tolist())


def _is_apart(place, others, width, height) -> bool:
    """Whether a place is beside, above or below all others."""
    return all(abs(place[0] - x) > width or abs(place[1] - y) > height for x, y in others)


def _in_axes(axes, line) -> NDArray:
    """The points of a line in widths and heights of the panel, shape (points, 2)."""
    to_axes = line.get_transform() + axes.transAxes.inverted()
    return to_axes.transform(np.column_stack(line.get_data()))
