"""``transitions``: where the lubrication regime or contact mode changes, along any axis."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from thirdbody.answers.find import SWEEP, crossings, queries, sweep_values
from thirdbody.conditions.checks import checked_parameters
from thirdbody.curves.transitions import LIMITS
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import SOLUTION_STATUSES
from thirdbody.solver.solve import DEFAULT_RTOL
from thirdbody.tabular import Tabular

if TYPE_CHECKING:
    import pandas as pd


class Border(NamedTuple):
    """A limit between two states of a flag, ``lubrication_regime`` or ``contact_mode``."""

    flag: str
    below: str
    above: str


BORDERS = (  # at each of ``LIMITS``
    Border("lubrication_regime", "mixed", "boundary"),
    Border("lubrication_regime", "full_film", "mixed"),
    Border("contact_mode", "hybrid", "particle_surface"),
    Border("contact_mode", "surface_surface", "hybrid"),
)


@dataclass(frozen=True)
class Transition:
    """A change of regime or mode along an axis.

    ``query`` is the flat index into the broadcast shape of the other axes; ``before`` and ``after``
    are the regime or mode at smaller and larger values; ``value`` is the place of the change in the
    unit of the axis, and ``error`` bounds its error; ``solution_status``, one of
    ``thirdbody.model.regimes.SOLUTION_STATUSES``, is whether the equations are valid there.
    """

    query: int
    border: Border
    before: str
    after: str
    value: float
    error: float
    solution_status: str


class Transitions(Tabular, list):
    """A list of ``Transition``, sorted by query, then by value."""

    def to_dataframe(self) -> pd.DataFrame:
        """One row per change."""
        import pandas as pd

        table = pd.DataFrame([vars(each) for each in self], columns=[*Transition.__annotations__])
        return table.assign(border=[each.border.flag for each in self])


def transitions(
    along: str = "load",
    *,
    parameters: Parameters | None = None,
    between: tuple[float, float] | None = None,
    count: int = SWEEP,
    rtol: float = DEFAULT_RTOL,
    **conditions: ArrayLike,
) -> Transitions:
    """Find where lubrication regime and contact mode change along one of the five axes.

    Arguments, units, search and errors are those of ``thirdbody.find``.

    Examples
    --------
    >>> import thirdbody as tb
    >>> layer = dict(particle_diameter_nm=500, particle_density_per_m2=1e11, roughness_nm=300)
    >>> found = tb.transitions("viscosity_cSt", load_N=10, **layer)
    >>> [(each.before, each.after) for each in found if each.border.flag == "lubrication_regime"]
    [('boundary', 'mixed'), ('mixed', 'full_film')]
    """
    parameters = checked_parameters(parameters)
    unit, swept = sweep_values(along, between, count, parameters)
    shape, others = queries(conditions, parameters, unit.condition)
    limits = [(quantity, np.full(shape, level).ravel()) for quantity, level in LIMITS]
    changes = []
    for border, found in zip(BORDERS, crossings(limits, unit, swept, others, parameters, rtol)):
        for query, value, error, rises, status in zip(*(each.tolist() for each in found)):
            states = (border.below, border.above) if rises else (border.above, border.below)
            status = SOLUTION_STATUSES[status]
            changes.append(Transition(query, border, *states, value, error, status))
    return Transitions(sorted(changes, key=lambda change: (change.query, change.value)))
