"""Points solved together: the way of a number from the conditions to the variables.

1. ``solve_points`` sorts points by kind and solves those of one kind together.
2. ``balance.Points.of`` has their summits and particles (``contact``), and their ``film``.
3. ``brackets.bracket`` finds separations d on both sides of the root of Eq. 1.
4. ``root.enclose`` narrows them by Newton's method, and checks the signs at both.
5. ``balance.Points.forces`` evaluates Eq. 1 at a separation: Eqs. 2 and 4 of the ``contact``, Eqs.
   7 and 8 of the ``film``.
6. ``state.describe`` derives the variables and the bound of their errors.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.core.balance import Points
from thirdbody.core.brackets import bracket
from thirdbody.core.film import has_film
from thirdbody.core.names import ERROR_BOUND, SOLUTION_STATUS
from thirdbody.core.parameters import Parameters
from thirdbody.core.particles import has_particles
from thirdbody.core.regimes import SOLUTION_STATUSES, has_values
from thirdbody.core.root import enclose
from thirdbody.core.state import describe, type_of
from thirdbody.core.summits import pieces_for

CONDITIONS = "load", "viscosity", "particle_diameter", "roughness", "particle_density"
DEFAULT_RTOL = 1e-9
ROUNDING_LIMIT = 1e-12  # tolerance of points limited only by rounding
TABLE_WORTH = 0.7  # points of one roughness per piece that make a table of its summits worthwhile
CHUNK = 65536  # points solved together
QUADRATURE_CHUNK = 2048  # by quadrature, where each point has about a hundred nodes
FEW_ITERATIONS, MOST_ITERATIONS = 5, 200  # the few points that need more are solved together
NOT_CONVERGED = SOLUTION_STATUSES.index("not_converged")
FAINT_COVERAGE = 1e-290  # x_a^2 eta_a [1] below which the area of particles loses digits


def solve_points(
    conditions: Mapping[str, NDArray],
    parameters: Parameters,
    rtol: float,
    variables: Collection[str],
    callback: Callable[[int], None] | None = None,
) -> dict[str, NDArray]:
    """Solve the force balance (Eq. 1) at many points.

    If enough points have the same roughness, its summits are tabulated.  The other points, and
    those that magnify the table error beyond ``rtol``, are solved by quadrature.

    Parameters
    ----------
    conditions : mapping of arrays
        The five ``CONDITIONS`` by name: F_t* [1], nu [m2/s], x_a [m], sigma [m] and eta_a [m-2],
        float64 arrays that broadcast against each other.  None is checked.
    parameters : Parameters
        Inputs of the model.
    rtol : float
        Requested relative error of every variable [1].
    variables : collection of str
        Names of the variables to return, among those of ``state.describe``.
    callback : callable, optional
        Called with the number of points that have been solved since its last call.

    Returns
    -------
    dict of arrays
        The variables by name, of the broadcast shape; nan, or -1 for regime and mode, where a point
        has no values.
    """
    shape = np.broadcast(*(conditions[name] for name in CONDITIONS)).shape
    columns = {name: np.broadcast_to(conditions[name], shape).ravel() for name in CONDITIONS}
    roughness = columns["roughness"]
    result = {name: np.empty(roughness.size, type_of(name)) for name in variables}
    with np.errstate(all="ignore"):  # points that cannot be computed get a status
        by_table = _worth_a_table(roughness, rtol)
        left = np.ones(roughness.shape, bool)
        for attempt in _attempts(rtol):
            chosen = left & by_table if attempt.uses_tables else left
            for batch in _batches(columns, chosen, attempt.chunk):
                conditions = {name: column[batch] for name, column in columns.items()}
                points = Points.of(conditions, parameters, attempt.table_rtol)
                brackets = bracket(points)
                for roots in enclose(points, brackets, attempt.tolerance, attempt.iterations):
                    solved, indices = describe(roots, rtol), batch[roots.indices]
                    for name, values in result.items():
                        values[indices] = solved[name]
                    failed = solved[SOLUTION_STATUS] == NOT_CONVERGED
                    left[indices] = failed & attempt.uses_tables
                    if callback is not None:
                        callback(int(np.count_nonzero(~left[indices])))
        _doubt_faint_particles(columns, result)
    return {name: values.reshape(shape) for name, values in result.items()}


def _doubt_faint_particles(columns, result):
    """Remove the bound where particles are so few or small that their area loses digits."""
    diameter, density = columns["particle_diameter"], columns["particle_density"]
    coverage = diameter * (diameter * density)
    faint = (coverage < FAINT_COVERAGE) & (diameter > 0.0) & (density > 0.0)
    if not faint.any():
        return
    if ERROR_BOUND in result:
        result[ERROR_BOUND][faint] = np.inf
    if SOLUTION_STATUS in result:
        status = result[SOLUTION_STATUS]
        status[faint & has_values(status)] = NOT_CONVERGED


class Attempt(NamedTuple):
    """A way to solve points.

    Tables of summits have the error ``table_rtol``; None is quadrature.  ``chunk`` points are
    solved together, to a ``tolerance`` of the variables, in at most ``iterations`` steps.
    """

    table_rtol: float | None
    chunk: int
    tolerance: float
    iterations: int

    @property
    def uses_tables(self) -> bool:
        """Whether the summits are read from tables."""
        return self.table_rtol is not None


def _attempts(rtol):
    """The attempts at a point, in their order: the first two are for points with tables."""
    tables = Attempt(table_rtol=rtol, chunk=CHUNK, tolerance=rtol, iterations=FEW_ITERATIONS)
    quadrature = Attempt(
        table_rtol=None,
        chunk=QUADRATURE_CHUNK,
        tolerance=ROUNDING_LIMIT,
        iterations=MOST_ITERATIONS,
    )
    return tables, tables._replace(iterations=MOST_ITERATIONS), quadrature


def _worth_a_table(roughness, rtol):
    """Whether enough points share the roughness of a point to tabulate its summits."""
    which = np.searchsorted(np.unique(roughness), roughness)
    return np.bincount(which)[which] >= TABLE_WORTH * pieces_for(rtol)


def _batches(columns, chosen, most):
    """Yield indices of ``chosen`` points, ``most`` at a time, in the order of the roughness.

    All points of a batch have particles, or none has; the same holds for the film.
    """
    three_body = has_particles(columns["particle_diameter"], columns["particle_density"])
    kinds = 2 * three_body + has_film(columns["viscosity"])
    for kind in np.flatnonzero(np.bincount(kinds[chosen])):
        indices = np.flatnonzero(chosen & (kinds == kind))
        indices = indices[np.argsort(columns["roughness"][indices], kind="stable")]
        yield from (indices[start : start + most] for start in range(0, indices.size, most))
