"""Design charts of the atlas: limits over the load with ensemble ranges, one curve per roughness."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
import xarray as xr
from matplotlib.lines import Line2D

from thirdbody.data.conditions import CONDITION_AXES
from thirdbody.figures.curves import draw_panels, range_outline
from thirdbody.figures.drawing import CURVE, Drawing, Panel, Series
from thirdbody.figures.marks import BAND
from thirdbody.figures.scales import note, parameter_title, value_text
from thirdbody.figures.styles import level_styles

RANGE = "90 % of the ensemble"


def plot(name: str, charts: Sequence[xr.Dataset]) -> Drawing:
    """The limit ``name``, one of ``SCALES``, in one panel per dataset of ``charts``, from
    ``thirdbody.atlas.catalogue.chart_panels``, all with the same roughnesses."""
    surfaces = charts[0]["roughness"].values
    names = [f"sigma = {value_text('roughness', surface)} nm" for surface in surfaces]
    looks = dict(zip(names, level_styles(surfaces.size, charts[0].sizes["load"]), strict=True))
    panels = [
        Panel(", ".join(_notes(chart)), "load", name, tuple(_series(chart, looks)))
        for chart in charts
    ]
    newtons_per_load = float((charts[0]["normal_load"] / charts[0]["load"])[-1])
    entries = [
        Line2D([], [], label=value_text("roughness", surface), **look)
        for surface, look in zip(surfaces, looks.values(), strict=True)
    ]
    entries.append(Line2D([], [], label=RANGE, color="0.82", linewidth=6.0))
    title = parameter_title("roughness")
    figure = draw_panels(panels, looks, newtons_per_load, entries, title)
    for axes, panel, chart in zip(figure.axes, panels, charts, strict=True):
        axes.set_xlim(*chart["load"].values[[0, -1]])
        if not any(np.isfinite(one.y).any() for one in panel.series):
            axes.set_ylim(*chart.attrs["ends"])
    return figure


def _notes(chart) -> list[str]:
    """The conditions of a panel."""
    held = [axis.name for axis in CONDITION_AXES if axis.name in chart.coords.keys() - chart.dims]
    values = {name: float(chart[name]) for name in held}
    if 0.0 in (values.get("particle_diameter"), values.get("particle_density")):
        return ["without particles"]
    return [note(name, value) for name, value in values.items()]


def _series(chart, names) -> Iterator[Series]:
    """The curve of each roughness and the outlines of its range, inside the atlas."""
    load = chart["load"].values
    for index, name in enumerate(names):
        surface = chart.isel(roughness=index)
        limit = surface["limit"].values
        known = np.isfinite(limit) & (limit > 0.0)
        yield Series(CURVE, name, load, np.where(known, limit, np.nan), name)
        low, high = np.clip(surface["range"].values[[0, -1]], *chart.attrs["ends"])
        places = np.flatnonzero(low < high)
        for run in np.split(places, np.flatnonzero(np.diff(places) > 1) + 1):
            if run.size > 1:
                yield Series(BAND, name, *range_outline(load[run], low[run], high[run]), name)
