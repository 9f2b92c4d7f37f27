"""Design charts of the atlas: limits over the load with ensemble ranges, one curve per roughness."""

from collections.abc import Iterator, Sequence

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from thirdbody.plotting.curves import draw_panels
from thirdbody.plotting.marks import range_series
from thirdbody.plotting.panels import CURVE, Panel, Series
from thirdbody.plotting.scales import note, parameter_title, value_text
from thirdbody.plotting.styles import level_styles
from thirdbody.variables import CONDITION_AXES


def plot(name: str, charts: Sequence[xr.Dataset]) -> Figure:
    """The limit ``name``, one of ``SCALES``, in one panel per dataset of ``charts``, from
    ``thirdbody.paper.atlas.catalogue.chart_panels``, all with the same roughnesses."""
    surfaces = charts[0]["roughness"].values
    looks = [
        look | {"label": value_text("roughness", surface)}
        for surface, look in zip(
            surfaces, level_styles(surfaces.size, charts[0].sizes["load"]), strict=True
        )
    ]
    panels = [
        Panel(", ".join(_notes(chart)), "load", name, [*_series(chart, looks)]) for chart in charts
    ]
    newtons_per_load = float((charts[0]["normal_load"] / charts[0]["load"])[-1])
    figure = draw_panels(panels, [looks], parameter_title("roughness"), (), newtons_per_load)
    for axes, panel, chart in zip(figure.axes, panels, charts, strict=True):
        axes.set_xlim(*chart["load"].values[[0, -1]])
        if not any(np.isfinite(one.y).any() for one in panel.series):
            axes.set_ylim(*chart.attrs["ends"])
    return figure


def _notes(chart) -> list[str]:
    """The conditions of a panel."""
    held = [axis.name for axis in CONDITION_AXES if axis.name in chart.coords.keys() - chart.dims]
    return [note(name, float(chart[name])) for name in held]


def _series(chart, looks) -> Iterator[Series]:
    """The curve of each roughness and the outlines of its range, inside the atlas."""
    load = chart["load"].values
    for index, look in enumerate(looks):
        name = f"sigma = {look['label']} nm"
        surface = chart.isel(roughness=index)
        limit = surface["limit"].values
        known = np.isfinite(limit) & (limit > 0.0)
        yield Series(CURVE, name, load, np.where(known, limit, np.nan), look=look)
        low, high = np.clip(surface["range"].values[[0, -1]], *chart.attrs["ends"])
        places = np.flatnonzero(low < high)
        for run in np.split(places, np.flatnonzero(np.diff(places) > 1) + 1):
            if run.size > 1:
                yield range_series(name, load[run], low[run], high[run], look["color"])
