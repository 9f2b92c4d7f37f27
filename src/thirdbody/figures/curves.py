"""Figures of curves: the combinations that a dataset shows, drawn into panels."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from thirdbody.data.conditions import Condition
from thirdbody.figures.marks import (
    TURNING_POINTS,
    WINDOW,
    mark_entries,
    mark_statuses,
    mark_turning_points,
    turning_points_of,
)
from thirdbody.figures.printed import draw_printed, draw_printed_windows
from thirdbody.figures.sheet.key import draw_key
from thirdbody.figures.sheet.naming import parameter_title, shared_notes
from thirdbody.figures.sheet.panel import Panel, panel_figure
from thirdbody.figures.sheet.scales import SCALES
from thirdbody.figures.sheet.styles import Styles
from thirdbody.figures.shown import Curve, shown_curves, with_relative_area

MARKERS_PER_CURVE = 7
PARTED = 1.6  # points between curves that are told apart
WINDOW_HEIGHT = 0.5  # of windows in their panel, where no turning point is near their ends
BAND_STEP = 2  # every second load is fine enough for the edge of a band
# of the key: the text, and a line about as wide as a band
BAND_ENTRY = (
    "calibrated ensemble",
    {"color": "0.82", "linewidth": 6.0, "solid_capstyle": "butt"},
)


@dataclass(frozen=True)
class Content:
    """What a panel shows.

    Attributes
    ----------
    y, x : str
        Variables against each other; one of ``SCALES``.
    surface : int, optional
        Curves of one surface alone: 0 for the smoothest of the dataset, -1 for the roughest.
    locus : bool
        Whether the turning points of the curves are joined.

    Notes
    -----
    Over ``diameter_ratio`` it shows no curves but where they have their turning points.
    """

    y: str
    x: str = "load"
    surface: int | None = None
    locus: bool = False


@dataclass(frozen=True)
class CurveFigure:
    """A figure of curves: a row of the registry.

    Attributes
    ----------
    parameter : str
        What its curves are told apart by: an attribute of ``Condition``.
    contents : tuple of Content
        Its panels, in order.
    each_surface : bool
        Whether each panel stands once for each roughness of the dataset.
    two_body : bool
        Whether two-body contact is among the curves, or only what areas are held against.
    """

    parameter: str
    contents: tuple[Content, ...]
    each_surface: bool = False
    two_body: bool = True

    @property
    def shows_windows(self) -> bool:
        """Whether a panel shows the windows of the turning point."""
        return any(content.x == "diameter_ratio" for content in self.contents)

    def plot(
        self,
        data: xr.Dataset,
        turning_points: Sequence[Mapping] = (),
        band: xr.Dataset | None = None,
        printed: Sequence[Mapping] = (),
        windows: Sequence[Mapping] = (),
    ) -> Figure:
        """Draw it.

        Parameters
        ----------
        data : xarray.Dataset
            One of ``read_dataset``.
        turning_points : sequence of Mapping
            The four conditions (SI), ``load`` and ``peak_ratio`` of each, to be marked.
        band : xarray.Dataset, optional
            ``<variable>_low`` and ``_high`` on the axes of ``data``, drawn behind the curves.
        printed : sequence of Mapping
            Rows of the table ``printed``: the paper's numbers for this figure.
        windows : sequence of Mapping
            Rows of the table ``tpca_windows``.

        Raises
        ------
        ValueError
            In one line, if ``data`` hold nothing that it shows.
        """
        curves = [each for each in shown_curves(data) if self._shows(each.condition)]
        data = with_relative_area(data)
        contents = self._panels(data, curves)
        if not contents:
            names = ", ".join(dict.fromkeys(each.y for each in self.contents))
            raise ValueError(f"there is nothing to draw; allowed: points with {names}")
        curves.sort(key=lambda c: (getattr(c.condition, self.parameter), c.condition.is_two_body))
        conditions = [curve.condition for curve in curves]
        styles = Styles(conditions, self.parameter)
        common = shared_notes(conditions)
        newtons_per_load = None
        if "normal_load" in data:
            newtons_per_load = float(data["normal_load"].values[-1] / data["load"].values[-1])
        figure = panel_figure([(content.x, content.y) for content in contents])
        marked: set[Condition] = set()
        for panel, content in zip(figure.axes, contents, strict=True):
            chosen = _on_surface(curves, data, content.surface)
            panel.add_title(_title(content, chosen, common))
            points = turning_points_of(chosen, turning_points)
            if content.x == "diameter_ratio":
                draw_windows(panel, chosen, points, windows, printed)
                panel.frame(newtons_per_load)
                continue
            if band is not None and content.x == "load" and f"{content.y}_low" in band:
                draw_bands(panel, band, chosen, styles)
            lines = [draw_curve(panel, data, curve, styles) for curve in chosen]
            mark_statuses(panel, data, chosen)
            _draw_marks(panel, data, content, points)
            draw_printed(panel, data, chosen, printed, points, styles)
            panel.frame(newtons_per_load)
            marked |= place_markers(panel, chosen, lines, styles)
        marks = mark_entries(figure) + [BAND_ENTRY] * (band is not None)
        title = parameter_title(self.parameter)
        draw_key(figure, title, ", ".join(common), styles.key(conditions, marked), marks)
        return figure

    def _panels(self, data, curves) -> Sequence[Content]:
        """Panels of what ``data`` hold along ``curves``."""

        def holds(name):
            return name in data and any(
                np.isfinite(each.values(data, name)).any() for each in curves
            )

        sizes = len({each.condition.diameter_ratio for each in curves})
        contents = [
            each
            for each in self.contents
            if (sizes > 1 if each.x == "diameter_ratio" else holds(each.x) and holds(each.y))
        ]
        if not self.each_surface:
            return contents
        indices = range(data.sizes["roughness"])
        return [replace(each, surface=index) for each in contents for index in indices]

    def _shows(self, condition):
        return self.two_body or not condition.is_two_body


def draw_curve(panel: Panel, data: xr.Dataset, curve: Curve, styles: Styles) -> Line2D:
    """Draw ``curve`` into ``panel``."""
    x, y = curve.values(data, panel.x_name), curve.values(data, panel.y_name)
    return panel.add_line(Line2D(x, y, label=curve.label, **styles.of(curve.condition)))


def place_markers(
    panel: Panel, curves: Sequence[Curve], lines: Sequence[Line2D], styles: Styles
) -> set[Condition]:
    """Leave markers to ``lines`` only where they part from those of other levels.

    Parameters
    ----------
    panel : Panel
        One that has its frame.
    curves, lines : sequence
        Its curves, and how they are drawn.
    styles : Styles
        What tells the curves apart.

    Returns
    -------
    set of Condition
        Those of the curves that show markers.
    """
    paths = [panel.in_points(line) for line in lines]
    marked = set()
    for curve, line, path in zip(curves, lines, paths, strict=True):
        if "marker" not in styles.of(curve.condition):
            continue
        rivals = [
            other
            for rival, other in zip(curves, paths, strict=True)
            if rival is not curve and styles.are_rivals(curve.condition, rival.condition)
        ]
        places = _staggered(_parted(path, rivals), styles.stagger(curve.condition))
        line.set(**({"markevery": places} if places else {"marker": "none"}))
        if places:
            marked.add(curve.condition)
    return marked


def _parted(path, rivals) -> NDArray[np.bool_]:
    """Where ``path`` is farther than ``PARTED`` from all ``rivals``; paths in points."""
    x, y = path.T
    gaps = np.full(x.size, np.inf)
    for other in rivals:
        there, height = other.T if other[0, 0] <= other[-1, 0] else other[::-1].T
        gap = np.abs(np.interp(x, there, height, left=np.inf, right=np.inf) - y)
        gaps = np.fmin(gaps, gap)
    steepness = np.gradient(y) / np.where(np.gradient(x) == 0.0, np.inf, np.gradient(x))
    return gaps > PARTED * np.hypot(1.0, steepness)


def _staggered(free, stagger) -> list[int]:
    """Places of markers in equal steps where ``free`` allows, or else one where it ever does."""
    step = max(free.size // MARKERS_PER_CURVE, 1)
    places = [place for place in range(int(step * stagger), free.size, step) if free[place]]
    if places or not free.any():
        return places
    starts = np.flatnonzero(np.diff(free, prepend=False, append=False)).reshape(-1, 2)
    longest = starts[np.argmax(starts[:, 1] - starts[:, 0])]
    return [int(longest.mean())]


def draw_bands(panel: Panel, band: xr.Dataset, curves: Sequence[Curve], styles: Styles) -> None:
    """Draw the envelopes of ``curves`` at each load, in a tint of their colours.

    The tints are opaque: many curves lie on one another, and so would their bands.
    """
    load = band[panel.x_name].values
    some = np.unique([*range(0, load.size, BAND_STEP), load.size - 1])
    outlines = []
    for curve in curves:
        low, high = (curve.values(band, f"{panel.y_name}_{end}")[some] for end in ("low", "high"))
        there, back = (np.column_stack((load[some], edge)) for edge in (low, high))
        known = np.isfinite(low) & np.isfinite(high)
        outlines.append(np.concatenate((there[known], back[known][::-1])))
    names = [f"band; {curve.label}" for curve in curves]
    tints = [styles.tint(curve.condition) for curve in curves]
    panel.add_outlines(outlines, names, facecolors=tints, linewidths=0.0, zorder=1.5)


def draw_windows(
    panel: Panel,
    curves: Sequence[Curve],
    turning_points: Sequence[tuple[Curve, Mapping]],
    windows: Sequence[Mapping],
    printed: Sequence[Mapping],
) -> None:
    """Draw between which diameters there are turning points: those of curves, and the ends.

    Parameters
    ----------
    panel : Panel
        Where to draw.
    curves : sequence of Curve
        Those of one surface.
    turning_points : sequence of (Curve, Mapping)
        Pairs of ``turning_points_of``.
    windows, printed : sequence of Mapping
        Rows of the tables ``tpca_windows`` and ``printed``.
    """
    roughness = curves[0].condition.roughness
    panel.update_datalim([(curve.condition.diameter_ratio, 0.0) for curve in curves])
    panel.update_datalim([(curves[0].condition.diameter_ratio, 1.0)])
    points = [(curve.condition.diameter_ratio, row["peak_ratio"]) for curve, row in turning_points]
    if points:
        panel.add_line(Line2D(*np.transpose(points), label="turning points", **TURNING_POINTS))
    ends = [
        (row["diameter_over_roughness"], WINDOW_HEIGHT)
        for row in windows
        if np.isclose(row["roughness_m"], roughness, rtol=1e-9)
        and np.isfinite(row["diameter_over_roughness"])
    ]
    if ends:
        panel.add_line(Line2D(*np.transpose(ends), label="window", zorder=3, **WINDOW))
    draw_printed_windows(panel, printed, roughness, WINDOW_HEIGHT)


def _on_surface(curves, data, surface):
    """Those of ``curves`` on the surface with this index among the roughnesses of ``data``."""
    if surface is None:
        return curves
    roughness = data["roughness"].values[surface]
    return [curve for curve in curves if curve.condition.roughness == roughness]


def _title(content, chosen, common) -> str:
    """What the curves of a panel share beyond the others, or else what it shows."""
    shared = shared_notes([curve.condition for curve in chosen])
    own = [text for text in shared if text not in common]
    return ", ".join(own) or SCALES[content.y].title


def _draw_marks(panel, data, content, marked):
    if content.locus:
        mark_turning_points(panel, data, marked, "locus of the turning points")
    if content.locus or content.y == "particle_contact_area_ratio":
        mark_turning_points(panel, data, marked)
