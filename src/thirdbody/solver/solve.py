"""``solve``: the contact state of any number of points."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace
from enum import IntFlag
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.arguments import (
    CONDITIONS,
    broadcast_by_name,
    check_points,
    check_rtol,
    checked_names,
    checked_parameters,
    common_index,
    in_si,
)
from thirdbody.model.film import has_film
from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import has_particles
from thirdbody.model.regimes import SOLUTION_STATUSES
from thirdbody.model.summits import pieces_for
from thirdbody.progress import Progress, check_progress
from thirdbody.solver.balance import enclose
from thirdbody.solver.brackets import bracket
from thirdbody.solver.points import Points
from thirdbody.solver.solution import VARIABLES, Solution, describe, type_of
from thirdbody.units import is_labelled, units_in_tables

DEFAULT_RTOL = 1e-9
ROUNDING_LIMIT = 1e-12  # tolerance of points limited only by rounding
TABLE_WORTH = 0.7  # points of one roughness per piece that make a table of its summits worthwhile
CHUNK = 65536  # points solved together
QUADRATURE_CHUNK = 2048  # by quadrature, where each point has about a hundred nodes
FEW_ITERATIONS, MOST_ITERATIONS = 5, 200  # the few points that need more are solved together
NOT_CONVERGED = SOLUTION_STATUSES.index("not_converged")


def solve(
    *,
    parameters: Parameters | None = None,
    rtol: float = DEFAULT_RTOL,
    variables: str | Collection[str] | None = None,
    progress: bool = True,
    **conditions: ArrayLike,
) -> Solution:
    """Contact state of the interface at each point (Eqs. 1-10).

    The five conditions are given by name and broadcast against each other.  Each is a number in the
    unit of its name, or a quantity of pint, astropy, unyt or quantities in any compatible unit.
    Arrays of xarray broadcast by dimension name; their attribute ``units`` is used.  Columns of
    pandas, which must have equal indexes, give results with that index in ``to_dataframe``.

    Parameters
    ----------
    load, load_N : array_like
        Dimensionless load F_t* = F_t/(A_n E_ss) [1], positive, or F_t [N].  Of each condition, give
        one of the two names.
    viscosity, viscosity_cSt : array_like
        Kinematic viscosity of the lubricant [m2/s] or [cSt]; 0 for dry contact.
    particle_diameter, particle_diameter_nm : array_like
        The mean diameter of the paper, x_a [m] or [nm]; 0 for two-body contact.  If the
        ``mean_ratio`` of the inputs is 0, nearly all particles are smaller.
    roughness, roughness_nm : array_like
        Equivalent root mean square roughness sigma [m] or [nm], from 1e-30 m to 1e30 m, where the power laws
        of ``parameters`` do not lift the summits too high: with the calibrated ones from 1e-11 m.
        ``thirdbody.equivalent_roughness`` gives it from Rq or Ra of two surfaces.
    particle_density, particle_density_per_m2 : array_like
        Number eta_a of particles per area [m-2]; 0 for two-body contact.
    parameters : Parameters, optional
        Materials, geometry and interpretations of the model, by default the calibrated ones.
    rtol : float
        Requested relative error of every variable, from 1e-11 to 1e-2.  A larger one saves little time
        here, much in ``grid``.
    variables : str or collection of str, optional
        Names of the fields of ``Solution`` to keep; the others are None.
    progress : bool, optional
        Whether a long call reports progress on standard error: a bar on a terminal, after two
        seconds, otherwise a line every half minute.

    Returns
    -------
    Solution
        Arrays of the broadcast shape; of xarray, with dimensions and coordinates, if a condition
        is.  ``solution_status`` marks points without values, and values to use with care;
        ``error_bound`` is valid for numbers above 2.2e-308, below which float64 loses digits.

    Raises
    ------
    ValueError
        For a negative, infinite or missing number, a zero load or roughness, a quantity of the
        wrong dimension, arrays that do not broadcast, more than 1e9 points, inputs that are not
        ``Parameters``, an ``rtol`` out of range, an unknown variable, a ``progress`` that is not a
        bool, and particles with an ``elastic_factor`` of ``Parameters`` above 1.

    Warns
    -----
    OutOfRangeWarning
        Once, for conditions outside their usual ranges, probably given in another unit: F_t* 1e-13 to 0.02,
        nu 3e-7 to 0.01 m2/s, x_a 1 nm to 1 mm, sigma 1 nm to 1 mm, eta_a 1e6 to 1e16 m-2.

    Examples
    --------
    Two rough surfaces with particles of 0.5 um, dry and in an oil of 120 mm2/s:

    >>> import thirdbody as tb
    >>> given = dict(particle_diameter=0.5e-6, roughness_nm=300, particle_density=1e11)
    >>> found = tb.solve(load=1e-5, viscosity_cSt=[0, 120], **given)
    >>> found.solid_load_fraction.round(4)
    array([1.    , 0.8232])
    >>> found.separation.round(10)  # [m]
    array([1.1302e-06, 1.2537e-06])

    Loads and viscosities with named dimensions give a table:

    >>> import xarray as xr
    >>> loads = xr.DataArray([1e-6, 1e-5], dims="load")
    >>> oils = xr.DataArray([0.0, 120e-6], dims="oil", coords={"oil": ["none", "thick"]})
    >>> found = tb.solve(load=loads, viscosity=oils, **given)
    >>> found.solid_load_fraction.sel(oil="thick").round(4).values
    array([0.9995, 0.8232])
    """
    parameters = checked_parameters(parameters)
    check_rtol(rtol)
    variables = VARIABLES if variables is None else checked_names("variables", variables, VARIABLES)
    check_progress(progress)
    arrays = in_si(conditions, parameters)  # copies, which the caller cannot change later
    units = units_in_tables(conditions)
    if not any(map(is_labelled, conditions.values())):
        check_points(arrays, conditions)
        solution = solve_arrays(arrays, parameters, rtol, variables, progress)
        return replace(solution, units=units)._with_index(common_index(conditions))
    named, arrays, pattern = broadcast_by_name(conditions, arrays)
    solution = solve_arrays(arrays, parameters, rtol, variables, progress)
    known = {
        name: pattern.copy(data=values).rename(name) for name, values in solution.known.items()
    }
    return replace(solution, **known, conditions=named, units=units)


def solve_arrays(
    arrays: Mapping[str, NDArray],
    parameters: Parameters,
    rtol: float,
    variables: Collection[str],
    progress: bool = False,
) -> Solution:
    """What ``solve`` returns, for ``arrays`` of checked conditions by name.

    If enough points have the same roughness, its summits are tabulated.  The other points, and those
    that magnify the table error beyond ``rtol``, are solved by quadrature.
    """
    check_points(arrays)
    shape = np.broadcast(*(arrays[name] for name in CONDITIONS)).shape
    columns = {name: np.broadcast_to(arrays[name], shape).ravel() for name in CONDITIONS}
    roughness = columns["roughness"]
    result = {name: np.empty(roughness.size, type_of(name)) for name in variables}
    # points that cannot be computed get a status
    with np.errstate(all="ignore"), Progress(roughness.size, "points", progress) as bar:
        by_table = _worth_a_table(roughness, rtol)
        left = np.ones(roughness.shape, bool)
        for attempt in _attempts(rtol):
            chosen = left & by_table if attempt.uses_tables else left
            for places, balance in _balances(columns, chosen, parameters, attempt):
                found = describe(balance, rtol)
                for name, values in result.items():
                    values[places] = found[name]
                failed = found["solution_status"] == NOT_CONVERGED
                left[places] = failed & attempt.uses_tables
                bar.add(np.count_nonzero(~left[places]))
    solved = {name: values.reshape(shape) for name, values in result.items()}
    return Solution(**solved, conditions=dict(arrays), newtons_per_load=parameters.newtons_per_load)


class Attempt(NamedTuple):
    """How points are solved: from tables of summits with an error ``table_rtol``, or by quadrature if
    it is None; so many at a time, to a ``tolerance`` of the variables, in at most so many iterations."""

    table_rtol: float | None
    chunk: int
    tolerance: float
    iterations: int

    @property
    def uses_tables(self) -> bool:
        """Whether the summits are read from tables."""
        return self.table_rtol is not None


def _attempts(rtol):
    """Attempts at each point, until one succeeds; the first two only where tables are worthwhile."""
    tables = Attempt(table_rtol=rtol, chunk=CHUNK, tolerance=rtol, iterations=FEW_ITERATIONS)
    quadrature = Attempt(
        table_rtol=None,
        chunk=QUADRATURE_CHUNK,
        tolerance=ROUNDING_LIMIT,
        iterations=MOST_ITERATIONS,
    )
    return tables, tables._replace(iterations=MOST_ITERATIONS), quadrature


def _worth_a_table(roughness, rtol):
    """Which points share their roughness with enough others to tabulate its summits."""
    which = np.searchsorted(np.unique(roughness), roughness)
    return np.bincount(which)[which] >= TABLE_WORTH * pieces_for(rtol)


def _balances(columns, chosen, parameters, attempt):
    """Solve the ``chosen`` points: yields the places of some among all, and their balance."""
    for batch in _batches(columns, chosen, attempt.chunk):
        conditions = {name: column[batch] for name, column in columns.items()}
        points = Points.of(conditions, parameters, attempt.table_rtol)
        for balance in enclose(points, bracket(points), attempt.tolerance, attempt.iterations):
            yield batch[balance.places], balance


class Kind(IntFlag):
    """What points have that are solved together."""

    PARTICLES = 1
    FILM = 2


def _batches(columns, chosen, most):
    """Yield indices of ``chosen`` points of one kind, by roughness, at ``most`` so many at a time."""
    three_body = has_particles(columns["particle_diameter"], columns["particle_density"])
    kinds = Kind.PARTICLES * three_body + Kind.FILM * has_film(columns["viscosity"])
    for kind in np.flatnonzero(np.bincount(kinds[chosen])):
        places = np.flatnonzero(chosen & (kinds == kind))
        places = places[np.argsort(columns["roughness"][places], kind="stable")]
        yield from (places[start : start + most] for start in range(0, places.size, most))
