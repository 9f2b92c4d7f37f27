"""``solve``: the contact state of any number of points."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.model.parameters import Parameters
from thirdbody.progress import Progress, check_progress
from thirdbody.solver.arguments import (
    PLAIN_NUMBERS,
    check_named_points,
    check_parameters,
    check_points,
    check_rtol,
    check_variables,
    checked_axis,
)
from thirdbody.solver.labelled import broadcast_by_name, is_labelled, labelled_as, with_names
from thirdbody.solver.plan import check_way, solve_numbers, solve_points, threads_worth
from thirdbody.solver.points import Axis, Conditions
from thirdbody.solver.solution import VARIABLES, Solution
from thirdbody.solver.usual import warn_beyond_usual

DEFAULT_RTOL = 1e-9


def solve(
    *,
    load: ArrayLike,
    viscosity: ArrayLike,
    particle_diameter: ArrayLike,
    roughness: ArrayLike,
    particle_density: ArrayLike,
    parameters: Parameters,
    rtol: float = DEFAULT_RTOL,
    variables: Collection[str] = VARIABLES,
    way: str | None = None,
    progress: bool = True,
) -> Solution:
    """Contact state of the interface at each point (Eqs. 1-10).

    The five conditions broadcast against each other, and are given by name: numbers in the unit that
    is said here, or quantities of pint in any unit of the same dimension.  Arrays of xarray broadcast
    by the names of their dimensions.

    Parameters
    ----------
    load : array_like
        Dimensionless load F_t* = F_t/(A_n E_ss) [1], positive; of pint, a force F_t as well.
    viscosity : array_like
        Kinematic viscosity of the lubricant [m2/s]; 0 where the interface is dry.
    particle_diameter : array_like
        Mean diameter x_a of the particles [m]; 0 where there are none (two-body contact).
    roughness : array_like
        Equivalent root mean square roughness sigma [m], from 1e-30 to 1e30.
    particle_density : array_like
        Number eta_a of particles per area [m-2]; 0 where there are none (two-body contact).
    parameters : Parameters
        Materials, geometry and readings of the model.
    rtol : float
        Relative error asked for in every variable, from 1e-11 to 1e-2.
    variables : collection of str
        Names of the fields of ``Solution`` that are wanted; the others are None.
    way : {"quadrature", "tables", "compiled", "repeatable"}, optional
        How points are solved: by integrals over the summits, by tables of these, or in machine
        code.  Points that a way cannot solve to ``rtol`` are solved by one more precise.  By
        default what takes least time for so many points in this process, the loading of a compiler
        included.  "repeatable" chooses one of the first two by the number of points alone: the same
        points have the same last digits, whatever the process has solved before.
    progress : bool, optional
        Whether a call that takes long says how far it has come, on the standard error stream: by a
        bar on a terminal, after two seconds, else by a line every half a minute.

    Returns
    -------
    Solution
        Arrays of the broadcast shape: of xarray, with dimensions and coordinates, if a condition is.
        ``solution_status`` says which points have no values, and which values to take with care;
        ``error_bound`` holds for numbers above 2.2e-308, below which float64 loses digits.

    Raises
    ------
    ValueError
        In one line: for a negative, infinite or missing number, a zero load or roughness, a quantity
        of another dimension, arrays that do not broadcast, more than 1e9 points, inputs that are no
        ``Parameters``, an ``rtol`` out of its range, an unknown variable or way, a ``progress`` that
        is no bool, and a summit parameter that leaves no variance to the summits.
    ImportError
        If ``way`` is "compiled" and numba is not installed.

    Warns
    -----
    OutOfRangeWarning
        Once, for conditions so far beyond those of real interfaces that another unit must be meant:
        F_t* above 0.02, nu above 0.01 m2/s, sizes above 1 mm, more than 1e16 particles per m2.

    Examples
    --------
    Two rough surfaces with particles of 0.5 um, dry and in an oil of 120 mm2/s:

    >>> import thirdbody as tb
    >>> given = dict(particle_diameter=0.5e-6, roughness=0.3e-6, particle_density=1e11)
    >>> given["parameters"] = tb.load_parameters()
    >>> found = tb.solve(load=1e-5, viscosity=[0.0, 120e-6], **given)
    >>> found.solid_load_fraction.round(4)
    array([1.    , 0.6547])
    >>> found.separation.round(10)  # [m]
    array([1.0397e-06, 1.1274e-06])

    Loads and viscosities with names make a table of both:

    >>> import xarray as xr
    >>> loads = xr.DataArray([1e-6, 1e-5], dims="load")
    >>> oils = xr.DataArray([0.0, 120e-6], dims="oil", coords={"oil": ["none", "thick"]})
    >>> found = tb.solve(load=loads, viscosity=oils, **given)
    >>> found.solid_load_fraction.sel(oil="thick").round(4).values
    array([1.    , 0.6547])
    """
    check_parameters(parameters)
    check_rtol(rtol)
    check_variables(variables)
    check_way(way)
    check_progress(progress)
    given = {
        "load": load,
        "viscosity": viscosity,
        "particle_diameter": particle_diameter,
        "roughness": roughness,
        "particle_density": particle_density,
    }
    axes = _checked_axes(given, parameters)
    greatest = {name: axis.greatest for name, axis in axes.items()}
    warn_beyond_usual(greatest)
    arrays = {name: axis.values for name, axis in axes.items()}
    if way is None and all(type(each) in PLAIN_NUMBERS for each in given.values()):
        with np.errstate(all="ignore"):
            found = solve_numbers(greatest, parameters, rtol, variables)
        if found is not None:
            return Solution(**found, conditions=arrays)
    if not any(map(is_labelled, given.values())):
        return solve_arrays(arrays, parameters, rtol, variables, way, progress, axes)
    check_named_points({name: each for name, each in given.items() if is_labelled(each)})
    named = with_names(given, arrays)
    arrays, pattern = broadcast_by_name(named)
    solution = solve_arrays(arrays, parameters, rtol, variables, way, progress, axes)
    return labelled_as(pattern, solution, named)


def _checked_axes(given, parameters):
    """What ``checked_axis`` makes of each condition, by its name; of large arrays by threads, as each
    is read from memory as a whole."""
    sizes = [each.size for each in given.values() if isinstance(each, np.ndarray)]
    threads = threads_worth(max(sizes, default=1))
    if threads == 1:
        return {name: checked_axis(name, each, parameters) for name, each in given.items()}
    with ThreadPoolExecutor(threads) as pool:
        checks = {
            name: pool.submit(checked_axis, name, each, parameters) for name, each in given.items()
        }
    return {name: check.result() for name, check in checks.items()}


def solve_arrays(
    arrays: Mapping[str, NDArray],
    parameters: Parameters,
    rtol: float,
    variables: Collection[str],
    way: str | None = None,
    progress: bool = False,
    axes: Mapping[str, Axis] | None = None,
) -> Solution:
    """What ``solve`` returns for conditions, by name, that have been checked; ``axes`` are what they
    were taken from, if that is known."""
    check_points(arrays)
    columns = list(arrays.values())
    if len({column.shape for column in columns}) > 1:
        columns = np.broadcast_arrays(*columns)
    shape = columns[0].shape
    conditions = Conditions(
        **{name: column.ravel() for name, column in zip(arrays, columns, strict=True)}
    )
    axes = axes or {name: Axis.of(values) for name, values in arrays.items()}
    # what cannot be computed gets a status
    with np.errstate(all="ignore"), Progress(conditions.size, "points", progress) as shown:
        found = solve_points(conditions, axes, parameters, rtol, variables, way, shown.add)
    variables = {name: values.reshape(shape) for name, values in found.items()}
    return Solution(**variables, conditions=dict(arrays))
