"""The key of a figure: groups of entries, each in columns of its own."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

from matplotlib.figure import Figure
from matplotlib.legend_handler import HandlerLine2D
from matplotlib.lines import Line2D

from thirdbody.symbols import mathtext

ROWS_BESIDE = 12  # of a key in the free cell beside the last panel
HEIGHT, LINE = 0.55, 0.16  # of a key below the panels without lines, and of its lines [inches]
LETTERS, HANDLE = 112, 9  # letters across a figure; as wide as the handle of an entry

Groups = Sequence[Sequence[Mapping[str, Any]]]


def key_columns(groups: Groups) -> list[list[Mapping[str, Any]]]:
    """The columns of the lowest key that is no wider than a figure.  Groups have columns of their
    own, unless only one column fits."""
    count = sum(map(len, groups))
    for rows in range(1, count + 1):
        columns = [column for group in groups for column in _split(group, rows)]
        widths = [max(len(each["label"]) for each in column) + HANDLE for column in columns]
        if sum(widths) <= LETTERS:
            return [[*column] for column in columns]
    return [[each for group in groups for each in group]]


def _split(group, rows) -> list[Sequence[Mapping[str, Any]]]:
    """The columns of a group, of at most ``rows`` entries and about equally long."""
    count = math.ceil(len(group) / rows)
    length = math.ceil(len(group) / count)
    return [group[i : i + length] for i in range(0, len(group), length)]


def key_height(groups: Groups) -> float:
    """The height of a key below the panels [inches]."""
    return HEIGHT + LINE * max(map(len, key_columns(groups)))


def is_beside(groups: Groups) -> bool:
    """Whether a key fits into one cell of two columns."""
    return sum(map(len, groups)) <= ROWS_BESIDE


def handle(look: Mapping[str, Any]) -> Line2D:
    """The line of an entry."""
    return Line2D([], [], **{**look, "label": mathtext(look["label"])})


def add_key(
    figure: Figure, groups: Groups, title: str, common: Sequence[str], beside: bool
) -> None:
    """Add a key with a title and the conditions of all curves, below the panels or in the free cell
    ``beside`` the last panel."""
    columns = [[each for group in groups for each in group]] if beside else key_columns(groups)
    most = max(map(len, columns))
    blank = {"linestyle": "none", "label": " "}
    lines = [handle(each) for column in columns for each in column + [blank] * (most - len(column))]
    place: dict[str, Any] = {"loc": "outside lower center", "ncols": len(columns)}
    if beside:
        cell = 0.5, 0.0, 0.5, 2.0 / (len(figure.axes) + 1)
        place = {"loc": "center right", "bbox_to_anchor": cell}
    text = mathtext("\n".join(filter(None, (title, ", ".join(common)))))
    ends = {each: HandlerLine2D(numpoints=2) for each in lines if each.get_marker() == "|"}
    figure.legend(handles=lines, title=text or None, alignment="left", handler_map=ends, **place)
