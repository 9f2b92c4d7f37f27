"""Where solved quantities pass a level between two known points, along any of the five conditions."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from thirdbody.conditions.in_si import CONDITIONS
from thirdbody.curves.bracketing import bracketed_roots
from thirdbody.model.parameters import Parameters
from thirdbody.solver.solve import solve_arrays


def excess_over(
    quantities: Sequence[str],
    chosen: NDArray,
    level: NDArray,
    given: Mapping[str, NDArray],
    parameters: Parameters,
    rtol: float,
    also: Collection[str] = (),
) -> tuple[NDArray, dict[str, NDArray]]:
    """By how much a quantity exceeds a level at each point, nan where there is no solution.

    Parameters
    ----------
    quantities : sequence of str
        Variables of ``Solution``, of which ``chosen``, an array of int, has the index of each point's.
    level : array, shape (n,)
        What it is compared with.
    given : mapping
        The five conditions of each point, arguments of ``solve``.
    also : collection of str
        Other variables that are wanted, which are returned by name.
    """
    wanted = {*quantities, *also}
    found = solve_arrays({name: given[name] for name in CONDITIONS}, parameters, rtol, wanted)
    values = np.choose(chosen, [getattr(found, name) for name in quantities])
    return values - level, {name: getattr(found, name) for name in also}


def level_roots(
    along: str,
    ends: tuple[NDArray, NDArray],
    quantities: Sequence[str],
    chosen: NDArray,
    level: NDArray,
    given: Mapping[str, NDArray],
    parameters: Parameters,
    rtol: float,
) -> tuple[NDArray, NDArray]:
    """Where each quantity passes its level between two values of the condition ``along``: ln of the
    condition [SI] there, and how narrowly that is enclosed [1].

    ``ends`` are ln of the condition on both sides of the crossing, two arrays of shape (n,); ``given``
    has the other four conditions; all else is as for ``excess_over``.
    """
    place, value = np.full((2, level.size), np.nan)

    def excess(log_condition):
        moved = np.flatnonzero(log_condition != place)  # a root that is found stays where it is
        some = {name: values[moved] for name, values in given.items()}
        some[along] = np.exp(log_condition[moved])
        asked = quantities, chosen[moved], level[moved], some
        place[moved] = log_condition[moved]
        value[moved] = excess_over(*asked, parameters, rtol)[0]
        return value.copy()

    return bracketed_roots(excess, *ends, 0.1 * rtol)
