"""``plot``: the panels of the paper for any dataset or curve, over the load or over another axis."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from itertools import product
from math import prod
from os import PathLike
from typing import Any

import matplotlib.style
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from thirdbody.attributes import GIVEN_AS
from thirdbody.conditions import axis_of, checked_variables
from thirdbody.files import DamagedFile, readable_file
from thirdbody.messages import format_value
from thirdbody.netcdf import OF_THE_FILE, read_plain
from thirdbody.plotting.curves import (
    BLUE,
    CURVE_FIGURES,
    LUBRICATED,
    curve_figure,
    draw_panels,
    level_styles,
    range_series,
)
from thirdbody.plotting.drawing import CURVE, STYLE, Drawing
from thirdbody.plotting.marks import read_turning_points
from thirdbody.plotting.panels import Panel, Series
from thirdbody.plotting.scales import SCALES, note
from thirdbody.variables import CONDITION_AXES, DIMENSIONS, NORMAL_LOAD, STATUS

MOST_CURVES = 24  # of which a legend names each
ALLOWED = (
    "a solution itself (not its to_dataframe), a curve, or a dataset of tb.grid, tb.stream, "
    "Solution.to_dataset or the workflow, also its table or NetCDF file"
)


def plot(
    data: Any,
    *,
    over: str | None = None,
    variables: str | Sequence[str] = LUBRICATED,
    like: str | None = None,
    turning_points: Sequence[Mapping] | str | PathLike = (),
    band: xr.Dataset | str | PathLike | None = None,
    ax: Axes | Sequence[Axes] | None = None,
) -> Figure:
    """Draw A_sa,t*, A_t*, L_s and H_c of any dataset of solved points over one of its axes.

    Parameters
    ----------
    data : Solution, Curve, xarray.Dataset, pandas.DataFrame or path
        A solution, a curve of ``Interface.curve`` with its ensemble range, a dataset of ``grid`` or
        ``Solution.to_dataset``, the table of such a dataset, or a file of ``stream`` or of the workflow.
        ``Solution.to_dataframe`` is no such table: its load in newtons does not give F_t*.
        Points in a list must be all combinations of their conditions.
    over : str, optional
        The axis along x, by any of its names, such as "load", "load_N" or "viscosity_cSt"; by default
        that of a curve, otherwise the load, in newtons if it was given so.  Over the load,
        one of viscosity, particle diameter and density may vary, in addition to dry and lubricated
        contact, and any number of roughnesses.  Over another axis, all others may vary: each
        combination is a curve.
    variables : str or sequence of str, optional
        Draw only these of the four quantities.
    like : str, optional
        Draw the panels of this figure of the paper, "fig03" to "fig13"; only over the load.
    turning_points : sequence of mapping, or path, optional
        Turning points to mark over the load: mappings of the four conditions [SI], ``load`` [1] and
        ``peak_ratio`` [1], or a file of the table ``tpca_loads`` of the workflow.
    band : xarray.Dataset or path, optional
        Ensemble range on the axes of ``data``, drawn over the load: a file in ``results/bands/``.
    ax : matplotlib.axes.Axes, or sequence of them, optional
        Draw there, one for each panel; by default on a new figure.

    Returns
    -------
    matplotlib.figure.Figure
        Save it with ``savefig``.

    Raises
    ------
    ValueError
        For data that are not such a dataset, vary in more conditions than one figure can
        distinguish, or have nothing to draw, and for an unknown axis or figure.
    OSError
        If a file cannot be read.
    ModuleNotFoundError
        If matplotlib is not installed: the extra ``figures`` installs it.

    Examples
    --------
    >>> import numpy as np
    >>> import thirdbody as tb
    >>> oils = dict(viscosity_cSt=[0, 50, 90], roughness_nm=300)
    >>> debris = dict(particle_diameter_nm=300, particle_density_per_m2=1e11)
    >>> points = tb.grid(load=np.geomspace(1e-6, 1e-4, 20), **oils, **debris)
    >>> figure = tb.plot(points)
    >>> figure.axes[0].get_ylabel()
    '$A_{sa,t}^*$'
    >>> tb.plot(points, over="viscosity").axes[0].get_xlabel()
    'Viscosity ν (cSt)'
    """
    if like is not None and like not in CURVE_FIGURES:
        raise ValueError(f"like is {like!r}; allowed: {', '.join(CURVE_FIGURES)}")
    variables = checked_variables(variables, LUBRICATED)
    axes = _checked_axes(ax)
    turning_points = _checked_turning_points(turning_points)
    if hasattr(data, "along") and hasattr(data, "points"):  # figures do not import ``Curve``
        over = None if over == data.along else over
        _refuse(data, over=over, like=like, band=band, turning_points=turning_points or None)
        return plot_curve(data, variables, axes)
    complete = _with_all_dimensions("data", data)
    in_newtons = GIVEN_AS in complete["load"].attrs and NORMAL_LOAD.name in complete
    over = over or ("load_N" if in_newtons else "load")
    along = axis_of(over).name
    if complete.sizes[along] < 2:
        raise ValueError(f"data has one {along}; allowed: two or more, which curves are drawn over")
    with matplotlib.style.context(STYLE, after_reset=True):
        if along != "load":
            return _plot_over(complete, along, variables, axes)
        ranges = None if band is None else _with_all_dimensions("band", band)
        drawn = curve_figure(like or "data", complete)
        chosen = tuple(each for each in drawn.contents if like or each.y in variables)
        if over == "load_N":
            if NORMAL_LOAD.name not in complete:
                raise ValueError("data has no normal_load; allowed: over='load'")
            chosen = tuple(
                replace(each, x=NORMAL_LOAD.name) if each.x == "load" else each for each in chosen
            )
        drawn = replace(drawn, contents=chosen)
        return drawn.plot(complete, turning_points, ranges, axes=axes)


def is_solution(data: Any) -> bool:
    """Whether ``data`` is a ``Solution``, which figures do not import."""
    return hasattr(data, "conditions") and hasattr(data, "to_dataset")


def _refuse(curve, **given):
    """``ValueError`` for arguments that are not for a curve, if they are given."""
    for name, value in given.items():
        if value is not None:
            message = f"{name} is {format_value(value)}, for a curve along {curve.along}"
            raise ValueError(f"{message}; allowed: None")


def _checked_turning_points(given) -> Sequence[Mapping]:
    """The rows of turning points, read if they are in a file."""
    if isinstance(given, Sequence) and all(isinstance(each, Mapping) for each in given):
        return given
    allowed = "mappings, or the path of a table tpca_loads"
    return read_turning_points(readable_file("turning_points", given, allowed))


def _checked_axes(ax) -> list[Axes]:
    """The axes to draw on, none for a new figure."""
    if ax is None:
        return []
    several = isinstance(ax, list | tuple) or getattr(ax, "dtype", None) == np.dtype("O")
    axes = list(np.ravel(np.asarray(ax, object))) if several else [ax]
    if not axes or not all(isinstance(each, Axes) for each in axes):
        raise ValueError(f"ax is {format_value(ax)}; allowed: axes of matplotlib")
    return axes


def _plot_over(
    data: xr.Dataset, over: str, variables: Collection[str], axes: Sequence[Axes]
) -> Figure:
    """Panels of ``variables`` over one axis, with a curve for each combination of the other axes."""
    others = [name for name in DIMENSIONS if name != over]
    varying = [name for name in others if data.sizes[name] > 1]
    common = [_note(data, name, data[name].values[0]) for name in others if name not in varying]
    names = [name for name in variables if name in data and bool(data[name].notnull().any())]
    if not names:
        raise ValueError(f"there is nothing to draw; allowed: points with {', '.join(LUBRICATED)}")
    count = prod(data.sizes[name] for name in varying)
    if count > MOST_CURVES:
        message = f"data make {count} curves over {over}"
        raise ValueError(
            f"{message}; allowed: at most {MOST_CURVES} (select some with sel or isel)"
        )
    curves = {}
    for values in product(*(data[name].values for name in varying)):
        label = ", ".join(_note(data, name, value) for name, value in zip(varying, values))
        curves[label] = data.sel(dict(zip(varying, values, strict=True))).squeeze()
    looks = level_styles(len(curves))
    if varying:
        looks = [look | {"label": label} for look, label in zip(looks, curves, strict=True)]
    panels = [_panel(over, data[over].values, name, curves, looks) for name in names]
    return draw_panels(panels, looks, common=common, axes=axes)


def plot_curve(
    curve: Any, variables: Collection[str] = LUBRICATED, axes: Sequence[Axes] = ()
) -> Figure:
    """Draw ``variables`` of the result of ``Interface.curve``, with its range if it has one."""
    units = {axis.alias: (axis.name, axis.scale) for axis in CONDITION_AXES}
    along, unit = units.get(curve.along, ("normal_load", 1.0))
    x = unit * np.asarray(curve.points)
    panels = [_panel(along, x, name, {"": curve.values}, [{"color": BLUE}]) for name in variables]
    for panel in panels:
        if f"{panel.y}_low" in curve.values:
            ends = curve.values[f"{panel.y}_low"], curve.values[f"{panel.y}_high"]
            panel.series.append(range_series("", x, *ends, BLUE))
    with matplotlib.style.context(STYLE, after_reset=True):
        return draw_panels(panels, [], axes=axes)


def _panel(over, x, name, curves, looks) -> Panel:
    """A panel of the variable ``name`` over ``x``, with a curve for each mapping of variables."""
    series = [
        Series(CURVE, label, x, np.asarray(values[name], float), look=look)
        for (label, values), look in zip(curves.items(), looks, strict=True)
    ]
    return Panel(SCALES[name].title, over, name, series)


def draw_comparison(comparison: pd.DataFrame, curve: pd.DataFrame) -> Figure:
    """Draw the result of ``thirdbody.compare``, a panel for each measured quantity, with the curve of the
    model and its ensemble range; if it has no rows, with a mark of the model beside each measurement."""
    along = comparison.attrs["along"]
    names = [summary["quantity"] for summary in comparison.attrs["summary"]]
    table = comparison.sort_values(along)
    model = curve if len(curve) else table
    x, measured = model[along], table[along]
    look = {"linestyle": "-"} if len(curve) else {"linestyle": "none", "marker": "+"}
    with matplotlib.style.context(STYLE, after_reset=True):
        figure = Drawing(figsize=(3.4 * len(names), 2.8), layout="constrained")
        for axes, name in zip(figure.subplots(1, len(names), squeeze=False)[0], names):
            axes.plot(x, model[f"{name}_model"], color=BLUE, label="model", **look)
            if f"{name}_low" in model:
                ends, label = (
                    (model[f"{name}_low"], model[f"{name}_high"]),
                    "5 to 95 % of the ensemble",
                )
                if len(curve):
                    axes.fill_between(x, *ends, color=BLUE, alpha=0.2, linewidth=0.0, label=label)
                else:
                    axes.vlines(x, *ends, color=BLUE, alpha=0.4, label=label)
            axes.plot(measured, table[name], "o", color="black", label="measured")
            if 0.0 < 10.0 * measured.min() < measured.max():
                axes.set_xscale("log")
            axes.set_xlabel(along.replace("_", " "))
            axes.set_ylabel(name.replace("_", " "))
        figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", ncols=3)
    return figure


def _note(data, name, value) -> str:
    """A condition with its symbol and unit; a load also in newtons."""
    text = note(name, float(value))
    if name != "load" or "normal_load" not in data:
        return text
    newtons = data["normal_load"].values[data["load"].values == value].flat[0]
    return f"{text} ({newtons:.3g} N)"


def _with_all_dimensions(name, data) -> xr.Dataset:
    """A dataset over the five axes in their order; missing ones have length one."""
    if is_solution(data):
        data = data.to_dataset()
        if STATUS not in data:  # not asked for
            data[STATUS] = xr.zeros_like(next(iter(data.values()), data["load"]), dtype=np.int8)
    if isinstance(data, str | PathLike):
        data = _read(readable_file(name, data, ALLOWED))
    if isinstance(data, pd.DataFrame):
        named = [each for each in data.index.names if each in DIMENSIONS]
        data = data.reset_index(named).reset_index(drop=True).to_xarray()
    if not isinstance(data, xr.Dataset):
        raise ValueError(f"{name} is of type {type(data).__name__}; allowed: {ALLOWED}")
    if any(each in variable.attrs for variable in data.variables.values() for each in OF_THE_FILE):
        data = xr.decode_cf(data, decode_times=False)
    missing = [each for each in DIMENSIONS if each not in data]
    if name == "data" and STATUS not in data:
        missing.append(STATUS)
    if 0 in data.sizes.values():
        missing.append("points")
    if missing:
        raise ValueError(f"{name} has no {missing[0]}; allowed: {ALLOWED}")
    data = data.set_coords(DIMENSIONS)
    if not set(data.dims) <= set(DIMENSIONS):
        data = _placed_on_axes(name, data)
    data = data.expand_dims([each for each in DIMENSIONS if data[each].ndim == 0])
    if NORMAL_LOAD.name in data:  # also where it was repeated along other axes
        newtons = data["load"].values * _newtons_per_load(data)
        data = data.drop_vars(NORMAL_LOAD.name).assign_coords(normal_load=("load", newtons))
    return data.transpose(*DIMENSIONS).sortby([*DIMENSIONS])


def _read(path) -> xr.Dataset:
    """The dataset in a file; ``OSError`` says what a file must be."""
    try:
        return read_plain(path).to_xarray()
    except DamagedFile as error:
        allowed = "a NetCDF file of tb.stream, of a dataset or of the workflow"
        raise OSError(f"{error}; allowed: {allowed}") from None


def _placed_on_axes(name, data) -> xr.Dataset:
    """Points along other dimensions on the five axes, if they are all combinations of their conditions."""
    table = data.reset_coords().to_dataframe()
    levels = [each for each in table.index.names if each not in table]
    table = table.reset_index(levels).set_index([*DIMENSIONS])
    complete = prod(map(len, table.index.remove_unused_levels().levels))
    if table.index.has_duplicates or len(table) != complete:
        other = next(each for each in data.dims if each not in DIMENSIONS)
        message = f"{name} has the dimension {other!r}, with points that are not all combinations"
        raise ValueError(f"{message}; allowed: one point for each of {', '.join(DIMENSIONS)}")
    placed = table.to_xarray()
    placed["load"].attrs = data["load"].attrs
    return placed


def _newtons_per_load(data) -> float:
    """F_t/F_t* [N] of a dataset."""
    return float(np.nanmax(data[NORMAL_LOAD.name].values) / np.nanmax(data["load"].values))
