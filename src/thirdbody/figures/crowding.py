"""What keeps a panel readable: levels written at their curves, and one mark where several would coincide."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from numpy.typing import NDArray

ROUNDS = 3  # loads at which levels are written
FEWEST = 2  # levels at one load
BESIDE, BELOW = 0.10, 0.055  # distances of texts, in widths and heights of a panel
NEAR = 0.03  # marks closer than this coincide, in widths and heights of a panel
BOX = {"facecolor": "white", "edgecolor": "none", "alpha": 0.75, "pad": 0.4}


def label_curves(
    axes: Axes, lines: Sequence[Line2D], texts: Sequence[str], marks: Sequence[Line2D] = ()
) -> None:
    """Write ``texts`` on ``lines`` over the same loads, where neighbours and ``marks`` are far enough."""
    if len(lines) <= FEWEST:
        return
    places = np.array([_in_axes(axes, line) for line in lines])  # [lines, loads, 2]
    inside = (places > 0.04) & (places < 0.96)
    free = set(range(len(lines)))
    written = [place for mark in marks for place in _in_axes(axes, mark)]
    for _ in range(ROUNDS):
        candidates = range(places.shape[1])
        chosen = max((_that_fit(places, inside, free, written, at) for at in candidates), key=len)
        if len(chosen) < FEWEST:
            return
        for line, at in chosen:
            style = {"color": lines[line].get_color(), "bbox": BOX, "ha": "center", "va": "center"}
            x, y = places[line, at]
            axes.text(x, y, texts[line], transform=axes.transAxes, fontsize=6, zorder=3.05, **style)
            written.append(places[line, at])
            free.remove(line)


def _that_fit(places, inside, free, written, at) -> list[tuple[int, int]]:
    """Lines, with the place ``at`` which their texts are apart from all curves' texts there, from the lowest on."""
    chosen, taken = [], list(written)
    for line in sorted(free, key=lambda line: places[line, at, 1]):
        place = places[line, at]
        others = np.delete(places[:, at, 1], line)
        clear = np.abs(others - place[1]).min() > 0.5 * BELOW
        if inside[line, at].all() and clear and _is_apart(place, taken, BESIDE, BELOW):
            chosen.append((line, at))
            taken.append(place)
    return chosen


def keep_apart(axes: Axes, marks: Sequence[Line2D]) -> None:
    """Drop points of ``marks`` that coincide with others of them."""
    kept = []
    for line in marks:
        stays = []
        for place in _in_axes(axes, line):
            stays.append(_is_apart(place, kept, NEAR, NEAR))
            kept += [place] if stays[-1] else []
        line.set_data(*(np.asarray(each)[stays] for each in line.get_data()))
        line.set_visible(any(stays))  # the layout takes an empty line for one at the corner


def _is_apart(place, others, width, height) -> bool:
    """Whether a place is beside, above or below all others."""
    return all(abs(place[0] - x) > width or abs(place[1] - y) > height for x, y in others)


def _in_axes(axes, line) -> NDArray:
    """The points of a line in widths and heights of the panel, shape (points, 2)."""
    to_axes = line.get_transform() + axes.transAxes.inverted()
    return to_axes.transform(np.column_stack(line.get_data()))
