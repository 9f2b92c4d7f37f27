"""The files of a figure: pictures, the points drawn, and the caption."""

import csv
import json
from collections.abc import Iterable, Iterator
from dataclasses import asdict
from itertools import zip_longest
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from chenhorng.figures.captions import Caption
from chenhorng.figures.numbers import UPRIGHT, Number
from chenhorng.figures.printed import ALONG_X, COMPUTED, EVERY_LOAD, LOCUS, PRINTED
from chenhorng.tables import DRAWN_POINTS, write_csv
from thirdbody.plotting.drawing import FORMATS, Drawing, write_figure
from thirdbody.plotting.load_curves import is_hairline, ranges_drawn
from thirdbody.plotting.marks import TURNING_POINTS
from thirdbody.plotting.panels import CURVE, Panel, Series
from thirdbody.variables import AXES, VARIABLES

SUFFIXES = tuple(f".{kind}" for kind in (*FORMATS, "csv", "md", "json"))
SI_UNITS = {name: each.unit for name, each in (AXES | VARIABLES).items()}
TOLERANCE = "tolerance"
DIGITS = 5  # of the coordinates of printed numbers in a record


def save(drawing: Drawing, stem: str | PathLike, caption: Caption) -> None:
    """Write the pictures of ``stem``, the data drawn as .csv, the caption as .md, and the record of
    the figure as .json."""
    save_pictures(drawing, stem, caption)
    rows = [
        row for panel in drawing.panels for each in panel.series for row in _points(panel, each)
    ]
    write_csv(f"{stem}.csv", rows, DRAWN_POINTS)
    Path(f"{stem}.md").write_text(caption.markdown(), encoding="utf-8")
    record = json.dumps(figure_record(drawing.panels, caption), ensure_ascii=False, indent=1)
    Path(f"{stem}.json").write_text(record + "\n", encoding="utf-8")


def save_pictures(drawing: Drawing, stem: str | PathLike, caption: Caption) -> None:
    """Write ``stem``.svg, with the alternative text as its title, .pdf and .png."""
    if engine := drawing.get_layout_engine():
        engine.execute(drawing)
        drawing.set_layout_engine(None)  # once for all formats
    for kind, options in FORMATS.items():
        title = {"Title": caption.alternative} if kind == "svg" else {}
        options = options | {"metadata": options["metadata"] | title}
        write_figure(drawing, f"{stem}.{kind}", kind, options)


def figure_record(panels: Iterable[Panel], caption: Caption) -> dict[str, Any]:
    """What the index and the explorer need of a figure: its caption, and for each panel the
    conditions of its curves [SI], of those that are hairlines and of those with a range, and the
    numbers that the paper prints there."""
    further = {"heading": caption.heading, "panels": [*map(_panel_record, panels)]}
    return asdict(caption) | further


def _panel_record(panel):
    kinds = {series.kind for series in panel.series}
    curves = panel.of_kind(CURVE)
    return {
        "letter": panel.letter,
        "x": panel.x,
        "y": panel.y,
        "least": panel.least,
        "curves": _conditions(curves),
        "hairlines": _conditions(filter(is_hairline, curves)),
        "ranged": _conditions(ranges_drawn(panel)),
        "printed": [_mark(series) | _drawn(series) for series in panel.of_kind(PRINTED)],
        "limits": [_mark(series) for series in panel.of_kind(ALONG_X)],
        "levels": [_mark(series) for series in panel.of_kind(EVERY_LOAD)],
        "computed": [_at(series) for series in panel.of_kind(COMPUTED)],
        "turning_points": TURNING_POINTS in kinds,
        "locus": LOCUS in kinds,
    }


def _conditions(series):
    return [curve._asdict() for curve in dict.fromkeys(each.curve for each in series) if curve]


def _mark(series):
    """The printed number of a series: its first point, with its curve if it has one alone, both
    ends of its tolerance, and whether that is drawn; y is None for a number along x alone."""
    ends = [[_rounded(each) for each in point] for point in zip(*series.tolerance)]
    curve = series.curve and series.curve._asdict()
    further = {"curve": curve, "ends": ends, "is_tolerance_drawn": bool(series.tolerance_look)}
    return _at(series) | further


def _drawn(series):
    """Whether a printed point and its bar are drawn, or hidden by others that coincide."""
    point, bar = series.lines
    return {
        "is_point_drawn": point.get_markevery() == [True],
        "is_tolerance_drawn": bool(bar.get_visible()),
    }


def _at(series):
    return {"id": series.name, "at": [_rounded(each[0]) for each in (series.x, series.y)]}


def _rounded(number):
    return float(f"{number:.{DIGITS}g}") if np.isfinite(number) else None


def _points(panel: Panel, series: Series) -> Iterator[dict]:
    """Rows of the known points of a series, then of both ends of its tolerance."""
    kind = "" if series.kind == CURVE else series.kind
    known = np.isfinite(series.x) & (np.isfinite(series.y) | (series.drawn_as == UPRIGHT))
    yield from _rows(panel, kind, series.name, series.x[known], series.y[known])
    if isinstance(series, Number) and series.tolerance:
        yield from _rows(panel, TOLERANCE, series.name, *series.tolerance)


def _rows(panel, kind, name, x, y):
    curve = "; ".join(filter(None, (kind, name)))
    names = dict(panel=panel.letter, curve=curve, x_name=panel.x, y_name=panel.y)
    for one, other in zip(x.tolist(), y.tolist(), strict=True):
        yield names | {"x": one, "y": None if np.isnan(other) else other}


def write_wide(panels: Iterable[Panel], path: str | PathLike) -> None:
    """Write the curves of all panels side by side, for spreadsheets: a shared column x if the
    curves of a panel have the same x, and a column for each curve, with names and SI units in the
    headings."""
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
