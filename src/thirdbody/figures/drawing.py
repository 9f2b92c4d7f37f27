"""A drawing: a figure, the data that it shows panel by panel, and the files written of both."""

from __future__ import annotations

import csv
import math
from collections.abc import Iterable
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from thirdbody.data.conditions import Condition
from thirdbody.data.files import whole
from thirdbody.data.tables import DRAWN_POINTS

if TYPE_CHECKING:
    from thirdbody.figures.captions import Caption

STYLE = Path(__file__).with_name("paper.mplstyle")
# without dates, so that the same figure gives the same bytes
METADATA = {"svg": {"Date": None}, "pdf": {"CreationDate": None}, "png": {"Software": None}}
SUFFIXES = tuple(f".{kind}" for kind in (*METADATA, "csv", "md"))
CURVE = "curve"


@dataclass(frozen=True, eq=False)
class Series:
    """Points that a panel shows under one name.

    Attributes
    ----------
    kind : str
        ``CURVE``, or what else they are: "band", "turning points", "printed", ...
    name : str
        Whose they are; empty where the kind says enough.
    x, y : ndarray, shape (n,)
        The points, SI.
    condition : Condition, optional
        The condition of the curve that they belong to.
    """

    kind: str
    name: str
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    condition: Condition | None = None

    @property
    def label(self) -> str:
        """Name in the file of the drawn data."""
        if self.kind == CURVE:
            return self.name
        return f"{self.kind}; {self.name}" if self.name else self.kind


@dataclass(frozen=True, eq=False)
class Panel:
    """A panel: its letter and title, the names of the quantities on its axes, and what it shows."""

    letter: str
    title: str
    x: str
    y: str
    series: tuple[Series, ...]

    @property
    def is_over_sizes(self) -> bool:
        """Whether it shows turning points over x_a/σ."""
        return self.x == "diameter_ratio"

    def of_kind(self, kind: str) -> list[Series]:
        """The series of one kind."""
        return [one for one in self.series if one.kind == kind]


@dataclass(frozen=True)
class Drawing:
    """A figure and its panels, in the order of ``figure.axes``."""

    figure: Figure
    panels: tuple[Panel, ...]


def grid_of_axes(count: int, cell: tuple[float, float], columns: int = 2) -> Figure:
    """A figure with ``count`` axes in rows, each in a ``cell`` of this width and height [inches]."""
    rows = math.ceil(count / columns)
    figure = Figure(figsize=(columns * cell[0], rows * cell[1]), layout="constrained")
    for place in range(1, count + 1):
        figure.add_subplot(rows, columns, place)
    return figure


def title_axes(axes: Axes, panel: Panel) -> None:
    """Write the letter and the title of a panel above its axes."""
    axes.set_title(f"({panel.letter})  {panel.title}", loc="left")


def save(drawing: Drawing, stem: str | PathLike, caption: Caption) -> None:
    """Write ``stem``.svg, .pdf, .png, the data drawn as .csv, and the caption as .md.

    Raises
    ------
    OSError
        If there is no room or no right to write.
    """
    drawing.figure.draw_without_rendering()
    drawing.figure.set_layout_engine(None)  # once for all formats
    with whole(*(f"{stem}{suffix}" for suffix in SUFFIXES)) as (*images, data, text):
        for image, kind in zip(images, METADATA, strict=True):
            save_image(drawing.figure, image, kind)
        write_points(drawing.panels, data)
        Path(text).write_text(caption.markdown(), encoding="utf-8")


def save_image(figure: Figure, path: str | PathLike, kind: str) -> None:
    """Write a figure as one of ``METADATA``: the same figure gives the same bytes."""
    figure.savefig(path, format=kind, metadata=METADATA[kind])


def write_points(panels: Iterable[Panel], path: str | PathLike) -> None:
    """Write every point drawn as a row of ``DRAWN_POINTS``, in SI, with ten significant digits."""
    with open(path, "w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(column.name for column in DRAWN_POINTS)
        for panel in panels:
            for series in panel.series:
                known = np.isfinite(series.x) & np.isfinite(series.y)
                for x, y in zip(series.x[known], series.y[known], strict=True):
                    x_y = panel.x, f"{x:.10g}", panel.y, f"{y:.10g}"
                    writer.writerow((panel.letter, series.label, *x_y))
