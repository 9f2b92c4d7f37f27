"""Golden points as the library solves them: alone, and among so many that it takes tables, or the
compiled loop."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np

from benchmarks.points import VARIABLES, Group
from thirdbody.solver.solve import COMPILATION_WORTH, TABLE_WORTH, solve

COMPANIES = 0, 2 * TABLE_WORTH, COMPILATION_WORTH  # points of the surface beside them
LIGHTER = 0.5, 0.99  # their loads over those of the golden points, so that no two are equal


def solutions(group: Group, rtol: float) -> list:
    """Solutions of the points of ``group`` in each company, each with all of ``VARIABLES``,
    ``solution_status`` and ``error_bound`` as 1-D arrays."""
    return [_solution(group, company, rtol) for company in COMPANIES]


def _solution(group, company, rtol):
    count = len(group.rows)
    given = {name: np.resize(column, count + company) for name, column in group.conditions.items()}
    given["load"][count:] *= np.linspace(*LIGHTER, company)
    solved = solve(**given, parameters=group.parameters, rtol=rtol)
    names = (*VARIABLES, "solution_status", "error_bound")
    return SimpleNamespace(**{name: getattr(solved, name)[:count] for name in names})
