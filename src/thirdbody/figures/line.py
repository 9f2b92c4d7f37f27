"""A curve of one interface over any axis: the four variables of the paper's panels, and their bands."""

from __future__ import annotations

from collections.abc import Mapping
from os import PathLike
from pathlib import Path

from matplotlib.figure import Figure
from numpy.typing import NDArray

from thirdbody.data.conditions import CONDITION_AXES
from thirdbody.data.files import whole
from thirdbody.data.quantities import NORMAL_LOAD, QUANTITIES
from thirdbody.figures.naming import parameter_title
from thirdbody.figures.drawing import OPTIONS
from thirdbody.figures.scales import SCALES

SIZE = (7.0, 5.2)  # inches
SHOWN = (
    "total_contact_area",
    "particle_contact_area_ratio",
    "solid_load_fraction",
    "film_thickness",
)


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
        Name of the axis, with its unit.
    points : array, shape (n,)
        Values of the axis.
    values, low, high : mapping
        Arrays of shape (n,) by the names of variables: the curve, and its range over the ensemble;
        the last two may be empty.

    Returns
    -------
    Figure
    """
    figure = Figure(figsize=SIZE, layout="constrained")
    for axes, name in zip(figure.subplots(2, 2).ravel(), SHOWN, strict=True):
        scale = SCALES[name]
        axes.plot(points, values[name], color="C0")
        if name in low:
            axes.fill_between(points, low[name], high[name], color="C0", alpha=0.2, linewidth=0)
        for limit in scale.limits:
            axes.axhline(limit, color="0.6", linewidth=0.6, linestyle=":")
        axes.set_xscale("log")
        if scale.logarithmic:
            axes.set_yscale("log")
        axes.set_title(f"{scale.title}, {QUANTITIES[name].symbol}", fontsize=9)
        axes.set_xlabel(axis_title(along))
    return figure


def axis_title(along: str) -> str:
    """What the axis of a curve is called, with its unit.

    Examples
    --------
    >>> axis_title("roughness_nm"), axis_title("load_N")
    ('Roughness σ (nm)', 'Normal load F_t (N)')
    """
    named = {axis.key: axis.name for axis in CONDITION_AXES}
    if along in named:
        return parameter_title(named[along])
    return f"{NORMAL_LOAD.long_name.capitalize()} {NORMAL_LOAD.symbol} ({NORMAL_LOAD.units})"


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
    if kind not in OPTIONS:
        raise ValueError(f"{path} ends with {kind!r}; allowed: {', '.join(OPTIONS)}")
    with whole(path) as part:
        figure.savefig(part, format=kind, **OPTIONS[kind])
