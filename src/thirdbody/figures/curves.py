"""Figures of curves: the curves of a dataset, the content of panels, and how they are drawn."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Polygon
from numpy.typing import NDArray

from thirdbody.data.conditions import Condition, condition_key
from thirdbody.data.netcdf import PlainDataset
from thirdbody.data.quantities import curves_of
from thirdbody.figures import marks
from thirdbody.figures.drawing import CURVE, Drawing, Panel, Series, grid_of_axes
from thirdbody.figures.marks import AREA, RELATIVE_AREA
from thirdbody.figures.scales import SCALES, label, parameter_title, set_scales, shared_notes
from thirdbody.figures.styles import band_style, curve_styles, key_entries

BAND_STEP = 2  # every second load is enough for the edge of a range
KEY_COLUMNS = 5  # of a key below the panels
KEY_ROWS = 11  # of a key in the free cell beside the last panel
KEY_INCHES = 0.5, 0.17  # height of a key without entries, and of a row of entries
CELL = 3.5, 2.9  # of a panel with its labels [inches]
MARGINS = 0.68, 0.42, 0.48, 0.44
TITLE_PAD = 17.0  # points; newtons are below the title
TOLERANCE_LOOK = {"linewidth": 1.1, "zorder": 2.8}


@dataclass(frozen=True, eq=False)
class Curve:
    """One curve of a dataset: its ``condition``, and its ``place`` after the load axis; ``load``
    and ``peak_ratio`` of its turning point, if it has one; the ``reference`` of its area, dry
    two-body contact on the same surface, if it is in the dataset."""

    data: PlainDataset
    condition: Condition
    place: tuple[int, ...]
    turning_point: Mapping[str, float]
    reference: Curve | None = None

    @property
    def label(self) -> str:
        """Name in the file of the data drawn."""
        return label(self.condition)

    def has(self, name: str) -> bool:
        """Whether there are values of the quantity ``name`` along the curve."""
        stored = AREA if name == RELATIVE_AREA else name
        return stored in self.data and bool(np.isfinite(self.values(name)).any())

    def values(self, name: str) -> NDArray[np.float64]:
        """Values of the quantity ``name`` along the curve, shape (loads,)."""
        if name == RELATIVE_AREA:
            reference = self.reference.values(AREA) if self.reference else np.nan
            return self.values(AREA) / reference
        values = self.data[name].values
        return values if values.ndim == 1 else values[(slice(None), *self.place)]

    def at(self, name: str, load: float) -> float:
        """The quantity ``name`` at a ``load``, interpolated over ln load; or one of the two numbers
        of a panel of turning points, which do not depend on the load."""
        if name == "diameter_ratio":
            return self.condition.diameter_ratio
        if name == "turning_point_ratio":
            return self.turning_point["peak_ratio"]
        loads = np.log(self.values("load"))
        return float(np.interp(np.log(load), loads, self.values(name)))


def curves_in(data: PlainDataset, turning_points: Iterable[Mapping] = ()) -> list[Curve]:
    """The curves of ``data``, in the order of its axes; ``turning_points`` have the four conditions."""
    found = {
        condition_key(each[name] for name in Condition._fields): each for each in turning_points
    }
    conditions, shown = curves_of(data)
    curves = [
        Curve(data, Condition(*values), tuple(place), found.get(condition_key(values), {}))
        for values, place in zip(conditions.T.tolist(), np.argwhere(shown).tolist(), strict=True)
    ]
    references = {
        curve.condition.roughness: curve
        for curve in curves
        if curve.condition.is_dry and curve.condition.is_two_body
    }
    return [replace(curve, reference=references.get(curve.condition.roughness)) for curve in curves]


@dataclass(frozen=True)
class Content:
    """The content of a panel: a quantity ``y`` over ``x``, two of ``SCALES``.

    Over ``diameter_ratio`` only turning points are shown.  ``surface`` selects the smoothest (0) or
    the roughest (-1) surface of the dataset; ``locus`` joins the turning points of the curves.
    """

    y: str
    x: str = "load"
    surface: int | None = None
    locus: bool = False


@dataclass(frozen=True)
class CurveFigure:
    """A figure of curves that differ in one ``parameter`` of their ``Condition``: a row of the registry.

    Its panels show ``contents`` in order, or each of them for every roughness of the dataset.
    Two-body contact is one of the curves, or only the reference of areas.
    """

    parameter: str
    contents: tuple[Content, ...]
    each_surface: bool = False
    two_body: bool = True

    def plot(
        self,
        data: PlainDataset,
        turning_points: Sequence[Mapping] = (),
        ensemble_range: PlainDataset | None = None,
        printed: Sequence[Mapping] = (),
        windows: Sequence[Mapping] = (),
    ) -> Drawing:
        """Draw the figure; ``ValueError`` if ``data`` have no values for it.

        ``turning_points`` have the four conditions (SI), ``load`` and ``peak_ratio``; ``ensemble_range``
        has ``<variable>_low`` and ``_high`` on the axes of ``data``; ``printed`` and ``windows`` are rows
        of the tables ``printed``, those of this figure, and ``tpca_windows``.
        """
        curves = curves_in(data, turning_points)
        if not self.two_body:
            curves = [one for one in curves if not one.condition.is_two_body]
        # in the order of the key
        curves.sort(key=lambda c: (getattr(c.condition, self.parameter), c.condition.is_two_body))
        conditions = [curve.condition for curve in curves]
        common = shared_notes(conditions)
        panels: list[Panel] = []
        for content in self._contents(curves):
            chosen = curves
            if content.surface is not None:
                roughness = data["roughness"].values[content.surface]
                chosen = [one for one in curves if one.condition.roughness == roughness]
            if content.x == "diameter_ratio":
                series = tuple(_window_series(content, chosen, windows, printed))
            else:
                series = tuple(_curve_series(content, chosen, ensemble_range, printed))
            if series:
                shared = shared_notes([curve.condition for curve in chosen])
                own = ", ".join(text for text in shared if text not in common)
                title = own or SCALES[content.y].title
                panels.append(Panel(title, content.x, content.y, series))
        if not panels:
            names = ", ".join(dict.fromkeys(each.y for each in self.contents))
            raise ValueError(f"there is nothing to draw; allowed: points with {names}")
        styles = curve_styles(conditions, self.parameter, data.sizes["load"])
        newtons_per_load = None
        if "normal_load" in data:
            newtons_per_load = float(data["normal_load"].values[-1] / data["load"].values[-1])
        entries = key_entries(styles, self.parameter) + marks.mark_entries(panels)
        title = key_title(parameter_title(self.parameter), common)
        return draw_panels(panels, styles, newtons_per_load, entries, title)

    def _contents(self, curves) -> list[Content]:
        """The contents with values along ``curves``."""
        sizes = {each.condition.diameter_ratio for each in curves}
        contents = [
            each
            for each in self.contents
            if any(curve.has(each.x) and curve.has(each.y) for curve in curves)
            or (each.x == "diameter_ratio" and len(sizes) > 1)
        ]
        if not self.each_surface:
            return contents
        indices = range(curves[0].data.sizes["roughness"])
        return [replace(each, surface=index) for each in contents for index in indices]


def _curve_series(content, curves, ranges, printed) -> Iterator[Series]:
    """All series of a panel of curves."""
    x, y = content.x, content.y
    for curve in curves:
        yield Series(CURVE, curve.label, curve.values(x), curve.values(y), curve.condition)
    yield from marks.status_series(x, y, curves)
    if content.locus:
        yield from marks.turning_point_series(x, y, curves, marks.LOCUS)
    if content.locus or y == marks.RATIO:
        yield from marks.turning_point_series(x, y, curves, marks.TURNING_POINTS)
    yield from marks.printed_series(x, y, curves, printed)
    if ranges is not None and x == "load" and f"{y}_low" in ranges:
        for curve in curves:
            around = replace(curve, data=ranges)
            load, low, high = map(around.values, ("load", f"{y}_low", f"{y}_high"))
            some = np.unique([*range(0, load.size, BAND_STEP), load.size - 1])
            outline = range_outline(load[some], low[some], high[some])
            yield Series(marks.BAND, curve.label, *outline, curve.condition)


def range_outline(x, low, high):
    """The closed outline of a range where it is known: along its low and back along its high end."""
    known = np.isfinite(low) & np.isfinite(high)
    x, low, high = x[known], low[known], high[known]
    return np.concatenate([x, x[::-1], x[:1]]), np.concatenate([low, high[::-1], low[:1]])


def _window_series(content, curves, windows, printed) -> Iterator[Series]:
    """Turning points over x_a/σ on one surface, and the computed and printed ends of their range,
    which have no height: their ``y`` is 0."""
    yield from marks.turning_point_series(content.x, content.y, curves, marks.TURNING_POINTS)

    def is_here(row):
        return np.isclose(row["roughness_m"], curves[0].condition.roughness, rtol=1e-9)

    ends = np.array([row["diameter_over_roughness"] for row in windows if is_here(row)])
    ends = ends[np.isfinite(ends)]
    if ends.size:
        yield Series(marks.WINDOW, "", ends, np.zeros(ends.size))
    for row in printed:
        if row["quantity"].startswith("window") and is_here(row):
            mark = marks.Mark(row["value"], 0.0, (row["low"], row["high"]), "x")
            yield from mark.series(row["id"])


def draw_panels(
    panels: Sequence[Panel],
    styles: Mapping[Condition | str, dict],
    newtons_per_load: float | None = None,
    entries: Sequence[Line2D] = (),
    key_title: str = "",
) -> Drawing:
    """Draw panels of curves, and a legend in the free cell or below them.

    ``styles`` are line properties by the ``curve`` of a series.  With ``newtons_per_load``,
    F_t/F_t* [N], load axes also show newtons.
    """
    beside = len(panels) % 2 == 1
    rows = 0 if beside else -(-len(entries) // KEY_COLUMNS)
    below = KEY_INCHES[0] + KEY_INCHES[1] * rows if rows else 0.0
    figure = grid_of_axes(len(panels), CELL, MARGINS, below=below)
    for panel in panels:
        axes = figure.add_panel(panel, TITLE_PAD)
        for series in panel.series:
            _draw_series(axes, panel, series, styles.get(series.curve, {}))
        set_scales(axes, panel.x, panel.y, newtons_per_load)
    if entries:
        add_key(figure, entries, key_title, beside)
    return figure


def key_title(title: str, conditions: Sequence[str]) -> str:
    """Title of a legend, and below it the conditions common to all curves."""
    return "\n".join(filter(None, (title, ", ".join(conditions))))


def add_key(figure: Figure, entries: Sequence[Line2D], title: str, beside: bool) -> None:
    """Add a legend beside the last panel of a figure or below all panels."""
    if beside:
        height = figure.get_figheight()
        columns = -(-len(entries) // KEY_ROWS)
        place = {"loc": "center", "bbox_to_anchor": (0.76, 0.5 * CELL[1] / height)}
    else:
        columns = KEY_COLUMNS
        place = {"loc": "lower center", "bbox_to_anchor": (0.5, 0.0)}
    figure.legend(handles=entries, title=title or None, ncols=columns, **place)


def _draw_series(axes: Axes, panel: Panel, series: Series, style: dict) -> None:
    """Draw a series in the ``style`` of its curve; data without height as vertical lines and areas."""
    colour = {"color": style["color"]} if style else {}
    is_limit = panel.is_over_sizes and series.kind != marks.TURNING_POINTS
    if series.kind == CURVE:
        axes.plot(series.x, series.y, **style)
    elif series.kind == marks.BAND:
        # not `fill`, which updates the limits of the axes for each edge
        area = np.column_stack([series.x, series.y])
        axes.add_artist(Polygon(area, **band_style(style["color"])))
        axes.update_datalim(area)
    elif series.kind == marks.TOLERANCE and is_limit:
        axes.axvspan(*series.x, color="black", alpha=0.07, linewidth=0)
    elif series.kind == marks.TOLERANCE:
        axes.plot(series.x, series.y, **TOLERANCE_LOOK, **colour)
    elif is_limit:
        look = marks.PRINTED_LIMIT if series.kind == marks.PRINTED else marks.MARKS[series.kind]
        for end in series.x:
            axes.axvline(end, **look[1])
    else:
        look = marks.MARKS[series.kind][1]
        axes.plot(series.x, series.y, **(look | colour if series.kind == marks.PRINTED else look))
