"""A drawing: a figure with the data of its panels, and its file."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from io import BytesIO
from os import PathLike
from pathlib import Path
from string import ascii_uppercase
from typing import Any

import matplotlib.style
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.gridspec import SubplotSpec

from thirdbody.curves import MOST_PANELS
from thirdbody.files import atomic_write
from thirdbody.plotting.panels import Panel
from thirdbody.symbols import mathtext

STYLE = Path(__file__).with_name("paper.mplstyle")
# without dates, so that files are reproducible
FORMATS: dict[str, dict[str, Any]] = {
    "svg": {"metadata": {"Date": None}},
    "pdf": {"metadata": {"CreationDate": None}},
    "png": {"metadata": {"Software": None}, "pil_kwargs": {"compress_level": 1}},
}
ONE_COLUMN, TWO_COLUMNS = 84.0 / 25.4, 174.0 / 25.4  # widths of figures in journals [inches]


class Drawing(Figure):
    """A figure that notebooks display as a picture, with or without pyplot; ``panels`` has its
    content.
    """

    panels: Sequence[Panel] = ()

    def __init__(self, *given: Any, **options: Any) -> None:
        super().__init__(*given, **options)
        FigureCanvasAgg(self)  # measures texts without a new renderer for each

    def savefig(self, *given: Any, **options: Any) -> None:
        """Save the figure in its style, which also applies while it is drawn."""
        with matplotlib.style.context(STYLE, after_reset=True):
            super().savefig(*given, **options)

    def _repr_png_(self) -> bytes:
        picture = BytesIO()
        self.savefig(picture, format="png", dpi=120)
        return picture.getvalue()


def empty_panels(
    panels: Sequence[Panel],
    size: tuple[float, float],
    columns: int = 2,
    rows: Sequence[str] = (),
) -> Drawing:
    """A figure of this ``size`` [inches] with axes for ``panels`` in rows.  Axes have titles, and
    letters if there are several panels.  ``rows`` have the letters of their panels, each as often
    as it is wide: "AABBB"."""
    if len(panels) > MOST_PANELS:
        raise ValueError(f"the figure has {len(panels)} panels; allowed: at most {MOST_PANELS}")
    figure = Drawing(figsize=size, layout="constrained")
    figure.panels = [
        replace(panel, letter=panel.letter or letter)
        for panel, letter in zip(panels, ascii_uppercase, strict=False)
    ]
    if rows:
        cells = _cells_of(rows, figure.add_gridspec(len(rows)))
    else:
        grid = figure.add_gridspec(math.ceil(len(panels) / columns), columns)
        cells = [grid[place] for place in range(len(panels))]
    for panel, cell in zip(figure.panels, cells, strict=True):
        axes = figure.add_subplot(cell)
        letter = rf"$\bf{{({panel.letter})}}$  " if len(panels) > 1 else ""
        axes.set_title(letter + mathtext(panel.title), loc="left", y=1.0)
    return figure


def _cells_of(rows, lines) -> list[SubplotSpec]:
    """The cells of panels in the order of their letters; lines are those of the figure."""
    cells: dict[str, SubplotSpec] = {}
    for place, row in enumerate(rows):
        letters = sorted({*row})
        grid = lines[place].subgridspec(1, len(letters), width_ratios=[*map(row.count, letters)])
        cells |= {letter: grid[column] for column, letter in enumerate(letters)}
    return [cells[letter] for letter in sorted(cells)]


def save_figure(figure: Figure, path: str | PathLike) -> None:
    """Write a figure in the format of the suffix; matplotlib refuses a format it cannot write."""
    kind = Path(path).suffix.removeprefix(".")
    with atomic_write(path) as (part,):
        write_figure(figure, part, kind, FORMATS.get(kind, {}))


def write_figure(
    figure: Figure, path: str | PathLike, kind: str, options: Mapping[str, Any]
) -> None:
    """Draw a figure in memory, then write it: matplotlib hides a full disk when it writes PDF."""
    drawn = BytesIO()
    figure.savefig(drawn, format=kind, **options)
    Path(path).write_bytes(drawn.getvalue())
