"""``plot``: the panels of the paper for any dataset, over the load or over another axis."""

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
from numpy.typing import NDArray

from thirdbody.conditions import axis_of, checked_variables, numbers_in, unit_of
from thirdbody.core.regimes import SOLUTION_STATUSES
from thirdbody.curves import LUBRICATED
from thirdbody.ensembles import MEMBER, range_over_members
from thirdbody.netcdf import OF_THE_FILE, read_plain
from thirdbody.plotting.drawing import STYLE
from thirdbody.plotting.load_curves import curve_figure, draw_panels
from thirdbody.plotting.maps import plot_map
from thirdbody.plotting.marks import range_series, read_turning_points, status_series
from thirdbody.plotting.panels import CURVE, Panel, Series
from thirdbody.plotting.scales import SCALES, note
from thirdbody.plotting.styles import BLUE, Look, level_styles
from thirdbody.symbols import unicode
from thirdbody.variables import (
    CONDITIONS,
    DIMENSIONS,
    NORMAL_LOAD,
    NUMBERS,
    SPEED,
    STATUS,
    decimal,
)


def plot(
    data: Any,
    *,
    over: str | Sequence[str] | None = None,
    variables: str | Sequence[str] = LUBRICATED,
    turning_points: Sequence[Mapping] | str | PathLike = (),
    ax: Axes | Sequence[Axes] | None = None,
    width_mm: float | None = None,
) -> Figure:
    """Draw A_sa,t*, A_t*, L_s and H_c of any dataset of solved points over one of its axes.

    Parameters
    ----------
    data : Solution, xarray.Dataset, pandas.DataFrame or path
        A solution, a dataset of ``grid`` or ``Solution.to_dataset``, the table of such a dataset,
        or a NetCDF file of ``stream`` or of the workflow.  ``Solution.to_dataframe`` is no such
        table: its load in newtons does not give F_t*.  Points in a list must be all combinations of
        their conditions.  Data of all members (``members=True``) are drawn as the curves of the
        best, with the range of the ensemble around some of them.
    over : str or pair of str, optional
        The axis along x, by any of its names, such as "load", "load_N" or "viscosity_cSt"; by
        default the load, in newtons if it was given so, or, where there is one load, the axis with
        most values. Over the load, one of the conditions that vary has colours, and each
        combination of the others has panels of its own.  Over another axis, each combination of the
        others is a curve.  Over two axes, as ("load_N", "viscosity_cSt"), contact modes and
        lubrication regimes are drawn as a map, with their names in its regions.
    variables : str or sequence of str, optional
        Draw only these of the four quantities.
    turning_points : sequence of mapping, or path, optional
        Turning points to mark over the load: mappings of the four conditions [SI], ``load`` [1] and
        ``peak_ratio`` [1], or a file of the table ``tpca_loads`` of the workflow.
    ax : matplotlib.axes.Axes, or sequence of them, optional
        Draw there, one for each panel; by default on a new figure.
    width_mm : float, optional
        Width of the figure: from 126 mm on its panels stand in two columns, else in one.  By
        default those of journals: 84 mm for one panel, 174 mm for several.

    Returns
    -------
    matplotlib.figure.Figure
        Save it with ``savefig``.

    Raises
    ------
    ValueError
        For data that are not all combinations of their conditions, vary in more conditions than one
        figure can distinguish, or have nothing to draw.
    OSError
        If a file cannot be read.
    ModuleNotFoundError
        If matplotlib is not installed: the extra ``plot`` installs it.

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
    'Viscosity $ν$ (cSt)'

    Where which contact mode and lubrication regime is:

    >>> figure = tb.plot(points, over=["load", "viscosity"])

    With the range of the ensemble:

    >>> loads = np.geomspace(1e-6, 1e-4, 5)
    >>> figure = tb.plot(tb.grid(load=loads, **oils, **debris, members=True))
    """
    names = checked_variables(variables, LUBRICATED)
    axes: list[Axes] = [] if ax is None else [*np.ravel(np.asarray(ax, object))]
    if isinstance(turning_points, str | PathLike):
        turning_points = read_turning_points(turning_points)
    complete = _with_all_dimensions(data)
    if over is None or isinstance(over, str):
        over = [over or _longest(complete)]
    along = [axis_of(each).name for each in over]
    for name in along:
        if complete.sizes[name] < 2:
            raise ValueError(f"data has one {name}; allowed: two or more, which are drawn over")
    width = width_mm and width_mm / 25.4
    with matplotlib.style.context(STYLE, after_reset=True):
        if len(along) > 1:
            return _plot_map(complete, over, along, axes, width)
        if along != ["load"]:
            return _plot_over(complete, along[0], names, axes, width)
        if complete.sizes.get(SPEED.name, 1) > 1:
            raise ValueError(f"data vary with the speed; allowed: over='{SPEED.alias}'")
        complete = complete.squeeze(SPEED.name, drop=True) if SPEED.name in complete else complete
        figure = curve_figure(complete)
        x = _drawn_over(over[0], along[0])
        contents = tuple(replace(each, x=x) for each in figure.contents if each.y in names)
        figure = replace(figure, contents=contents)
        return figure.plot(complete, turning_points, axes=axes, width=width)


def _drawn_over(given: str, name: str) -> str:
    """The variable along an axis that was ``given`` by any of its names."""
    return NORMAL_LOAD.name if given == "load_N" else name


def _plot_map(
    data: xr.Dataset,
    given: Sequence[str],
    along: Sequence[str],
    axes: Sequence[Axes],
    width: float | None,
) -> Figure:
    """A map over two axes of data that vary in no other one."""
    others = [name for name in _dimensions(data) if name not in along]
    varying = [name for name in others if data.sizes[name] > 1]
    if varying or len({*along}) != 2:
        message = f"a map is over two conditions; data also vary with {', '.join(varying)}"
        raise ValueError(f"{message}; allowed: one value of all others")
    common = [_note(data, name, data[name].values[0]) for name in others]
    x, y = map(_drawn_over, given, along)
    return plot_map(data.isel(dict.fromkeys(others, 0)), x, y, common, axes, width)


def _longest(data: xr.Dataset) -> str:
    """The load, by the name by which it was given, if it varies; or else the axis with most
    values."""
    if data.sizes["load"] < 2:
        return max(_dimensions(data), key=lambda name: data.sizes[name])
    return "load_N" if "load_N" in data and NORMAL_LOAD.name in data else "load"


def _plot_over(
    data: xr.Dataset,
    over: str,
    variables: Collection[str],
    axes: Sequence[Axes],
    width: float | None,
) -> Figure:
    """Panels of ``variables`` over one axis, with a curve for each combination of the other
    axes."""
    others = [name for name in _dimensions(data) if name != over]
    varying = [name for name in others if data.sizes[name] > 1]
    common = [_note(data, name, data[name].values[0]) for name in others if name not in varying]
    names = [name for name in variables if name in data and bool(data[name].notnull().any())]
    curves = {}
    for values in product(*(data[name].values for name in varying)):
        label = ", ".join(_note(data, name, value) for name, value in zip(varying, values))
        curves[label] = data.sel(dict(zip(varying, values, strict=True))).squeeze()
    looks = level_styles(len(curves), data.sizes[over])
    if varying:
        looks = [look | {"label": label} for look, label in zip(looks, curves, strict=True)]
    panels = [_panel(over, data[over].values, name, curves, looks) for name in names]
    return draw_panels(panels, [looks if varying else []], common=common, axes=axes, width=width)


def plot_curve(table: pd.DataFrame, along: str, conditions: Mapping[str, float]) -> Figure:
    """Draw the variables of one interface along one condition, with their ranges if there are some.

    Parameters
    ----------
    table : pandas.DataFrame
        A column ``along``, one for each of A_sa,t*, A_t*, L_s and H_c [SI], and beside it ``_low``
        and ``_high`` if it has a range: as in ``thirdbody.answers.curve``.
    along : str
        The condition along x, with its unit: ``load_N``, ``viscosity_cSt``, ...
    conditions : mapping
        The other conditions, by such names.  They stand below the panels.

    Returns
    -------
    matplotlib.figure.Figure
    """
    common = [_given_note(alias, value) for alias, value in conditions.items()]
    axis = axis_of(along)
    name, x = axis.name, table[along].to_numpy()
    if along == "load_N":
        name = NORMAL_LOAD.name
    else:
        x = axis.to_si(x)
    panels = [_panel(name, x, each, {"": table}, [{"color": BLUE}]) for each in LUBRICATED]
    with matplotlib.style.context(STYLE, after_reset=True):
        return draw_panels(panels, [], common=common)


def _panel(
    over: str, x: NDArray, name: str, curves: Mapping[str, Mapping], looks: Sequence[Look]
) -> Panel:
    """A panel of the variable ``name`` over ``x``, with a curve for each mapping of variables, its
    points that have not converged, and its range if it has one."""
    series = []
    for (label, values), look in zip(curves.items(), looks, strict=True):
        y = np.asarray(values[name], float)
        series.append(Series(CURVE, label, x, y, look=look))
        if STATUS in values:
            series += status_series(label, x, y, values)
        if f"{name}_low" in values:
            low, high = (np.asarray(values[f"{name}_{end}"], float) for end in ("low", "high"))
            series.append(range_series(label, x, low, high, look["color"]))
    return Panel(SCALES[name].title, over, name, series)


def _note(data: xr.Dataset, name: str, value: float) -> str:
    """A condition with its symbol and unit; a load also in newtons."""
    text = note(name, float(value))
    if name != "load" or "normal_load" not in data:
        return text
    newtons = data["normal_load"].values[data["load"].values == value].flat[0]
    return f"{text} ({newtons:.3g} N)"


def _given_note(alias: str, value: float) -> str:
    """A condition by its name with the unit, as a note."""
    if alias == "load_N":
        return f"{unicode(NORMAL_LOAD.symbol)} = {value:g} N"
    axis = axis_of(alias)
    return note(axis.name, float(axis.to_si(value)))


def _with_all_dimensions(data: Any) -> xr.Dataset:
    """A dataset over the five axes in their order; missing ones have length one."""
    if isinstance(data, str | PathLike):
        data = read_plain(data).to_xarray()
    elif isinstance(data, pd.DataFrame):
        named = [each for each in data.index.names if each in CONDITIONS]
        data = data.reset_index(named).reset_index(drop=True).to_xarray()
    elif not isinstance(data, xr.Dataset):
        data = data.to_dataset()
    if any(each in variable.attrs for variable in data.variables.values() for each in OF_THE_FILE):
        data = xr.decode_cf(data, decode_times=False)
    data = _of_best(_in_si(data))
    if STATUS not in data:  # not asked for
        data[STATUS] = xr.zeros_like(next(iter(data.values()), data["load"]), dtype=np.int8)
    elif data[STATUS].dtype.kind not in "iuf":  # names
        status = data[STATUS]
        codes = pd.Categorical(status.values.ravel(), SOLUTION_STATUSES).codes
        data[STATUS] = status.dims, codes.reshape(status.shape)
    dimensions = _dimensions(data)
    data = data.set_coords(dimensions)
    if not set(data.dims) <= set(dimensions):
        data = _placed_on_axes(data)
    data = data.expand_dims([each for each in dimensions if data[each].ndim == 0])
    if NORMAL_LOAD.name in data:  # also where it was repeated along other axes
        newtons = data["load"].values * _newtons_per_load(data)
        data = data.drop_vars(NORMAL_LOAD.name).assign_coords(normal_load=("load", newtons))
    return data.transpose(*dimensions).sortby([*dimensions])


def _dimensions(data: xr.Dataset) -> list[str]:
    """The five axes, and the speed, if it is one."""
    return [*DIMENSIONS, *([SPEED.name] if SPEED.name in data.variables else [])]


def _in_si(data: xr.Dataset) -> xr.Dataset:
    """The same data in the units in which they are drawn; ``ValueError`` for a unit of another
    dimension.
    """
    for name, variable in (CONDITIONS | NUMBERS | {NORMAL_LOAD.name: NORMAL_LOAD}).items():
        unit = data[name].attrs.get("units", variable.unit) if name in data else variable.unit
        if unit == variable.unit:
            continue
        if not unit_of(name, unit).is_compatible_with(unit_of(name, variable.unit)):
            raise ValueError(f"{name} is in {unit}; allowed: a unit such as {variable.unit}")
        values = decimal(numbers_in(name, data[name], variable.unit))
        attributes = data[name].attrs | {"units": variable.unit}
        data = data.assign({name: (data[name].dims, values, attributes)})
    return data


def _of_best(data: xr.Dataset) -> xr.Dataset:
    """Data of all members as those of the best, with both ends of the range over the members."""
    if MEMBER not in data.dims:
        return data
    best = data.isel({MEMBER: 0}, drop=True)
    for name in LUBRICATED:
        if name in data:
            ends = range_over_members([*data[name].transpose(MEMBER, ...).values])
            dims = best[name].dims
            best = best.assign({f"{name}_low": (dims, ends[0]), f"{name}_high": (dims, ends[1])})
    return best


def _placed_on_axes(data: xr.Dataset) -> xr.Dataset:
    """Points along other dimensions on the five axes, if they are all combinations of their
    conditions.
    """
    table = data.reset_coords().to_dataframe()
    levels = [each for each in table.index.names if each not in table]
    table = table.reset_index(levels).set_index(_dimensions(data))
    complete = prod(map(len, table.index.remove_unused_levels().levels))
    if len(table) != complete:
        other = next(each for each in data.dims if each not in DIMENSIONS)
        message = f"data has the dimension {other!r}, with points that are not all combinations"
        raise ValueError(f"{message}; allowed: one point for each of {', '.join(DIMENSIONS)}")
    return table.to_xarray()


def _newtons_per_load(data: xr.Dataset) -> float:
    """F_t/F_t* [N] of a dataset."""
    return float(np.nanmax(data[NORMAL_LOAD.name].values) / np.nanmax(data["load"].values))
