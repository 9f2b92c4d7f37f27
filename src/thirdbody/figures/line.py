"""A curve of one interface over any axis: the four variables of the paper's panels, and their ranges."""

from __future__ import annotations

from collections.abc import Mapping
from os import PathLike
from pathlib import Path

import matplotlib.style
import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from thirdbody.data.conditions import CONDITION_AXES
from thirdbody.data.files import atomic_write
from thirdbody.figures.curves import draw_panels, range_outline
from thirdbody.figures.drawing import CURVE, FORMATS, STYLE, Panel, Series, save_image
from thirdbody.figures.marks import BAND
from thirdbody.figures.plot import DRAWN
from thirdbody.figures.scales import SCALES


def draw(
    along: str,
    points: NDArray,
    values: Mapping[str, NDArray],
    low: Mapping[str, NDArray],
    high: Mapping[str, NDArray],
) -> Figure:
    """Four panels over one axis.

    Parameters
    ----------
    along : str
        Name of the axis, with its unit: "viscosity_cSt", "load_N", ...
    points : array, shape (n,)
        Values of the axis.
    values, low, high : mapping
        Arrays of shape (n,) by the names of variables: the curve, and its range over the ensemble;
        the last two may be empty.
    """
    units = {axis.key: (axis.name, axis.scale) for axis in CONDITION_AXES}
    name, unit = units.get(along, ("normal_load", 1.0))
    x = unit * np.asarray(points)
    panels = []
    for letter, variable in zip("ABCD", DRAWN, strict=True):
        series = [Series(CURVE, "", x, values[variable])]
        if variable in low:
            series.append(Series(BAND, "", *range_outline(x, low[variable], high[variable])))
        panels.append(Panel(letter, SCALES[variable].title, name, variable, tuple(series)))
    with matplotlib.style.context(STYLE, after_reset=True):
        return draw_panels(panels, lambda series: {"color": "#0072B2"})


def save_drawing(figure: Figure, path: str | PathLike) -> None:
    """Write a figure in the format that the ending of its path names.

    Raises
    ------
    ValueError
        If there is no such format.
    OSError
        If there is no room or no right to write.
    """
    kind = Path(path).suffix.removeprefix(".")
    if kind not in FORMATS:
        raise ValueError(f"{path} ends with {kind!r}; allowed: {', '.join(FORMATS)}")
    with matplotlib.style.context(STYLE, after_reset=True), atomic_write(path) as part:
        save_image(figure, part, kind)
