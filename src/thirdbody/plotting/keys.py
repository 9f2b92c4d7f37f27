"""The key of a figure: groups of entries, each in columns of its own."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

from matplotlib import rcParams
from matplotlib.figure import Figure
from matplotlib.legend_handler import HandlerLine2D
from matplotlib.lines import Line2D
from matplotlib.textpath import TextPath

from thirdbody.symbols import mathtext

ROWS_BESIDE = 12  # of a key in the free cell beside the last panel
MARGIN, LINE = 0.23, 0.16  # around a key below the panels, and of its lines [inches]
EDGE = 12.0  # of the figure, which a key leaves free on both sides together [points]

Groups = Sequence[Sequence[Mapping[str, Any]]]


def key_columns(groups: Groups, width: float) -> list[list[Mapping[str, Any]]]:
    """The columns of the lowest key that is no wider than a figure [inches].  Groups have columns
    of their own, unless only one column fits."""
    letter = rcParams["legend.fontsize"]
    line = letter * (rcParams["legend.handlelength"] + rcParams["legend.handletextpad"])
    between = letter * rcParams["legend.columnspacing"]
    wide = {each["label"]: text_width(each["label"], letter) for group in groups for each in group}
    for rows in range(1, len(wide) + 1):
        columns = [column for group in groups for column in _split(group, rows)]
        widths = [max(wide[each["label"]] for each in column) + line for column in columns]
        if sum(widths) + between * (len(widths) - 1) <= 72.0 * width - EDGE:
            return [[*column] for column in columns]
    return [[each for group in groups for each in group]]


def text_width(text, letter) -> float:
    """The width of a text with letters of this size [points]."""
    return float(TextPath((0.0, 0.0), mathtext(text), size=letter).get_extents().width)


def _split(group, rows) -> list[Sequence[Mapping[str, Any]]]:
    """The columns of a group, of at most ``rows`` entries and about equally long."""
    count = math.ceil(len(group) / rows)
    length = math.ceil(len(group) / count)
    return [group[i : i + length] for i in range(0, len(group), length)]


def key_title(title: str, common: Sequence[str], width: float) -> str:
    """The title of a key and the conditions of all curves, in lines no wider than a figure
    [inches]."""
    lines = [title] if title else []
    for place, each in enumerate(common):
        longer = f"{lines[-1]}, {each}" if place else ""
        if longer and text_width(longer, rcParams["legend.title_fontsize"]) <= 72.0 * width - EDGE:
            lines[-1] = longer
        else:
            lines.append(each)
    return "\n".join(lines)


def key_height(groups: Groups, title: str, width: float) -> float:
    """The height of a key below the panels [inches]."""
    rows = max(map(len, key_columns(groups, width)))
    return MARGIN + LINE * (len(title.splitlines()) + rows)


def is_beside(groups: Groups) -> bool:
    """Whether a key fits into one cell of two columns."""
    return sum(map(len, groups)) <= ROWS_BESIDE


def handle(look: Mapping[str, Any]) -> Line2D:
    """The line of an entry."""
    return Line2D([], [], **{**look, "label": mathtext(look["label"])})


def add_key(figure: Figure, groups: Groups, title: str, beside: bool) -> None:
    """Add a key with a title, below the panels or in the free cell ``beside`` the last panel."""
    width = figure.get_figwidth()
    columns = [[each for group in groups for each in group]]
    if not beside:
        columns = key_columns(groups, width)
    most = max(map(len, columns))
    blank = {"linestyle": "none", "label": " "}
    lines = [handle(each) for column in columns for each in column + [blank] * (most - len(column))]
    place: dict[str, Any] = {"loc": "outside lower center", "ncols": len(columns)}
    if beside:
        cell = 0.5, 0.0, 0.5, 2.0 / (len(figure.axes) + 1)
        place = {"loc": "center right", "bbox_to_anchor": cell}
    ends = {each: HandlerLine2D(numpoints=2) for each in lines if each.get_marker() == "|"}
    figure.legend(
        handles=lines, title=mathtext(title) or None, alignment="left", handler_map=ends, **place
    )
