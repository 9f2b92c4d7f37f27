"""Figures of curves over the load, from any dataset."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import matplotlib
import numpy as np
from matplotlib import rcParams
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.legend_handler import HandlerLine2D
from matplotlib.lines import Line2D

from thirdbody.curves import Condition, condition_key, curves_of
from thirdbody.netcdf import PlainDataset
from thirdbody.plotting import marks
from thirdbody.plotting.axes import set_scales
from thirdbody.plotting.crowding import hide_bars, keep_apart, label_curves
from thirdbody.plotting.drawing import TWO_COLUMNS, empty_panels
from thirdbody.plotting.marks import AREA, RELATIVE_AREA
from thirdbody.plotting.panels import CURVE, LINE, UPRIGHT, Curve, Panel, Series
from thirdbody.plotting.scales import panel_title, parameter_title, shared_notes, value_text

MOST_RANGES = 3  # drawn in a panel; the file of the data drawn has all
KEY_COLUMNS = 5  # of a key below the panels
KEY_ROWS = 11  # of a key in the free cell beside the last panel
CELL_HEIGHT = 2.85  # of a panel with its labels [inches]
KEY_HEIGHT, KEY_LINE = 0.9, 0.16  # of a key below the panels, at least, and of its lines [inches]
KEY_LETTERS, HANDLE_LETTERS = 118, 10  # across a figure; as wide as the handle of an entry
MARKERS = "os^vPX>"  # every second one is hollow, so that neighbouring levels differ; diamonds are printed values
DARKEST, LIGHTEST = (
    0.05,
    0.59,
)  # of the colour map: two-body contact is darker, lighter is faint on white paper
GREY = "0.5"
BLUE = "#0072B2"  # of a single curve of an interface, or of the model
MARKERS_PER_CURVE = 5
# Dry curves are broad, grey and under the lubricated ones, which then are seen on them.
DRY = {"linestyle": "-", "linewidth": 2.6, "zorder": 1.8, "color": "0.6"}
DRY_TWO_BODY = {"linestyle": (0, (1.0, 1.3)), "linewidth": 2.4, "zorder": 1.7, "color": GREY}
DRY_GREYS = 0.45, 0.65  # of dry curves at the first and last of several levels


def curves_in(
    data: PlainDataset, turning_points: Iterable[Mapping] = (), ranges: PlainDataset | None = None
) -> list[Curve]:
    """The curves of ``data``, in the order of its axes, with their ``ranges``; ``turning_points`` have
    the four conditions.  Areas are also relative to dry two-body contact on the same surface."""
    found = {
        condition_key(each[name] for name in Condition._fields): each for each in turning_points
    }
    conditions, shown = curves_of(data)
    variables = {**data.variables, **(ranges.variables if ranges is not None else {})}
    over_load = {name: each.values for name, each in variables.items() if each.dims == ("load",)}
    columns = {
        name: each.values[:, shown].T for name, each in variables.items() if len(each.dims) > 1
    }
    curves, references = [], {}
    for place, values in enumerate(conditions.T.tolist()):
        condition, point = Condition(*values), found.get(condition_key(values), {})
        own = over_load | {name: rows[place] for name, rows in columns.items()}
        own["diameter_ratio"] = np.full_like(own["load"], condition.diameter_ratio)
        own["turning_point_ratio"] = np.full_like(own["load"], point.get("peak_ratio", np.nan))
        curves.append(Curve(condition, own, point))
        if condition.is_dry and condition.is_two_body and AREA in own:
            references[condition.roughness] = own[AREA]
    for curve in curves:
        if curve.condition.roughness in references:
            reference = references[curve.condition.roughness]
            curve.values[RELATIVE_AREA] = curve.values[AREA] / reference
    return curves


@dataclass(frozen=True)
class Content:
    """The content of a panel: a quantity ``y`` over ``x``, two of ``SCALES``.

    ``surface`` is the only one shown, 0 the smoothest and -1 the roughest; with ``locus`` a line joins the
    turning points; a logarithmic axis of a fraction begins at ``least``.
    """

    y: str
    x: str = "load"
    surface: int | None = None
    locus: bool = False
    least: float = 0.0


@dataclass(frozen=True)
class CurveFigure:
    """A figure of curves that differ in one ``parameter``.

    With ``each_surface``, each panel is drawn for every roughness.  Without ``two_body``, two-body contact is
    only the reference of areas.
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
        windows: Sequence[Mapping] = (),
        axes: Sequence[Axes] = (),
        further: Callable[[Content, Sequence[Curve]], Iterable[Series]] | None = None,
        mark_looks: Mapping[str, Mapping[str, Any]] = marks.LOOKS,
    ) -> Figure:
        """Draw the figure; ``ValueError`` if ``data`` have no values for it.

        ``turning_points`` have the four conditions (SI), ``load`` and ``peak_ratio``; ``ensemble_range``
        has ``<variable>_low`` and ``_high`` on the axes of ``data``; ``windows`` are rows of the table
        ``tpca_windows``.  With ``axes``, the panels are drawn there.  ``further`` gives further series of a
        panel from its content and curves; ``mark_looks`` are entries of the key, for marks that are drawn.
        """
        curves = curves_in(data, turning_points, ensemble_range)
        if not self.two_body:
            curves = [one for one in curves if not one.condition.is_two_body]
        # in the order of the key
        curves.sort(key=lambda c: (getattr(c.condition, self.parameter), c.condition.is_two_body))
        conditions = [curve.condition for curve in curves]
        looks = curve_styles(conditions, self.parameter, data.sizes["load"])
        curves = [replace(curve, look=looks[curve.condition]) for curve in curves]
        common = shared_notes(conditions)
        panels = []
        for content, chosen in self._chosen(curves, data["roughness"].values):
            if content.x == "diameter_ratio":
                series = [*_window_series(content, chosen, windows)]
            else:
                chosen = [one for one in chosen if one.has(content.x) and one.has(content.y)]
                series = [*_curve_series(content, chosen)]
            if further is not None:
                series += further(content, chosen)
            shared = shared_notes([curve.condition for curve in chosen])
            own = ", ".join(text for text in shared if text not in common)
            if series:
                panels.append(self._panel(content, series, own))
        newtons_per_load = None
        if "normal_load" in data:
            newtons_per_load = float(data["normal_load"].values[-1] / data["load"].values[-1])
        title = parameter_title(self.parameter)
        return draw_panels(
            panels, looks.values(), title, common, newtons_per_load, axes, mark_looks
        )

    def _chosen(self, curves, roughness) -> Iterator[tuple[Content, list[Curve]]]:
        """The content of each panel with its curves, those of one surface if it has one."""
        for content in self.contents:
            for surface in range(roughness.size) if self.each_surface else [content.surface]:
                on = roughness if surface is None else [roughness[surface]]
                yield content, [curve for curve in curves if curve.condition.roughness in on]

    def _panel(self, content, series, own) -> Panel:
        """A panel, whose title has what it shows if others show something else, and its ``own`` conditions."""
        several = len({(each.x, each.y) for each in self.contents}) > 1
        shown = panel_title(content.x, content.y) if several or not own else ""
        return Panel(
            title="\n".join(filter(None, (shown, own))),
            x=content.x,
            y=content.y,
            series=series,
            least=content.least,
            conditions=own,
        )


ALL_DRY = ("particle_contact_area_ratio", "total_contact_area")
LUBRICATED = (*ALL_DRY, "solid_load_fraction", "film_thickness")


def curve_figure(data: PlainDataset) -> CurveFigure:
    """The figure of any ``data``: areas over the load on each surface, also load fractions and film unless
    all curves are dry; ``ValueError`` if several conditions vary, beside dry and lubricated contact."""
    conditions = [curve.condition for curve in curves_in(data)]
    levels = {axis: {getattr(each, axis) for each in conditions} for axis in Condition._fields}
    absent = {"viscosity": set(), "particle_diameter": {0.0}, "particle_density": {0.0}}
    varying = [axis for axis, none in absent.items() if len(levels[axis] - none) > 1]
    if len(varying) > 1 and len(levels["viscosity"]) == 2 and 0.0 in levels["viscosity"]:
        varying.remove("viscosity")
    if len(varying) > 1:
        raise ValueError(
            f"{' and '.join(varying)} vary; allowed: one of them beside dry and lubricated "
            "contact, and any number of roughnesses"
        )
    contents = tuple(map(Content, ALL_DRY if levels["viscosity"] == {0.0} else LUBRICATED))
    surfaces = len(levels["roughness"])
    if not varying and surfaces > 1:
        return CurveFigure("roughness", contents)
    return CurveFigure(*varying or ["viscosity"], contents, surfaces > 1)


def _curve_series(content, curves) -> Iterator[Series]:
    """All series of a panel of curves."""
    x, y = content.x, content.y
    for curve in curves:
        yield Series(
            CURVE, curve.label, curve.values[x], curve.values[y], curve.condition, curve.look
        )
    yield from marks.status_series(x, y, curves)
    if content.locus:
        yield from marks.turning_point_series(x, y, curves, marks.LOCUS)
    if content.locus or y == marks.RATIO:
        yield from marks.turning_point_series(x, y, curves, marks.TURNING_POINTS)
    if y == marks.RATIO and x == "load":
        yield from marks.slight_series(x, y, curves)
    if x in ("load", "normal_load"):
        for curve in curves:
            yield from marks.range_of(curve, x, y)


def _window_series(content, curves, windows) -> Iterator[Series]:
    """Turning points over x_a/σ on one surface, and the computed ends of their range at y = 0."""
    yield from marks.turning_point_series(content.x, content.y, curves, marks.TURNING_POINTS)
    yield from marks.window_series(windows, curves[0].condition.roughness)


def draw_panels(
    panels: Sequence[Panel],
    looks: Iterable[Mapping[str, Any]],
    title: str = "",
    common: Sequence[str] = (),
    newtons_per_load: float | None = None,
    axes: Sequence[Axes] = (),
    mark_looks: Mapping[str, Mapping[str, Any]] = marks.LOOKS,
) -> Figure:
    """Draw panels of curves, and a key for ``looks`` with a label and for ``mark_looks`` of marks that are
    drawn; with ``newtons_per_load``, F_t/F_t* [N], load axes also show newtons.  With ``axes``, one for each panel, they are drawn there, and
    the key is in the last of them; otherwise on a new figure."""
    if not panels:
        raise ValueError("there is nothing to draw; allowed: points with values of the variables")
    labels = {series.look.get("label") for panel in panels for series in panel.series}
    looks = [*looks, *(look for look in mark_looks.values() if look.get("label") in labels)]
    entries = {
        look["label"]: Line2D([], [], **look)
        for look in looks
        if look.get("label", "_")[0] != "_"  # as matplotlib has it
    }
    if len(axes):
        for each, panel in zip(axes, panels, strict=True):
            _draw_panel(each, panel, newtons_per_load)
        if entries:
            axes[-1].legend(handles=list(entries.values()), title=title or None)
        return axes[0].figure
    rows, beside = math.ceil(len(panels) / 2), len(panels) % 2 == 1
    beside = beside and key_columns(entries, 0.5) * KEY_ROWS >= len(entries)
    lines = math.ceil(len(entries) / key_columns(entries))
    below = 0.0 if beside else max(KEY_HEIGHT, KEY_LINE * lines)
    figure = empty_panels(panels, (TWO_COLUMNS, rows * CELL_HEIGHT + below))
    for each, panel in zip(figure.axes, figure.panels, strict=True):
        _draw_panel(each, panel, newtons_per_load)
    over_sizes = [a for a, p in zip(figure.axes, figure.panels) if p.x == "diameter_ratio"]
    for each in over_sizes[1:]:
        each.sharex(over_sizes[0])
    if len(over_sizes) > 1:
        over_sizes[0].autoscale(axis="x")
    if entries:
        add_key(figure, list(entries.values()), title, common, beside)
    return figure


def _draw_panel(axes, panel, newtons_per_load):
    """The series of a panel, and the scales of its axes."""
    lines, bars = {}, []
    for series in _some_ranges(panel.of_kind(marks.BAND)):
        outline = np.column_stack((series.x, np.maximum(series.y, panel.least or -np.inf)))
        axes.add_collection(PolyCollection([outline], **series.look))
    for series in panel.series:
        if series.drawn_as == UPRIGHT:
            for x in series.x:
                axes.axvline(x, **series.look)
            if series.tolerance:
                axes.axvspan(*series.tolerance[0], **series.tolerance_look)
        elif series.drawn_as == LINE:
            y = np.maximum(series.y, panel.least or -np.inf)
            (lines[series],) = axes.plot(series.x, y, **series.look)
            if series.tolerance:
                bars += axes.plot(*series.tolerance, **series.tolerance_look)
    set_scales(axes, panel.x, panel.y, newtons_per_load, panel.least)
    peaks = marks.TURNING_POINTS, marks.SLIGHT
    stars = [line for series, line in lines.items() if series.kind in peaks]
    keep_apart(axes, stars)
    numbers = [line for series, line in lines.items() if series.tolerance]
    points = [line for line in numbers if len(line.get_xdata()) == 1]
    keep_apart(axes, points)
    hide_bars(axes, list(zip(numbers, bars, strict=True)))
    if panel.x == "load":
        texts = {
            lines[one]: text
            for one in panel.of_kind(CURVE)
            if (text := one.look.get("label", "").lstrip("_"))[:1].isdigit()
        }
        label_curves(axes, texts, [*stars, *points])


def _some_ranges(ranges):
    """Ranges from the first to the last curve with a colour; grey is a zone."""
    coloured = [one for one in ranges if len({*one.look["facecolor"]}) > 1]
    places = np.linspace(0, max(len(coloured) - 1, 0), MOST_RANGES).round().astype(int)
    return [coloured[place] for place in np.unique(places) if coloured]


def key_columns(labels: Iterable[str], width: float = 1.0) -> int:
    """How many columns of a key with these labels fit on a fraction ``width`` of a figure."""
    lengths = [len(each) for each in labels]
    for columns in range(KEY_COLUMNS, 1, -1):
        parts = np.array_split(lengths, columns)
        letters = sum(part.max(initial=0) + HANDLE_LETTERS for part in parts if part.size)
        if letters <= width * KEY_LETTERS:
            return columns
    return 1


def add_key(
    figure: Figure,
    entries: Sequence[Line2D],
    title: str = "",
    common: Sequence[str] = (),
    beside: bool = False,
) -> None:
    """Add a key below all panels, or beside the last one in the free cell of two columns, with a title and
    the conditions common to all curves."""
    columns = key_columns([str(each.get_label()) for each in entries])
    place = {"loc": "outside lower center", "ncols": columns}
    if beside:
        cell = 0.5, 0.0, 0.5, 2.0 / (len(figure.axes) + 1)
        columns = math.ceil(len(entries) / KEY_ROWS)
        place = {"loc": "center", "bbox_to_anchor": cell, "ncols": columns}
    text = "\n".join(filter(None, (title, ", ".join(common))))
    ends = {each: HandlerLine2D(numpoints=2) for each in entries if each.get_marker() == "|"}
    figure.legend(handles=entries, title=text or None, handler_map=ends, **place)


def level_styles(count: int, size: int = 1) -> list[dict]:
    """Line properties of curves of ``size`` points at ``count`` ordered levels: colours become
    lighter, and each has its own marker, at other points than the next one."""
    colours = matplotlib.colormaps[rcParams["image.cmap"]](np.linspace(DARKEST, LIGHTEST, count))
    step = max(size // MARKERS_PER_CURVE, 1)
    return [
        {"color": colour, "marker": MARKERS[index % len(MARKERS)], "linestyle": "-"}
        | {"markerfacecolor": "white" if index % 2 else colour, "markeredgecolor": colour}
        | {"markevery": (int(step * (index + 0.5) / count), step)}
        for index, colour in enumerate(map(tuple, colours.tolist()))
    ]


def curve_styles(
    curves: Sequence[Condition], parameter: str, size: int
) -> dict[Condition | str, dict]:
    """Line properties of ``curves`` of ``size`` points that differ in one ``parameter``, labelled by its
    level.  Two-body contact is black or grey; with lubricated contact, dry contact is broad and grey, the
    lighter the higher its level, or dotted without particles."""
    media = {each.viscosity for each in curves}
    compares_media = parameter != "viscosity" and len({each.is_dry for each in curves}) == 2
    levels = sorted({getattr(each, parameter) for each in curves} - {0.0})
    looks = dict(zip(levels, level_styles(len(levels), size), strict=True))
    looks[0.0] = {"color": "black"}
    greys = dict(zip(sorted(looks), np.linspace(*DRY_GREYS, len(looks)).tolist(), strict=True))
    styles = {}
    for each in curves:
        level = getattr(each, parameter)
        look = looks[level] | {"label": _level_text(each, parameter)}
        if each.is_dry and parameter == "viscosity" and each.is_two_body:
            look = DRY_TWO_BODY | {"label": look["label"]}
        elif compares_media and each.is_dry:  # written at the curve, but not in the key
            look = DRY | {"color": str(greys[level]), "label": f"_{look['label']}"}
        elif each.is_dry and any(media):
            look = DRY | {"label": look["label"]}
        styles[each] = look
    for viscosity in sorted(media, reverse=True) if compares_media else ():
        text = f"{value_text('viscosity', viscosity)} cSt" if viscosity else "dry"
        styles[text] = ({"color": GREY} if viscosity else DRY) | {"label": text}
    return styles


def _level_text(condition, parameter):
    level = getattr(condition, parameter)
    if level:
        return value_text(parameter, level)
    if parameter == "viscosity":
        return "dry, two-body" if condition.is_two_body else "dry"
    return "none (two-body)"
