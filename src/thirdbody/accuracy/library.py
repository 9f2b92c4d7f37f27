"""Golden points as the library solves them: by themselves, and among so many that it uses tables."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np

from thirdbody.accuracy.points import VARIABLES, Group
from thirdbody.interface import solve

COMPANY = 1000  # points of one surface beside which its tables are worth their while
LIGHTER = 0.5, 0.99  # their loads over those of the golden points, so that no two are equal


def solutions(group: Group, rtol: float) -> list:
    """Solutions of the points of ``group``, alone and in company, each with all of ``VARIABLES``,
    ``solution_status`` and ``error_bound`` as 1-D arrays."""
    count = len(group.rows)
    company = {name: np.resize(column, count + COMPANY) for name, column in group.conditions.items()}
    company["load"][count:] *= np.linspace(*LIGHTER, COMPANY)
    alone, among = (
        solve(**given, parameters=group.parameters, rtol=rtol) for given in (group.conditions, company)
    )
    names = (*VARIABLES, "solution_status", "error_bound")
    return [alone, SimpleNamespace(**{name: getattr(among, name)[:count] for name in names})]
