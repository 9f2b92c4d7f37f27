"""Solved points as a dataset with names and units over the five axes, for a grid or for a scene
(the curves of one figure)."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.conditions.checks import check_names, check_rtol, checked_parameters
from thirdbody.conditions.in_si import in_si
from thirdbody.data.attributes import coordinate_attributes, global_attributes, variable_attributes
from thirdbody.data.conditions import AXES, CONDITION_AXES, DIMENSIONS, Condition
from thirdbody.data.netcdf import PlainDataset, Variable
from thirdbody.data.quantities import (
    CONTRACT,
    FILL_FLAG,
    FILL_FLOAT,
    FLAGS,
    NORMAL_LOAD,
    NUMBERS,
    SEPARATION_COUNT,
    STATUS,
    VARIABLES,
)
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import SOLUTION_STATUSES
from thirdbody.progress import check_progress
from thirdbody.solver.solve import DEFAULT_RTOL, solve, solve_arrays
from thirdbody.solver.sweep import is_worthwhile, sweep

if TYPE_CHECKING:
    import xarray as xr

RELATIVE_DIAMETER = "particle_diameter_per_roughness"  # key that may replace the diameter
SEVERAL = SOLUTION_STATUSES.index("several_separations")
Axes = Mapping[str, NDArray[np.float64]]  # 1-D and increasing, by name, in the order of DIMENSIONS


def grid(
    *,
    parameters: Parameters | None = None,
    rtol: float = DEFAULT_RTOL,
    variables: Collection[str] = CONTRACT,
    progress: bool = True,
    **conditions: ArrayLike,
) -> xr.Dataset:
    """Solve every combination of five axes and return a dataset.

    Parameters
    ----------
    parameters : Parameters, optional
        Inputs of the model, by default the published ones.
    rtol : float, optional
        Requested relative error of every variable [1].  From 1e-3 on, large grids are interpolated
        over the separation, in a fifth of the time; below, every point is solved individually.
    variables : collection of str, optional
        Variables of ``Solution`` to compute; ``solution_status`` is always included, and
        ``separation_count`` if a point has the status ``several_separations``.
    progress : bool, optional
        Whether a long call reports its progress, as in ``solve``.
    **conditions : array_like, shape (n,) or scalar
        The five axes, increasing, as numbers or quantities: ``load`` [1] or ``load_N``, ``viscosity``
        [m2/s] or ``viscosity_cSt``, ``particle_diameter`` [m] or ``particle_diameter_nm``,
        ``roughness`` [m] or ``roughness_nm``, ``particle_density`` [m-2] or
        ``particle_density_per_m2``.  Viscosity 0 is dry contact; diameter or density 0 is two-body
        contact.

    Returns
    -------
    xarray.Dataset
        Dimensions are the five axes.  ``solution_status`` is the status of each point; points
        without values are nan.

    Raises
    ------
    ValueError
        For an axis that is missing, not 1-D, not increasing or not physical, a quantity of the
        wrong dimension, more than 1e9 points, inputs that are not ``Parameters``, an ``rtol`` out
        of range, or an unknown variable.

    Warns
    -----
    OutOfRangeWarning
        As in ``solve``.

    Examples
    --------
    >>> import thirdbody as tb
    >>> oil = dict(viscosity_cSt=[0, 90], roughness_nm=300)
    >>> debris = dict(particle_diameter_nm=300, particle_density_per_m2=1e11)
    >>> points = tb.grid(load_N=[1, 10], **oil, **debris, variables=["solid_load_fraction"])
    >>> points["solid_load_fraction"].squeeze().shape
    (2, 2)
    >>> points["solid_load_fraction"].sel(viscosity=0.0).values.ravel()
    array([1., 1.])
    """
    parameters, names, axes = checked_grid(parameters, rtol, variables, progress, conditions)
    wanted = dict.fromkeys([*names, SEPARATION_COUNT.name])
    if is_worthwhile(axes, rtol):
        solution = sweep(axes, parameters, rtol, wanted, progress)
    else:
        solution = solve_arrays(crossed(axes), parameters, rtol, wanted, progress)
    values = {name: getattr(solution, name) for name in wanted}
    if SEPARATION_COUNT.name not in names:
        _keep_counts_of_several(values)
    return described_grid(axes, values, parameters, rtol).to_xarray()


def checked_grid(
    parameters: Parameters | None,
    rtol: float,
    variables: Collection[str],
    progress: bool,
    conditions: Mapping[str, ArrayLike],
) -> tuple[Parameters, list[str], Axes]:
    """Inputs, variables and axes [SI] of ``grid``; the status, which explains nan, is always included."""
    parameters = checked_parameters(parameters)
    check_rtol(rtol)
    check_progress(progress)
    check_names("variables", variables, VARIABLES)
    names = [name for name in VARIABLES if name in variables or name == STATUS]
    return parameters, names, in_si(conditions, parameters, check=_checked_increasing)


def _checked_increasing(key: str, values: NDArray) -> NDArray:
    axis = np.atleast_1d(values)
    if axis.ndim != 1 or axis.size == 0:
        raise ValueError(f"{key} has shape {axis.shape}; allowed: one increasing dimension")
    back = np.flatnonzero(np.diff(axis) <= 0.0)
    if back.size:
        first, second = axis[back[0] :][:2]
        message = f"{second:g} after {first:g}; allowed: one increasing dimension"
        raise ValueError(f"{key} has {message}")
    return axis


def crossed(sides: Axes) -> dict[str, NDArray[np.float64]]:
    """The axes ``sides`` of a grid as arrays that broadcast to all points."""
    return dict(zip(sides, np.ix_(*sides.values()), strict=True))


def described_grid(
    axes: Axes,
    values: Mapping[str, NDArray],
    parameters: Parameters,
    rtol: float,
    title: str = "Three-body contact on a grid",
    request: Mapping | None = None,
) -> PlainDataset:
    """The dataset of ``values``, an array over all ``axes`` for each variable, with coordinates and
    attributes.  Its SHA-256 depends on the ``request``, by default the axes."""
    variables = {
        name: Variable(DIMENSIONS, values[name], variable_attributes(quantity))
        for name, quantity in VARIABLES.items()
        if name in values
    }
    coordinates = {
        name: Variable((name,), axis, coordinate_attributes(AXES[name]))
        for name, axis in axes.items()
    }
    newtons = axes["load"] * parameters.newtons_per_load
    coordinates["normal_load"] = Variable(("load",), newtons, coordinate_attributes(NORMAL_LOAD))
    request = request or _listed(axes)
    attributes = global_attributes(title, parameters, axes["roughness"], rtol, request)
    return PlainDataset(variables, coordinates, attributes)


def scene_groups(scene: Mapping, newtons_per_load: float) -> list[Axes]:
    """The groups of curves in a valid entry of ``config/scenes.yaml``, each with every combination
    of five axes, with the same loads; curves in several groups are shown once.

    Loads are logarithmically spaced, plus those named in the text between the ends.  Diameters
    relative to the roughness make a group for each roughness.
    """
    axis = scene["load_axis"]
    first, last = (AXES["load"].to_si(newtons / newtons_per_load) for newtons in axis["load_N"])
    named = [load for load in scene.get("named_loads", []) if first <= load <= last]
    load = np.unique([*np.geomspace(first, last, axis["count"]), *named])
    entries = []
    for entry in scene["curves"]:
        if RELATIVE_DIAMETER not in entry:
            entries.append(entry)
            continue
        for sigma in entry["roughness_nm"]:
            diameters = [ratio * sigma for ratio in entry[RELATIVE_DIAMETER]]
            entries.append(entry | {"roughness_nm": [sigma], "particle_diameter_nm": diameters})
    return [
        {"load": load} | {axis.name: axis.values(entry[axis.key]) for axis in CONDITION_AXES}
        for entry in entries
    ]


def scene_dataset(
    scene: Mapping, parameters: Parameters, rtol: float = DEFAULT_RTOL
) -> PlainDataset:
    """The dataset of one figure, an entry of ``config/scenes.yaml``: all variables of ``CONTRACT``
    over the five axes, and ``separation_count`` if a point has several separations.

    Combinations not shown in the figure have ``FILL_FLOAT`` or ``FILL_FLAG``.  ``ValueError`` if
    ``rtol`` or a value on an axis is out of bounds.
    """
    groups = scene_groups(scene, parameters.newtons_per_load)
    axes = {
        name: np.unique(np.concatenate([group[name] for group in groups])) for name in DIMENSIONS
    }
    shape = tuple(axis.size for axis in axes.values())
    values = {name: np.full(shape, FILL_FLOAT) for name in NUMBERS}
    values |= {name: np.full(shape, FILL_FLAG) for name in (*FLAGS, SEPARATION_COUNT.name)}
    for group in groups:
        place = np.ix_(*(np.searchsorted(axes[name], group[name]) for name in DIMENSIONS))
        solution = solve(**crossed(group), parameters=parameters, rtol=rtol)
        for name in values:
            values[name][place] = getattr(solution, name)
    _keep_counts_of_several(values)
    listed = [_listed(group) for group in groups]
    request = {
        "load": listed[0]["load"],
        "groups": [{n: g[n] for n in Condition._fields} for g in listed],
    }
    return described_grid(axes, values, parameters, rtol, scene["title"], request)


def _listed(axes: Axes) -> dict[str, list[float]]:
    return {name: values.tolist() for name, values in axes.items()}


def _keep_counts_of_several(values):
    """Drop the counts of separations from ``values`` if no point has several."""
    if not (values[STATUS] == SEVERAL).any():
        del values[SEPARATION_COUNT.name]
