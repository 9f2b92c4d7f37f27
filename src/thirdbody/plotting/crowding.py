"""Keep a panel readable: write names at the ends of curves, hide marks that coincide."""

from collections.abc import Collection, Mapping, Sequence
from itertools import groupby

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.text import Text
from matplotlib.transforms import ScaledTranslation
from numpy.typing import NDArray

NEAR = 0.03  # marks closer than this coincide, in widths and heights of a panel
MOST_NAMES = 12  # of curves, written at their ends; a key has all
COINCIDE = 0.015  # ends closer than this have one name, in heights of a panel
NAME_SIZE, LINE = 7.0, 8.2  # of names, and the distance between them [points]
LEADER, GAP = 9.0, 7.0  # from the end of a curve to its name, and beyond the name [points]
MOST_ROOM = 0.6  # of names, in widths of a panel; longer ones are left to the key
TO_END = {"arrowstyle": "-", "color": "0.3", "linewidth": 0.4, "shrinkA": 0, "shrinkB": 0}
SEEN_APART = 0.8  # of lines [points]
SEVERAL = "0.25"  # colour of a name of several curves


def name_ends(
    axes: Axes,
    texts: Mapping[Line2D, str],
    dry: Collection[Line2D],
    hairlines: Mapping[Line2D, str],
) -> None:
    """Write ``texts`` beside the ends of their lines, within the frame, whose axis becomes longer
    by the width of the longest one.

    They stand on the side with more ends apart.  Lines that follow each other and coincide there
    share a name, but ``dry`` ones not with others;
    ``hairlines`` have a name where there is room.  The axes have their place in the figure."""
    right, left = (_groups(axes, texts, end, dry) for end in (-1, 0))
    at_left = len(left) > len(right)
    groups = left if at_left else right
    if not 1 < len(groups) <= MOST_NAMES:
        return
    points = 72.0 / axes.figure.dpi
    frame = axes.get_window_extent()
    line = LINE / (frame.height * points)
    for group in _groups(axes, hairlines, 0 if at_left else -1, dry):
        taken = [height for other in groups for *_, height in other]
        if all(abs(group[0][2] - height) > line for height in taken):
            groups.append(group)
    groups.sort(key=lambda group: np.mean([height for *_, height in group]))
    ends = [float(np.mean([height for *_, height in group])) for group in groups]
    all_dry = {*dry} & {*texts}
    compares_media = 0 < len(all_dry) < len(texts)
    texts = {**texts, **hairlines}
    names = []
    for group, end, height in zip(groups, ends, _spread(ends, line), strict=True):
        colours = {line.get_color() for line, *_ in group}
        is_dry = group[0][0] in dry
        if colours == {"black"} and not is_dry:  # black names are of dry contact
            colours = {SEVERAL}
        own = list(dict.fromkeys(texts[line] for line, *_ in group))
        text = ", ".join(own) if len(own) < 3 else f"{own[0]} … {own[-1]}"
        if is_dry and compares_media and not text.startswith(("dry", "two-body")):
            text = "dry" if all_dry == {line for line, *_ in group} else f"dry {text}"
        name = axes.annotate(
            text,
            (group[0][1], end),
            (0.0 if at_left else 1.0, height),
            xycoords=axes.get_xaxis_transform(),
            color=colours.pop() if len(colours) == 1 else SEVERAL,
            fontsize=NAME_SIZE,
            ha="right" if at_left else "left",
            va="center",
            arrowprops=TO_END | {"relpos": (float(at_left), 0.5)},
        )
        names.append(name)
    widest = points * max(Text.get_window_extent(name).width for name in names)
    room = (LEADER + widest + GAP) / (frame.width * points)
    if room > MOST_ROOM:
        for name in names:
            name.remove()
        return
    side = 1.0 if at_left else -1.0  # from the edge of the frame, so that none crosses it
    shift = ScaledTranslation(side * (widest + GAP) / 72.0, 0.0, axes.figure.dpi_scale_trans)
    for name in names:
        name.set_anncoords(axes.transAxes + shift)
    scale = axes.xaxis.get_transform()
    limits = scale.transform(axes.get_xlim())
    limits[0 if at_left else 1] -= side * np.ptp(limits) * room / (1.0 - room)
    axes.set_xlim(*scale.inverted().transform(limits))


def _groups(axes, texts, end, dry) -> list[list[tuple[Line2D, float, float]]]:
    """Groups of lines whose ends coincide, from the lowest on, with x and height of the ends."""
    places = []
    for line in texts:
        points = line.get_xydata()
        known = points[np.isfinite(points).all(axis=1)]
        if len(known):
            height = axes.transAxes.inverted().transform(axes.transData.transform(known[end]))[1]
            places.append((line, known[end][0], float(height)))
    groups: list[list[tuple[Line2D, float, float]]] = []
    for place in sorted(places, key=lambda place: place[2]):
        for group in groups:
            is_near = place[2] - group[0][2] < COINCIDE
            if is_near and (place[0] in dry) == (group[0][0] in dry):
                group.append(place)
                break
        else:
            groups.append([place])
    return [run for group in groups for run in _runs(group, places, dry)]


def _runs(group, places, dry) -> list[list]:
    """A group in the order of the lines, apart where others of their medium lie between them."""
    of_medium = [place for place in places if (place[0] in dry) == (group[0][0] in dry)]
    return [[*run] for is_in, run in groupby(of_medium, group.__contains__) if is_in]


def _spread(heights, line) -> NDArray:
    """Move increasing heights apart by at least a ``line``, within the frame: the mean of pushing
    all up and pushing all down."""
    lines = line * np.arange(len(heights))
    apart = np.array(heights) - lines
    up, down = np.maximum.accumulate(apart), np.minimum.accumulate(apart[::-1])[::-1]
    low, high = 0.6 * line, 1.0 - 0.6 * line - lines[-1]
    return np.clip((up + down) / 2.0, low, max(low, high)) + lines


def keep_apart(axes: Axes, marks: Sequence[Line2D]) -> None:
    """Hide points of ``marks`` that coincide with earlier points."""
    kept: list[NDArray] = []
    for line in marks:
        stays = []
        for place in in_axes(axes, line):
            stays.append(all((np.abs(place - other) > NEAR).any() for other in kept))
            kept += [place] if stays[-1] else []
        line.set_markevery(stays)


def hide_repeats(axes: Axes, lines: Sequence[Line2D]) -> None:
    """Show one of several dashed ``lines`` that coincide: their dashes would fill the gaps."""
    nearest = SEEN_APART * axes.figure.dpi / 72.0
    before: list[NDArray] = []
    for line in lines:
        places = axes.transData.transform(line.get_xydata())
        repeats = [np.hypot(*(places - other).T) < nearest for other in before]
        line.set_ydata(np.where(np.any(repeats, axis=0), np.nan, line.get_ydata()))
        before.append(places)


def in_axes(axes: Axes, line: Line2D) -> NDArray:
    """The points of a line in widths and heights of the panel, shape (points, 2)."""
    to_axes = line.get_transform() + axes.transAxes.inverted()
    return to_axes.transform(np.column_stack(line.get_data()))
