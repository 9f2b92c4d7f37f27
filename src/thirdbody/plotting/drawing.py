"""A drawing: a figure with the data of its panels, and the files of both."""

import csv
import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from io import BytesIO
from itertools import zip_longest
from os import PathLike
from pathlib import Path
from string import ascii_uppercase
from typing import Any

import matplotlib.style
import numpy as np
from matplotlib.figure import Figure

from thirdbody.files import atomic_write
from thirdbody.paper.figures.captions import Caption
from thirdbody.paper.tables import DRAWN_POINTS, write_csv
from thirdbody.plotting.panels import CURVE, Panel, Series
from thirdbody.variables import AXES, VARIABLES

STYLE = Path(__file__).with_name("paper.mplstyle")
# without dates, so that files are reproducible
FORMATS = {
    "svg": {"metadata": {"Date": None}},
    "pdf": {"metadata": {"CreationDate": None}},
    "png": {"metadata": {"Software": None}, "pil_kwargs": {"compress_level": 1}},
}
SUFFIXES = tuple(f".{kind}" for kind in (*FORMATS, "csv", "md"))
ONE_COLUMN, TWO_COLUMNS = 84.0 / 25.4, 174.0 / 25.4  # widths of figures in journals [inches]
SI_UNITS = {name: each.unit for name, each in (AXES | VARIABLES).items()}


class Drawing(Figure):
    """A figure that notebooks display as a picture, with or without pyplot; ``panels`` has its content."""

    panels: Sequence[Panel] = ()

    def savefig(self, *given: Any, **options: Any) -> None:
        """Save the figure in its style, which also applies while it is drawn."""
        with matplotlib.style.context(STYLE, after_reset=True):
            super().savefig(*given, **options)

    def _repr_png_(self) -> bytes:
        picture = BytesIO()
        self.savefig(picture, format="png", dpi=120)
        return picture.getvalue()


def empty_panels(panels: Sequence[Panel], size: tuple[float, float], columns: int = 2) -> Drawing:
    """A figure of this ``size`` [inches] with axes for ``panels`` in rows, each below its title and, if there are
    several, its letter."""
    figure = Drawing(figsize=size, layout="constrained")
    figure.panels = [
        replace(panel, letter=ascii_uppercase[place]) for place, panel in enumerate(panels)
    ]
    rows = math.ceil(len(panels) / columns)
    for place, panel in enumerate(figure.panels, 1):
        axes = figure.add_subplot(rows, columns, place)
        letter = rf"$\bf{{({panel.letter})}}$  " if len(panels) > 1 else ""
        axes.set_title(letter + panel.title, loc="left", y=1.0)
    return figure


def save(drawing: Drawing, stem: str | PathLike, caption: Caption) -> None:
    """Write ``stem``.svg, with the alternative text as its title, .pdf, .png, the data drawn as .csv, and
    the caption as .md."""
    drawing.get_layout_engine().execute(drawing)
    drawing.set_layout_engine(None)  # once for all formats
    rows = [
        row for panel in drawing.panels for each in panel.series for row in _points(panel, each)
    ]
    for kind, options in FORMATS.items():
        title = {"Title": caption.alternative} if kind == "svg" else {}
        options = options | {"metadata": options["metadata"] | title}
        drawing.savefig(f"{stem}.{kind}", format=kind, **options)
    write_csv(f"{stem}.csv", rows, DRAWN_POINTS)
    Path(f"{stem}.md").write_text(caption.markdown(), encoding="utf-8")


def _points(panel: Panel, series: Series) -> Iterator[dict]:
    """Rows of the known points of a series."""
    kind = "" if series.kind == CURVE else series.kind
    curve = "; ".join(filter(None, (kind, series.name)))
    names = dict(panel=panel.letter, curve=curve, x_name=panel.x, y_name=panel.y)
    known = np.isfinite(series.x) & np.isfinite(series.y)
    for x, y in zip(series.x[known].tolist(), series.y[known].tolist(), strict=True):
        yield names | {"x": x, "y": y}


def save_figure(figure: Figure, path: str | PathLike) -> None:
    """Write a figure in the format of the suffix of its path, one of ``FORMATS``."""
    kind = Path(path).suffix.removeprefix(".")
    if kind not in FORMATS:
        raise ValueError(f"{path} ends with {kind!r}; allowed: {', '.join(FORMATS)}")
    with atomic_write(path) as part:
        figure.savefig(part, format=kind, **FORMATS[kind])


def write_wide(panels: Iterable[Panel], path: str | PathLike) -> None:
    """Write the curves of all panels side by side, for spreadsheets: a shared column x if the curves of a
    panel have the same x, and a column for each curve, with names and SI units in the headings."""
    columns = {}
    for panel in panels:
        curves = panel.of_kind(CURVE)
        is_shared = all(np.array_equal(curve.x, curves[0].x) for curve in curves)
        x, y = (
            f"{panel.letter}: {name} [{SI_UNITS.get(name, '1')}]" for name in (panel.x, panel.y)
        )
        for curve in curves:
            columns[x if is_shared else f"{x}, {curve.name}"] = curve.x
            columns[f"{y}, {curve.name}"] = curve.y
    texts = ([f"{v:.10g}" if np.isfinite(v) else "" for v in each] for each in columns.values())
    with open(path, "w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows(zip_longest(*texts, fillvalue=""))
