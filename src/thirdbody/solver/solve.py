"""``solve``: the contact state of any number of points, and the checks of its arguments."""

from __future__ import annotations

from collections.abc import Collection
from numbers import Real

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import LEAST
from thirdbody.solver.plan import check_way, solve_points
from thirdbody.solver.points import Conditions
from thirdbody.solver.solution import VARIABLES, Solution

DEFAULT_RTOL = 1e-9


def solve(
    load: ArrayLike,
    viscosity: ArrayLike,
    particle_diameter: ArrayLike,
    roughness: ArrayLike,
    particle_density: ArrayLike,
    parameters: Parameters,
    rtol: float = DEFAULT_RTOL,
    variables: Collection[str] = VARIABLES,
    way: str | None = None,
) -> Solution:
    """Contact state of the interface at each point (Eqs. 1-10).

    The first five arguments broadcast against each other.

    Parameters
    ----------
    load : array_like
        Dimensionless load F_t* = F_t/(A_n E_ss) [1], positive.
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

    Returns
    -------
    Solution
        Arrays of the broadcast shape.  ``solution_status`` says which points have no values, and
        which values to take with care; ``error_bound`` holds for numbers above 2.2e-308, below
        which float64 loses digits.

    Raises
    ------
    ValueError
        In one line: for a negative, infinite or missing number, a zero load or roughness, inputs
        that are no ``Parameters``, an ``rtol`` out of its range, an unknown variable or way, and a
        summit parameter that leaves no variance to the summits.
    ImportError
        If ``way`` is "compiled" and numba is not installed.

    Examples
    --------
    Two rough surfaces with particles of 0.5 um, dry and in an oil of 90 mm2/s:

    >>> import thirdbody
    >>> parameters = thirdbody.load_parameters()
    >>> found = thirdbody.solve(1e-5, [0.0, 90e-6], 0.5e-6, 0.3e-6, 1e11, parameters)
    >>> found.solid_load_fraction.round(4)
    array([1.    , 0.9018])
    >>> found.separation.round(10)  # [m]
    array([1.0295e-06, 1.0445e-06])
    """
    check_parameters(parameters)
    check_rtol(rtol)
    check_variables(variables)
    check_way(way)
    given = {
        "load": load,
        "viscosity": viscosity,
        "particle_diameter": particle_diameter,
        "roughness": roughness,
        "particle_density": particle_density,
    }
    columns = np.broadcast_arrays(*(checked_axis(name, value) for name, value in given.items()))
    conditions = Conditions(*map(np.ravel, columns))
    with np.errstate(all="ignore"):  # what cannot be computed gets a status
        found = solve_points(conditions, parameters, rtol, variables, way)
    shape = columns[0].shape
    return Solution(**{name: values.reshape(shape) for name, values in found.items()})


def check_parameters(parameters) -> None:
    """Raises ``ValueError`` unless ``parameters`` are what ``load_parameters`` gives."""
    if not isinstance(parameters, Parameters):
        kind = type(parameters).__name__
        raise ValueError(f"parameters is a {kind}; allowed: Parameters, as of load_parameters()")


def check_variables(variables, known: Collection[str] = VARIABLES) -> None:
    """Raises ``ValueError`` unless ``variables`` is a collection of names out of ``known``."""
    unknown = [name for name in variables if name not in known]
    if isinstance(variables, str) or unknown:
        shown = variables if isinstance(variables, str) else unknown[0]
        raise ValueError(f"variables has {shown!r}; allowed: a list out of {', '.join(known)}")


def check_rtol(rtol) -> None:
    """Raises ``ValueError`` unless ``rtol`` is within what float64 and the tables can promise."""
    if not isinstance(rtol, Real) or not 1e-11 <= rtol <= 1e-2:
        raise ValueError(f"rtol is {rtol!r}; allowed: 1e-11 to 1e-2")


def checked_axis(name: str, values: ArrayLike) -> NDArray:
    """``values`` as float64, or a ``ValueError`` that names the argument and its first bad value."""
    try:
        array = np.asarray(values)
    except ValueError:
        raise ValueError(f"{name} is a ragged list; allowed: numbers of one shape") from None
    if np.ma.is_masked(values):
        raise ValueError(f"{name} has masked values; allowed: numbers at every point")
    if array.dtype.kind not in "iuf":
        raise ValueError(f"{name} is of type {array.dtype}; allowed: numbers")
    array = np.asarray(array, float)
    zero_allowed = name not in ("load", "roughness")
    least = 0.0 if zero_allowed else LEAST
    if not (array.min(initial=1.0) >= least and array.max(initial=1.0) < np.inf):
        bad = array[~((array >= least) & np.isfinite(array))].flat[0]
        sign = "zero or positive" if zero_allowed else "positive"
        raise ValueError(f"{name} is {bad:g}; allowed: {sign} finite numbers")
    return array
