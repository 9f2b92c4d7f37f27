"""``plot``: the panels of the paper for a dataset of one's own."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike
from pathlib import Path

import matplotlib.style
import xarray as xr
from matplotlib.figure import Figure

from thirdbody.data.conditions import DIMENSIONS
from thirdbody.data.netcdf import read_dataset
from thirdbody.data.quantities import STATUS
from thirdbody.figures.marks import read_turning_points
from thirdbody.figures.registry import CURVE_FIGURES, curve_figure

STYLE = Path(__file__).with_name("paper.mplstyle")
ALLOWED = "a dataset of tb.grid, tb.stream, Solution.to_dataset or the workflow, or its file"


def plot(
    data: xr.Dataset | str | PathLike,
    *,
    like: str | None = None,
    turning_points: Sequence[Mapping] | str | PathLike = (),
    band: xr.Dataset | str | PathLike | None = None,
) -> Figure:
    """Draw the panels of the paper for any dataset of solved points: curves over the load.

    Parameters
    ----------
    data : xarray.Dataset or path
        Dataset of ``grid`` or ``Solution.to_dataset``, or a file of ``stream`` or of the workflow.
        Besides the load one of viscosity, particle diameter and density may vary, beside dry and
        lubricated contact, and any number of roughnesses; ``.sel`` picks from a larger one.
    like : str, optional
        A figure of the paper, "fig03" to "fig13", whose panels are drawn.  By default A_sa,t*, A_t*
        and, unless all is dry, L_s and H_c, as far as the dataset has them.
    turning_points : sequence of mapping, or path, optional
        Turning points to be marked, as mappings of the four conditions [SI], ``load`` [1] and
        ``peak_ratio`` [1], or a file of the workflow's table ``tpca_loads``.
    band : xarray.Dataset or path, optional
        Envelope of the ensemble on the axes of ``data``: a file in ``results/bands/``.

    Returns
    -------
    matplotlib.figure.Figure
        Its ``savefig`` writes it.

    Raises
    ------
    ValueError
        In one line: for data that are no such dataset, that vary in more than one figure can tell
        apart, or hold nothing to draw, and for an unknown figure.
    OSError
        If a file cannot be read.
    ModuleNotFoundError
        In one line, if matplotlib is not installed: the extra ``figures`` brings it.

    Examples
    --------
    >>> import numpy as np
    >>> import thirdbody as tb
    >>> points = tb.grid(
    ...     load=np.geomspace(1e-6, 1e-4, 20),
    ...     viscosity=[0.0, 50e-6, 90e-6],
    ...     particle_diameter=3e-7,
    ...     roughness=3e-7,
    ...     particle_density=1e11,
    ...     parameters=tb.load_parameters(),
    ... )
    >>> figure = tb.plot(points)
    >>> [panel.y_name for panel in figure.axes[:2]]
    ['particle_contact_area_ratio', 'total_contact_area']
    """
    if like is not None and like not in CURVE_FIGURES:
        raise ValueError(f"like is {like!r}; allowed: {', '.join(CURVE_FIGURES)}")
    complete = _with_all_dimensions("data", data)
    envelope = None if band is None else _with_all_dimensions("band", band)
    if isinstance(turning_points, str | PathLike):
        turning_points = read_turning_points(turning_points)
    drawn = curve_figure(like or "data", complete)
    with matplotlib.style.context(STYLE, after_reset=True):
        return drawn.plot(complete, turning_points, envelope)


def _with_all_dimensions(name, data) -> xr.Dataset:
    """A dataset over the five axes in their order: of those that were left out, the one value."""
    if isinstance(data, str | PathLike):
        if not Path(data).is_file():
            raise FileNotFoundError(f"{name} is {str(data)!r}, which is no file")
        data = read_dataset(data)
    if not isinstance(data, xr.Dataset):
        raise ValueError(f"{name} is of type {type(data).__name__}; allowed: {ALLOWED}")
    missing = [each for each in DIMENSIONS if each not in data.coords]
    if name == "data" and STATUS not in data:
        missing.append(STATUS)
    if missing:
        raise ValueError(f"{name} has no {missing[0]}; allowed: {ALLOWED}")
    data = data.expand_dims([each for each in DIMENSIONS if data[each].ndim == 0])
    other = [each for each in data.dims if each not in DIMENSIONS]
    if other:
        told = "allowed: load, viscosity, particle_diameter, roughness and particle_density"
        raise ValueError(f"{name} has the dimension {other[0]!r}; {told}")
    if name == "data" and data.sizes["load"] < 2:
        raise ValueError("data has one load; allowed: two or more, which curves are drawn over")
    return data.transpose(*DIMENSIONS)
