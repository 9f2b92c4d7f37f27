"""Golden points as the library solves them, in one call."""

from __future__ import annotations

import warnings

from benchmarks.points import Group
from thirdbody.solver.solution import Solution
from thirdbody.solver.solve import solve
from thirdbody.solver.usual import OutOfRangeWarning


def solutions(group: Group, rtol: float) -> list[Solution]:
    """Solve golden points, all in one call.

    Parameters
    ----------
    group : Group
        Golden points.
    rtol : float
        Relative error asked for [1].

    Returns
    -------
    list of Solution
        One, whose variables have the shape (points,).
    """
    given = group.conditions | {"parameters": group.parameters, "rtol": rtol}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", OutOfRangeWarning)  # the domain reaches farther
        return [solve(**given)]
