"""Design charts of the atlas: limits over the load with the range of the ensemble, a curve a roughness."""

from __future__ import annotations

from collections.abc import Sequence

import matplotlib
import numpy as np
import xarray as xr
from matplotlib import rcParams
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from thirdbody.data.conditions import CONDITION_AXES
from thirdbody.figures.sheet.key import draw_key
from thirdbody.figures.naming import note, parameter_title, value_text
from thirdbody.figures.sheet.panel import panel_figure
from thirdbody.figures.styles import LIGHTEST, MARKERS, TINT

MARK_EVERY = 12  # loads
BAND = ("90 % of the ensemble", {"color": "0.82", "linewidth": 6.0, "solid_capstyle": "butt"})


def plot(name: str, panels: Sequence[xr.Dataset]) -> Figure:
    """Draw a chart.

    Parameters
    ----------
    name : str
        Its limit, one of ``SCALES``.
    panels : sequence of xarray.Dataset
        Those of ``thirdbody.atlas.charts.chart_panels``; all show the same roughnesses.
    """
    figure = panel_figure([("load", name)] * len(panels))
    surfaces = panels[0]["roughness"].values
    shades = matplotlib.colormaps[rcParams["image.cmap"]](np.linspace(0.0, LIGHTEST, surfaces.size))
    looks = [
        {"color": shade, "marker": MARKERS[index % len(MARKERS)], "linestyle": "-"}
        for index, shade in enumerate(shades.tolist())
    ]
    for panel, shown in zip(figure.axes, panels, strict=True):
        panel.add_title(", ".join(_notes(shown)))
        _draw(panel, shown, looks)
        newtons = shown["normal_load"].values / shown["load"].values
        panel.frame(float(newtons[-1]))
    keys = [
        (value_text("roughness", surface), look)
        for surface, look in zip(surfaces, looks, strict=True)
    ]
    draw_key(figure, parameter_title("roughness"), "", keys, [BAND])
    return figure


def _notes(shown) -> list[str]:
    """The conditions of a panel."""
    held = [axis.name for axis in CONDITION_AXES if axis.name in shown.coords.keys() - shown.dims]
    values = {name: float(shown[name]) for name in held}
    if 0.0 in (values.get("particle_diameter"), values.get("particle_density")):
        return ["without particles"]
    return [note(name, value) for name, value in values.items()]


def _draw(panel, shown, looks):
    """Bands and curves: what is beyond the atlas is left out."""
    load = shown["load"].values
    bands, names, tints = [], [], []
    for index, look in enumerate(looks):
        some = shown.isel(roughness=index)
        label = f"sigma = {value_text('roughness', float(some['roughness']))} nm"
        low, high = np.clip(some["range"].values[[0, -1]], *shown.attrs["ends"])
        known = np.flatnonzero(low < high)
        for run in np.split(known, np.flatnonzero(np.diff(known) > 1) + 1):
            if run.size > 1:
                x, ends = load[run], (low[run], high[run])
                bands.append(np.transpose([np.r_[x, x[::-1]], np.r_[ends[0], ends[1][::-1]]]))
                names.append(f"{label}; 90 % of the ensemble")
                tints.append(1.0 - TINT * (1.0 - np.array(to_rgb(look["color"]))))
        value = some["limit"].values
        value = np.where(np.isfinite(value) & (value > 0.0), value, np.nan)
        start = (2 * index + 1) * MARK_EVERY // (2 * len(looks))
        panel.add_line(Line2D(load, value, label=label, markevery=(start, MARK_EVERY), **look))
    if bands:
        panel.add_outlines(bands, names, facecolors=tints, edgecolors="none", alpha=0.6, zorder=1.2)
    drawn = panel.dataLim.intervaly
    panel.update_datalim(
        np.transpose([load[[0, -1]], drawn if np.isfinite(drawn).all() else shown.attrs["ends"]])
    )
