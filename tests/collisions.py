"""Texts of a figure that are over an axis, a tick, a rule or another text, as they are drawn."""

from itertools import combinations

import numpy as np
from matplotlib.text import Text
from matplotlib.transforms import Bbox

NEAR = 0.3  # how far boxes of texts may overlap: less than the space around letters [points]


def collisions(figure):
    """Pairs of a text and what it is over, in words."""
    figure.draw_without_rendering()
    texts = [(text.get_text(), _box(text)) for text in _texts(figure)]
    pairs = [
        (text, f"text {other!r}")
        for (text, box), (other, second) in combinations(texts, 2)
        if box.overlaps(second)
    ]
    strokes = [stroke for axes in _all_axes(figure) for stroke in _strokes(axes)]
    pairs += [
        (text, words) for text, box in texts for words, stroke in strokes if box.overlaps(stroke)
    ]
    size = figure.bbox.padded(0.5)
    return pairs + [
        (text, "edge of the figure")
        for text, box in texts
        if not (size.contains(box.x0, box.y0) and size.contains(box.x1, box.y1))
    ]


def _texts(figure):
    """The texts that are seen."""
    texts = [text for text in figure.texts if text.get_visible()]
    for key in [*figure.legends, *(axes.get_legend() for axes in figure.axes)]:
        texts += [key.get_title(), *key.get_texts()] if key else []
    for axes in _all_axes(figure):
        texts += [axes.title, axes._left_title, axes._right_title, *axes.texts]
        for axis in (axes.xaxis, axes.yaxis):
            texts.append(axis.label)
            for tick in _ticks(axis):
                texts += [each for each in (tick.label1, tick.label2) if each.get_visible()]
    if figure._suptitle:
        texts.append(figure._suptitle)
    return [each for each in dict.fromkeys(texts) if each.get_visible() and each.get_text().strip()]


def _box(text):
    """The box of a text without the line from it to its curve, and without the space around."""
    box = Text.get_window_extent(text)
    return box.padded(-NEAR * text.figure.dpi / 72.0)


def _all_axes(figure):
    return [each for axes in figure.axes for each in (axes, *axes.child_axes)]


def _ticks(axis):
    """The ticks within the limits of an axis."""
    low, high = sorted(axis.get_view_interval())
    around = 1e-9 * (high - low)
    ticks = axis.get_major_ticks() + axis.get_minor_ticks()
    return [each for each in ticks if low - around <= each.get_loc() <= high + around]


def _strokes(axes):
    """Boxes of the edges, the ticks, and the upright and level lines of axes, with their names."""
    frame = axes.get_window_extent()
    for side, spine in axes.spines.items():
        if spine.get_visible() and axes.axison:
            ends = spine.get_transform().transform(spine.get_path().vertices)
            yield f"{side} edge", _around(ends)
    point = axes.figure.dpi / 72.0
    for name, axis in (("x", axes.xaxis), ("y", axes.yaxis)):
        inward = {"in": (0.0, 1.0), "out": (-1.0, 0.0), "inout": (-0.5, 0.5)}
        for tick in _ticks(axis):
            place = tick.tick1line.get_transform().transform(tick.tick1line.get_xydata())[0]
            for mark, edge, sign in ((tick.tick1line, 0, 1.0), (tick.tick2line, 1, -1.0)):
                if mark.get_visible() and mark.get_markersize() > 0.0:
                    across = (frame.y0, frame.y1) if name == "x" else (frame.x0, frame.x1)
                    length = sign * point * mark.get_markersize() * np.array(inward[tick._tickdir])
                    ends = across[edge] + length
                    along = place[0 if name == "x" else 1]
                    points = [(along, each) if name == "x" else (each, along) for each in ends]
                    yield f"tick of {name}", _around(points)
    for line in axes.lines:
        points = line.get_transform().transform(np.column_stack(line.get_data()))
        if line.get_visible() and len(points) == 2 and np.isclose(*points, atol=1e-6).any():
            is_mark = line.get_linestyle() == "None"
            if not is_mark and np.ptp(points, axis=0).max() > 0.9 * min(frame.width, frame.height):
                yield "line across the panel", _around(points)
    for patch in axes.patches:
        if patch.get_edgecolor()[3] > 0.0 and patch.get_linewidth() > 0.0:
            x0, y0, x1, y1 = patch.get_window_extent().extents
            for ends in ([(x0, y0), (x0, y1)], [(x1, y0), (x1, y1)]):
                yield "edge of a strip", _around(ends)


def _around(points):
    """The box of a stroke, at least a little wide, as boxes without area overlap nothing."""
    points = np.asarray(points, float)
    low, high = points.min(axis=0), points.max(axis=0)
    return Bbox([low - 0.1, high + 0.1])
