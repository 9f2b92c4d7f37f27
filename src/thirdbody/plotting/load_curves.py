"""Figures of curves over the load, from any dataset."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure

from thirdbody.curves import (
    OF_PARTICLES,
    Condition,
    colours_and_panels,
    condition_key,
    variables_over_load,
)
from thirdbody.netcdf import Dataset, curves_of
from thirdbody.plotting import marks
from thirdbody.plotting.axes import set_scales
from thirdbody.plotting.crowding import (
    NAME_SIZE,
    hide_bars,
    hide_repeats,
    keep_apart,
    name_ends,
)
from thirdbody.plotting.drawing import TWO_COLUMNS, empty_panels
from thirdbody.plotting.keys import Groups, add_key, handle, is_beside, key_height
from thirdbody.plotting.marks import AREA, RELATIVE_AREA
from thirdbody.plotting.panels import CURVE, LINE, UPRIGHT, Curve, Panel, Series
from thirdbody.plotting.scales import panel_title, parameter_title, shared_notes
from thirdbody.plotting.styles import DRY, DRY_TWO_BODY_TEXT, HAIRLINE, TWO_BODY, Look, curve_styles
from thirdbody.symbols import mathtext

MOST_RANGES = 3  # drawn in a panel; the file of the data drawn has all
CELL_HEIGHT = 2.85  # of a panel with its labels [inches]
SAME = 0.005  # numbers closer than this are one with more or fewer digits, in their size
# of the name of an upright line
NAME_LOOK = {"fontsize": NAME_SIZE, "rotation": 90}
UNSEEN = 0.1  # height of values below a logarithmic axis, also of 0, in its first value


def curves_in(
    data: Dataset, turning_points: Iterable[Mapping] = (), ranges: Dataset | None = None
) -> list[Curve]:
    """The curves of ``data``, in the order of its axes, with their ``ranges``; ``turning_points``
    have the four conditions.  Areas are also relative to dry two-body contact on the same surface.
    """
    found = {
        condition_key(each[name] for name in Condition._fields): each for each in turning_points
    }
    conditions, shown = curves_of(data)
    variables = {
        str(name): each
        for dataset in (data, ranges)
        if dataset is not None
        for name, each in dataset.variables.items()
    }
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

    ``surface`` is the only one shown, 0 the smoothest and -1 the roughest; with ``locus`` a line
    joins the turning points; a logarithmic axis of a fraction begins at ``least``; the title ends
    with the ``remark``.
    """

    y: str
    x: str = "load"
    surface: int | None = None
    locus: bool = False
    least: float = 0.0
    remark: str = ""


@dataclass(frozen=True)
class CurveFigure:
    """A figure of curves that differ in one ``parameter``.

    Each panel is drawn for every value of the conditions ``each``, with two-body contact.  Without
    ``two_body``, two-body contact is only the reference of areas.  If levels of the parameter [SI]
    are ``strong``, the others are hairlines.
    """

    parameter: str
    contents: tuple[Content, ...]
    each: tuple[str, ...] = ()
    two_body: bool = True
    strong: tuple[float, ...] = ()

    def plot(
        self,
        data: Dataset,
        turning_points: Sequence[Mapping] = (),
        ensemble_range: Dataset | None = None,
        windows: Sequence[Mapping] = (),
        axes: Sequence[Axes] = (),
        further: Callable[[Content, Sequence[Curve]], Iterable[Series]] | None = None,
        mark_looks: Mapping[str, Look] = marks.LOOKS,
    ) -> Figure:
        """Draw the figure; ``ValueError`` if ``data`` have no values for it.

        ``turning_points`` have the four conditions (SI), ``load`` and ``peak_ratio``;
        ``ensemble_range`` has ``<variable>_low`` and ``_high`` on the axes of ``data``; ``windows``
        are rows of the table ``tpca_windows``.  With ``axes``, the panels are drawn there.
        ``further`` gives further series of a panel from its content and curves; ``mark_looks`` are
        entries of the key, for marks that are drawn.
        """
        curves = curves_in(data, turning_points, ensemble_range)
        if not self.two_body:
            curves = [one for one in curves if not one.condition.is_two_body]
        # in the order of the key
        curves.sort(key=lambda c: (getattr(c.condition, self.parameter), c.condition.is_two_body))
        conditions = [curve.condition for curve in curves]
        looks, key = curve_styles(conditions, self.parameter, data.sizes["load"], self.strong)
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
        return draw_panels(panels, key, title, common, newtons_per_load, axes, mark_looks)

    def _chosen(self, curves, roughness) -> Iterator[tuple[Content, list[Curve]]]:
        """The content of each panel with its curves, those of one surface or combination if it has
        one.
        """
        levels = [
            sorted({getattr(curve.condition, name) for curve in curves} - {0.0})
            for name in self.each
        ]
        for content in self.contents:
            on = roughness if content.surface is None else [roughness[content.surface]]
            shown = [curve for curve in curves if curve.condition.roughness in on]
            for values in product(*levels):
                own = dict(zip(self.each, values, strict=True))
                yield content, [curve for curve in shown if _is_of(own, curve.condition)]

    def _panel(self, content, series, own) -> Panel:
        """A panel, whose title has what it shows if others show something else, and its ``own``
        conditions.
        """
        several = len({(each.x, each.y) for each in self.contents}) > 1
        shown = panel_title(content.x, content.y) if several or not own else ""
        return Panel(
            title="\n".join(filter(None, (shown, ", ".join(filter(None, (own, content.remark)))))),
            x=content.x,
            y=content.y,
            series=series,
            least=content.least,
            conditions=own,
        )


def _is_of(own, condition) -> bool:
    """Whether a panel with its ``own`` conditions has a curve; two-body contact has no particles
    that differ.
    """
    differing = [name for name, value in own.items() if getattr(condition, name) != value]
    return not differing or (condition.is_two_body and {*differing} <= {*OF_PARTICLES})


def curve_figure(data: Dataset) -> CurveFigure:
    """The figure of any ``data``, for each combination of all conditions that vary but one."""
    conditions = [curve.condition for curve in curves_in(data)]
    levels = {axis: {getattr(each, axis) for each in conditions} for axis in Condition._fields}
    contents = tuple(map(Content, variables_over_load(levels)))
    parameter, each = colours_and_panels(levels)
    return CurveFigure(parameter, contents, tuple(each))


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
        yield from marks.slight_series(x, y, curves, content.least)
    if x in ("load", "normal_load"):
        for curve in curves:
            yield from marks.range_of(curve, x, y)


def _window_series(content, curves, windows) -> Iterator[Series]:
    """Turning points over x_a/σ on one surface, and the computed ends of their range at y = 0."""
    yield from marks.turning_point_series(content.x, content.y, curves, marks.TURNING_POINTS)
    yield from marks.window_series(windows, curves[0].condition.roughness)


def draw_panels(
    panels: Sequence[Panel],
    key: Groups,
    title: str = "",
    common: Sequence[str] = (),
    newtons_per_load: float | None = None,
    axes: Sequence[Axes] = (),
    mark_looks: Mapping[str, Look] = marks.LOOKS,
) -> Figure:
    """Draw panels of curves, and a key for the groups of ``key`` and for ``mark_looks`` of marks
    that are drawn; with ``newtons_per_load``, F_t/F_t* [N], load axes also show newtons.  With
    ``axes``, one for each panel, they are drawn there, and the key is in the last of them;
    otherwise on a new figure."""
    if not panels:
        raise ValueError("there is nothing to draw; allowed: points with values of the variables")
    every = [series for panel in panels for series in panel.series]
    labels = {look.get("label") for one in every for look in (one.look, one.tolerance_look)}
    drawn = [look for look in mark_looks.values() if look.get("label") in labels - {None}]
    groups = [group for group in (*key, drawn) if group]
    if len(axes):
        for each, panel in zip(axes, panels, strict=True):
            _draw_panel(each, panel, newtons_per_load)
        if groups:
            lines = [handle(each) for group in groups for each in group]
            axes[-1].legend(handles=lines, title=mathtext(title) or None)
        return axes[0].figure.figure
    rows = math.ceil(len(panels) / 2)
    beside = len(panels) % 2 == 1 and is_beside(groups)
    below = key_height(groups) if groups and not beside else 0.0
    figure = empty_panels(panels, (TWO_COLUMNS, rows * CELL_HEIGHT + below))
    for each, panel in zip(figure.axes, figure.panels, strict=True):
        _draw_panel(each, panel, newtons_per_load)
    over_sizes = [a for a, p in zip(figure.axes, figure.panels) if p.x == "diameter_ratio"]
    for each in over_sizes[1:]:
        each.sharex(over_sizes[0])
    if len(over_sizes) > 1:
        over_sizes[0].autoscale(axis="x")
    if groups:
        add_key(figure, groups, title, common, beside)
    return figure


def _draw_panel(axes, panel, newtons_per_load):
    """The series of a panel, and the scales of its axes."""
    lines, bars = {}, []
    unseen = UNSEEN * panel.least or -np.inf
    for series in _some_ranges(panel):
        outline = np.column_stack((series.x, np.maximum(series.y, unseen)))
        axes.add_collection(PolyCollection([outline], **series.look))
    for series in panel.series:
        if series.drawn_as == LINE:
            y = np.maximum(series.y, unseen)
            (lines[series],) = axes.plot(series.x, y, **series.look)
            if series.tolerance and series.x.size > 1:
                axes.fill_between(series.x, *series.tolerance[1], **series.tolerance_look)
            elif series.tolerance:
                bars += axes.plot(*series.tolerance, **series.tolerance_look)
    _draw_uprights(axes, panel)
    zones = set_scales(axes, panel.x, panel.y, newtons_per_load, panel.least)
    peaks = marks.TURNING_POINTS, marks.SLIGHT
    stars = [line for series, line in lines.items() if series.kind in peaks]
    keep_apart(axes, stars)
    points = [line for one, line in lines.items() if one.tolerance and one.x.size == 1]
    keep_apart(axes, points)
    hide_bars(axes, list(zip(points, bars, strict=True)))
    if panel.x in ("load", "normal_load"):
        named = [one for one in panel.of_kind(CURVE) if _name(one)]
        strong, hairlines = (
            {lines[one]: _name(one) for one in named if _is_hairline(one) == thin}
            for thin in (False, True)
        )
        dry = [lines[one] for one in named if one.curve and one.curve.is_dry]
        width = name_ends(axes, strong, dry, hairlines)
        dashed = [
            one for one in panel.of_kind(CURVE) if one.look.get("linestyle") == DRY["linestyle"]
        ]
        hide_repeats(axes, [lines[one] for one in dashed])
        if zones is not None and width:
            zones.spines.right.set_position(("outward", width))


def _draw_uprights(axes, panel):
    """Draw upright lines, each number once, with the name of their curve and a strip for the
    tolerance.
    """
    names = {one.curve: _name(one) for one in panel.of_kind(CURVE)}
    drawn: list[Series] = []
    for series in panel.series:
        if series.drawn_as != UPRIGHT or any(_is_same(series, one) for one in drawn):
            continue
        drawn.append(series)
        for x in series.x:
            axes.axvline(x, **series.look)
        if series.tolerance:
            axes.axvspan(*series.tolerance[0], **series.tolerance_look)
    is_low = panel.x == "load"  # the name, where fewer curves are
    for series in drawn:
        if series.curve in names and series.tolerance:
            y = 0.02 if is_low else 0.98
            look = NAME_LOOK | {"color": series.look["color"]}
            look |= {"va": "bottom", "ha": "left"} if is_low else {"va": "top", "ha": "right"}
            look |= {"xycoords": axes.get_xaxis_transform(), "textcoords": "offset points"}
            x, gap = (series.tolerance[0][1], 2.0) if is_low else (series.x[0], -2.0)
            axes.annotate(names[series.curve], (x, y), (gap, 0.0), **look)


def _is_same(series, other) -> bool:
    """Whether two upright lines are of the same number, printed with more or with fewer digits."""
    is_like = series.look.get("label") == other.look.get("label")
    return is_like and bool(np.isclose(series.x[0], other.x[0], rtol=SAME, atol=0.0))


def _name(series) -> str:
    """The level of a curve, written at its end."""
    text = series.look.get("label", "").lstrip("_")
    text = {TWO_BODY: "none", DRY_TWO_BODY_TEXT: "two-body"}.get(text, text)
    is_level = text[:1].isdigit() or text in ("dry", "none", "two-body")
    return mathtext(text) if is_level else ""


def _is_hairline(series) -> bool:
    return series.look.get("linewidth") == HAIRLINE["linewidth"]


def _some_ranges(panel):
    """Ranges from the first to the last strong curve with a colour; grey is a zone."""
    strong = {one.curve for one in panel.of_kind(CURVE) if not _is_hairline(one)}
    ranges = [one for one in panel.of_kind(marks.BAND) if one.curve in strong]
    coloured = [one for one in ranges if len({*one.look["facecolor"]}) > 1]
    places = np.linspace(0, max(len(coloured) - 1, 0), MOST_RANGES).round().astype(int)
    return [coloured[place] for place in np.unique(places) if coloured]
