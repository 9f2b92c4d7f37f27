"""Figures of curves over the load, from any dataset."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product, zip_longest
from string import ascii_uppercase

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

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
from thirdbody.plotting.crowding import hide_repeats, keep_apart, name_ends
from thirdbody.plotting.drawing import ONE_COLUMN, TWO_COLUMNS, empty_panels
from thirdbody.plotting.keys import Groups, add_key, handle, is_beside, key_height, key_title
from thirdbody.plotting.marks import AREA
from thirdbody.plotting.panels import CURVE, LINE, Curve, Panel, Series
from thirdbody.plotting.scales import SCALES, panel_title, parameter_title, shared_notes
from thirdbody.plotting.styles import DRY, DRY_TWO_BODY_TEXT, HAIRLINE, TWO_BODY, Look, curve_styles
from thirdbody.symbols import mathtext
from thirdbody.variables import RELATIVE_AREA

MOST_RANGES = 3  # drawn in a panel; the file of the data drawn has all
CELL_HEIGHT = 2.85  # of a panel with its labels [inches]
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

    ``surface`` is the only one shown, 0 the smoothest and -1 the roughest; a logarithmic axis of a
    fraction begins at ``least``; the title ends with the ``remark``.
    """

    y: str
    x: str = "load"
    surface: int | None = None
    least: float = 0.0
    remark: str = ""


@dataclass(frozen=True)
class CurveFigure:
    """A figure of curves that differ in one ``parameter``.

    Each panel is drawn for every value of the conditions ``each``, with two-body contact.  Without
    ``two_body``, two-body contact is only the reference of areas.  If levels of the parameter [SI]
    are ``strong``, the others are hairlines.  ``rows`` of two columns are those of
    ``empty_panels``.
    """

    parameter: str
    contents: tuple[Content, ...]
    each: tuple[str, ...] = ()
    two_body: bool = True
    strong: tuple[float, ...] = ()
    rows: tuple[str, ...] = ()

    def plot(
        self,
        data: Dataset,
        turning_points: Sequence[Mapping] = (),
        ensemble_range: Dataset | None = None,
        axes: Sequence[Axes] = (),
        add_series: Callable[[Content, list[Curve], list[Series]], None] | None = None,
        draw_marks: Callable[[Axes, Panel], None] | None = None,
        mark_looks: Mapping[str, Look] = marks.LOOKS,
        width: float | None = None,
        only: str = "",
    ) -> Figure:
        """Draw the figure; ``ValueError`` if ``data`` have no values for it.

        ``turning_points`` have the four conditions (SI), ``load`` and ``peak_ratio``;
        ``ensemble_range`` has ``<variable>_low`` and ``_high`` on the axes of ``data``.  With
        ``axes``, the panels are drawn there; the ``width`` of a figure [inches] is by default one
        column for one panel, and two for several; ``only`` is the letter of a panel to draw alone,
        without hairlines.
        ``add_series`` adds to the series of a panel;
        ``draw_marks`` draws those that are neither lines nor outlines; ``mark_looks`` are entries
        of the key, for marks that are drawn.
        """
        curves = curves_in(data, turning_points, ensemble_range)
        if not self.two_body:
            curves = [one for one in curves if not one.condition.is_two_body]
        # in the order of the key
        curves.sort(key=lambda c: (getattr(c.condition, self.parameter), c.condition.is_two_body))
        conditions = [curve.condition for curve in curves]
        looks, key = curve_styles(
            conditions, self.parameter, data.sizes["load"], self.strong, hairlines=not only
        )
        curves = [
            replace(curve, look=looks[curve.condition])
            for curve in curves
            if curve.condition in looks
        ]
        common = shared_notes(conditions)
        panels = []
        for content, chosen in self._chosen(curves, data["roughness"].values):
            series: list[Series] = []
            if content.x != "diameter_ratio":
                chosen = [one for one in chosen if one.has(content.x) and one.has(content.y)]
                series += _curve_series(content, chosen)
                if not self._has_range_elsewhere(content):
                    series += marks.ranges_of(chosen, content.x, content.y)
            if add_series is not None:
                add_series(content, chosen, series)
            shared = shared_notes([curve.condition for curve in chosen])
            own = ", ".join(text for text in shared if text not in common)
            if series:
                panels.append(self._panel(content, series, own))
        if only:
            panels = [replace(panels[ascii_uppercase.index(only)], letter=only)]
        newtons_per_load = None
        if "normal_load" in data:
            newtons_per_load = float(data["normal_load"].values[-1] / data["load"].values[-1])
        title = parameter_title(self.parameter)
        return draw_panels(
            panels,
            key,
            title,
            common,
            newtons_per_load,
            axes,
            draw_marks,
            mark_looks,
            width,
            () if only else self.rows,
        )

    def _chosen(self, curves, roughness) -> Iterator[tuple[Content, list[Curve]]]:
        """The content of each panel, with the curves of its surface and its conditions."""
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

    def _has_range_elsewhere(self, content) -> bool:
        """Whether an area has its range where its curves lie apart: in the panel of ratios."""
        return content.y == AREA and RELATIVE_AREA in {each.y for each in self.contents}

    def _panel(self, content, series, own) -> Panel:
        """A panel.  Its title has its quantity, if others differ, and its ``own`` conditions."""
        several = len({(each.x, each.y) for each in self.contents}) > 1
        shown = panel_title(content.x, content.y) if several or not own else ""
        return Panel(
            title="\n".join(filter(None, (shown, " ".join(filter(None, (own, content.remark)))))),
            x=content.x,
            y=content.y,
            series=series,
            least=content.least,
            conditions=own,
        )


def _is_of(own, condition) -> bool:
    """Whether a curve has the ``own`` conditions of a panel; in two-body contact those of
    particles are ignored."""
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
    """The series of a panel that follow from its curves."""
    x, y = content.x, content.y
    for curve in curves:
        values = curve.values[x], curve.values[y]
        yield Series(CURVE, curve.label, *values, curve.condition, curve.look)
        yield from marks.status_series(curve.label, *values, curve.values, curve.condition)
    if y == marks.RATIO:
        yield from marks.turning_point_series(x, y, curves)
        if x == "load":
            yield from marks.slight_series(x, y, curves, content.least)


def draw_panels(
    panels: Sequence[Panel],
    key: Groups,
    title: str = "",
    common: Sequence[str] = (),
    newtons_per_load: float | None = None,
    axes: Sequence[Axes] = (),
    draw_marks: Callable[[Axes, Panel], None] | None = None,
    mark_looks: Mapping[str, Look] = marks.LOOKS,
    width: float | None = None,
    rows: Sequence[str] = (),
) -> Figure:
    """Draw panels of curves, and a key with the groups of ``key`` and those ``mark_looks`` that
    occur.  With ``newtons_per_load``, F_t/F_t* [N], load axes also show newtons.  Panels are drawn
    on ``axes``, with the key in the last, or on a new figure of this ``width`` [inches], in
    ``rows`` as in ``empty_panels`` if there are two columns.  ``draw_marks`` draws in a panel
    after its curves."""
    if not panels:
        raise ValueError("there is nothing to draw; allowed: points with values of the variables")
    labels = {label for panel in panels for series in panel.series for label in series.labels}
    drawn = [look for look in mark_looks.values() if look.get("label") in labels]
    groups = [group for group in (*key, drawn) if group]
    own = not len(axes)
    if own:
        axes = _new_axes(panels, groups, title, common, width, rows)
    figure = axes[0].figure.figure
    drawings = [
        (each, panel, _draw_series(each, panel, newtons_per_load, draw_marks))
        for each, panel in zip(axes, panels, strict=True)
    ]
    if groups and not own:
        lines = [handle(each) for group in groups for each in group]
        axes[-1].legend(handles=lines, title=mathtext(title) or None)
    if engine := figure.get_layout_engine():
        engine.execute(figure)  # names take their room from that of their panel
    for drawing in drawings:
        _keep_readable(*drawing)
    return figure


def _new_axes(panels, groups, title, common, width, rows) -> Sequence[Axes]:
    """The axes of a new figure, with its key."""
    width = width or (ONE_COLUMN if len(panels) == 1 else TWO_COLUMNS)
    columns = 2 if width > 1.5 * ONE_COLUMN else 1
    letters = ascii_uppercase[: len(panels)]
    if columns == 1 or {*"".join(rows)} != {*letters}:
        rows = ()
    beside = len(panels) % columns == 1 and is_beside(groups)
    text = key_title(title, common, width / columns if beside else width)
    below = key_height(groups, text, width) if groups and not beside else 0.0
    size = width, math.ceil(len(panels) / columns) * CELL_HEIGHT + below
    figure = empty_panels(panels, size, columns, rows)
    if groups:
        add_key(figure, groups, text, beside)
    plain = [letters[place : place + columns] for place in range(0, len(letters), columns)]
    table = [sorted({*row}) for row in rows or plain]
    _share_titles(dict(zip(letters, zip(figure.axes, panels, strict=True))), table)
    return figure.axes


def _share_titles(drawn, rows):
    """Hide titles of axes that the panel below or the one at the left repeats."""
    for row, below in zip_longest(rows, rows[1:], fillvalue=""):
        for place, letter in enumerate(row):
            axes, panel = drawn[letter]
            if place < len(below) and drawn[below[place]][1].x == panel.x:
                axes.xaxis.label.set_visible(False)
            if place > 0 and drawn[row[place - 1]][1].y == panel.y:
                axes.yaxis.label.set_visible(False)


def _draw_series(axes, panel, newtons_per_load, draw_marks) -> dict[Series, Line2D]:
    """Draw the series of a panel, then the scales of its axes; the lines of its series."""
    lines, doubtful = {}, marks.doubtful(panel.series)
    unseen = UNSEEN * panel.least or -np.inf
    for series in ranges_drawn(panel):
        outline = np.column_stack((series.x, np.maximum(series.y, unseen)))
        axes.add_collection(PolyCollection([outline], **series.look))
    for series in panel.series:
        if series.drawn_as == LINE:
            y = np.maximum(series.y, unseen)
            if series.kind == CURVE:
                y[np.isin(series.x, doubtful.get(series.name, []))] = np.nan
            (lines[series],) = axes.plot(series.x, y, **series.look)
    if draw_marks is not None:
        draw_marks(axes, panel)
    set_scales(axes, panel.x, panel.y, newtons_per_load, panel.least)
    return lines


def _keep_readable(axes, panel, lines):
    """Write names of curves, and hide what coincides."""
    if panel.x in ("load", "normal_load"):
        named = [one for one in panel.of_kind(CURVE) if curve_name(one)]
        strong, hairlines = (
            {lines[one]: curve_name(one) for one in named if is_hairline(one) == thin}
            for thin in (False, True)
        )
        dry = [lines[one] for one in named if one.curve and one.curve.is_dry]
        name_ends(axes, strong, dry, hairlines)
        dashed = [
            one for one in panel.of_kind(CURVE) if one.look.get("linestyle") == DRY["linestyle"]
        ]
        hide_repeats(axes, [lines[one] for one in dashed])
    peaks = marks.TURNING_POINTS, marks.SLIGHT
    keep_apart(axes, [line for series, line in lines.items() if series.kind in peaks])


def curve_name(series: Series) -> str:
    """The level of a curve, which is written at its end."""
    text = series.look.get("label", "").lstrip("_")
    text = {TWO_BODY: "none", DRY_TWO_BODY_TEXT: "two-body"}.get(text, text)
    is_level = text[:1].isdigit() or text in ("dry", "none", "two-body")
    return mathtext(text) if is_level else ""


def is_hairline(series: Series) -> bool:
    """Whether a curve is one of the thin ones between the strong ones."""
    return series.look.get("linewidth") == HAIRLINE["linewidth"]


def ranges_drawn(panel: Panel) -> list[Series]:
    """The ranges of a few coloured curves, from the first to the last, and those of two-body
    contact, above which others would rise, but not beside zones, which are grey too, nor where it
    is the reference."""
    strong = {one.curve for one in panel.of_kind(CURVE) if not is_hairline(one)}
    bands = [one for one in panel.of_kind(marks.BAND) if one.curve in strong]
    ranges = [one for one in bands if _is_apart(one, panel.y)]
    places = np.linspace(0, max(len(ranges) - 1, 0), MOST_RANGES).round().astype(int)
    return [ranges[place] for place in np.unique(places) if ranges]


def _is_apart(band, y):
    """Whether a range is coloured, or of two-body contact beside no zones and no reference."""
    is_grey = len({*band.look["facecolor"]}) == 1
    is_free = not SCALES[y].zones and y != RELATIVE_AREA
    return not is_grey or (band.curve.is_two_body and is_free)
