"""Golden points as the library solves them, by each of its ways."""

from __future__ import annotations

from benchmarks.points import Group
from thirdbody.solver.plan import WAYS
from thirdbody.solver.solution import Solution
from thirdbody.solver.solve import solve


def solutions(group: Group, rtol: float) -> list[Solution]:
    """Solutions of the points of ``group``, all together, by each way."""
    given = group.conditions | {"parameters": group.parameters, "rtol": rtol}
    return [solve(**given, way=way) for way in WAYS]
