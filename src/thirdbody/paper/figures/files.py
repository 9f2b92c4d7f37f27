"""The files of a figure: pictures, the points drawn, and the caption."""

import csv
from collections.abc import Iterable, Iterator
from itertools import zip_longest
from os import PathLike
from pathlib import Path

import numpy as np

from thirdbody.paper.figures.captions import Caption
from thirdbody.paper.tables import DRAWN_POINTS, write_csv
from thirdbody.plotting.drawing import FORMATS, Drawing
from thirdbody.plotting.panels import CURVE, UPRIGHT, Panel, Series
from thirdbody.variables import AXES, VARIABLES

SUFFIXES = tuple(f".{kind}" for kind in (*FORMATS, "csv", "md", "json"))
SI_UNITS = {name: each.unit for name, each in (AXES | VARIABLES).items()}
TOLERANCE = "tolerance"


def save(drawing: Drawing, stem: str | PathLike, caption: Caption) -> None:
    """Write ``stem``.svg, with the alternative text as its title, .pdf, .png, the data drawn as .csv, and
    the caption as .md and .json."""
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
    Path(f"{stem}.json").write_text(caption.record(), encoding="utf-8")


def _points(panel: Panel, series: Series) -> Iterator[dict]:
    """Rows of the known points of a series, then of both ends of its tolerance."""
    kind = "" if series.kind == CURVE else series.kind
    known = np.isfinite(series.x) & (np.isfinite(series.y) | (series.drawn_as == UPRIGHT))
    yield from _rows(panel, kind, series.name, series.x[known], series.y[known])
    if series.tolerance:
        yield from _rows(panel, TOLERANCE, series.name, *series.tolerance)


def _rows(panel, kind, name, x, y):
    curve = "; ".join(filter(None, (kind, name)))
    names = dict(panel=panel.letter, curve=curve, x_name=panel.x, y_name=panel.y)
    for one, other in zip(x.tolist(), y.tolist(), strict=True):
        yield names | {"x": one, "y": None if np.isnan(other) else other}


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
