"""Design charts of the atlas: limits over the load with the ensemble range, a curve a roughness."""

from __future__ import annotations

from collections.abc import Sequence
from string import ascii_uppercase

import numpy as np
import xarray as xr
from matplotlib import rcParams
from matplotlib.lines import Line2D

from thirdbody.data.conditions import CONDITION_AXES
from thirdbody.figures.curves import add_key
from thirdbody.figures.drawing import CURVE, Drawing, Panel, Series, grid_of_axes, title_axes
from thirdbody.figures.naming import note, parameter_title, value_text
from thirdbody.figures.scales import set_scales
from thirdbody.figures.styles import BAND_EDGE, band_style, level_styles

MARK_EVERY = 12  # loads
RANGE = "90 % of the ensemble"


def plot(name: str, charts: Sequence[xr.Dataset]) -> Drawing:
    """Draw the limit ``name``, one of ``SCALES``, in a panel for each of ``charts``.

    These are the datasets of ``thirdbody.atlas.charts.chart_panels``, all with the same roughnesses.
    """
    figure = grid_of_axes(len(charts), rcParams["figure.figsize"])
    surfaces = charts[0]["roughness"].values
    looks = level_styles(surfaces.size)
    panels = []
    for letter, axes, shown in zip(ascii_uppercase, figure.axes, charts, strict=False):
        series = []
        for index, look in enumerate(looks):
            curve, *ranges = _series(shown.isel(roughness=index))
            axes.plot(curve.x, curve.y, markevery=(index, MARK_EVERY), **look)
            for band in ranges:
                axes.fill(band.x, band.y, **band_style(look["color"]))
                axes.plot(band.x, band.y, color=look["color"], **BAND_EDGE)
            series += [curve, *ranges]
        panels.append(Panel(letter, ", ".join(_notes(shown)), "load", name, tuple(series)))
        axes.set_xlim(*shown["load"].values[[0, -1]])
        if not any(np.isfinite(one.y).any() for one in series):
            axes.set_ylim(*shown.attrs["ends"])
        title_axes(axes, panels[-1])
        set_scales(axes, "load", name, float((shown["normal_load"] / shown["load"])[-1]))
    entries = [
        Line2D([], [], label=value_text("roughness", surface), **look)
        for surface, look in zip(surfaces, looks, strict=True)
    ]
    entries.append(Line2D([], [], label=RANGE, color="0.82", linewidth=6.0))
    add_key(figure, entries, parameter_title("roughness"))
    return Drawing(figure, tuple(panels))


def _notes(shown) -> list[str]:
    """The conditions of a panel."""
    held = [axis.name for axis in CONDITION_AXES if axis.name in shown.coords.keys() - shown.dims]
    values = {name: float(shown[name]) for name in held}
    if 0.0 in (values.get("particle_diameter"), values.get("particle_density")):
        return ["without particles"]
    return [note(name, value) for name, value in values.items()]


def _series(shown) -> list[Series]:
    """The curve of one roughness and the outlines of its range, within the atlas."""
    load, limit = shown["load"].values, shown["limit"].values
    label = f"sigma = {value_text('roughness', float(shown['roughness']))} nm"
    known = np.isfinite(limit) & (limit > 0.0)
    series = [Series(CURVE, label, load, np.where(known, limit, np.nan))]
    low, high = np.clip(shown["range"].values[[0, -1]], *shown.attrs["ends"])
    places = np.flatnonzero(low < high)
    for run in np.split(places, np.flatnonzero(np.diff(places) > 1) + 1):
        if run.size > 1:
            x = np.concatenate([load[run], load[run][::-1], load[run][:1]])
            y = np.concatenate([low[run], high[run][::-1], low[run][:1]])
            series.append(Series(CURVE, f"{label}; {RANGE}", x, y))
    return series
