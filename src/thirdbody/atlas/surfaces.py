"""What the atlas finds on one surface: all loads, films and sizes, for each set of inputs at once.

Every set of inputs is solved once.  What charts and tables are made of is taken from its points while
they are in memory: the regime and mode of each, the limits of design, and the turning points.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from time import process_time

import numpy as np
from numpy.typing import NDArray
from scipy.special import logit

from thirdbody.atlas.grid import AtlasGrid
from thirdbody.atlas.spread import quantiles
from thirdbody.curves.crossings import level_roots
from thirdbody.curves.turning_point import film_turning_points
from thirdbody.curves.windows import swept_windows
from thirdbody.data.dataset import Axes, crossed
from thirdbody.data.quantities import FLAGS
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import (
    BOUNDARY_LIMIT,
    CONTACT_MODES,
    LUBRICATION_REGIMES,
    PARTICLE_LIMIT,
)
from thirdbody.solver.solution import Solution
from thirdbody.solver.solve import solve_arrays
from thirdbody.solver.sweep import is_worthwhile, sweep

SOLVED = (
    *("separation", "particle_contact_area_ratio", "solid_load_fraction"),
    *("lubrication_regime", "contact_mode"),
)
STATES = {"lubrication_regime": LUBRICATION_REGIMES, "contact_mode": CONTACT_MODES}
LIMITED = {  # axis of a limit, the variable that passes a level along it, the level, upwards or down
    "largest_particle_diameter": (
        *("particle_diameter", "particle_contact_area_ratio"),
        *(PARTICLE_LIMIT, 1.0),
    ),
    "least_viscosity": ("viscosity", "solid_load_fraction", BOUNDARY_LIMIT, -1.0),
}
# what has a value for each set of inputs, and over the ensemble quantiles and the share that has one
LIMITS = tuple(LIMITED)
TURNING = ("turning_point_load", "turning_point_window_low", "turning_point_window_high")
EVEN = 2.0  # step of the logarithm of odds up to which a limit is interpolated
LEAP_RTOL = 10.0  # what a leap is solved with, which leaves its place as close as rtol


@dataclass
class Clock:
    """For how many sets of inputs points were solved, and the processor time that they took, and the
    search for limits and turning points between them [s]."""

    sets: int
    solving: float = 0.0
    searching: float = 0.0


def solve_surface(
    grid: AtlasGrid,
    sets: Sequence[Parameters],
    weights: Sequence[int],
    kept: Collection[str],
    rtol: float,
    clock: Clock,
) -> dict[str, NDArray]:
    """All that the atlas holds of a few particle densities on one surface.

    Parameters
    ----------
    grid : AtlasGrid
        With one roughness.
    sets : sequence of Parameters
        The default inputs, then the others of the ensemble.
    weights : sequence of int
        How often each is in the ensemble.
    kept : collection of str
        Quantities kept of each point under the default inputs.
    rtol : float
        Relative error asked for.
    clock : Clock
        Takes the time.

    Returns
    -------
    dict
        Arrays by the names of ``thirdbody.atlas.chunk.variables``, over its dimensions.
    """
    counts = {
        f"{state}_probability": np.zeros(grid.shape, np.int16)
        for states in STATES.values()
        for state in states
    }
    found: dict[str, list] = {name: [] for name in (*LIMITS, *TURNING)}
    values: dict[str, NDArray] = {}
    for parameters, weight in zip(sets, weights, strict=True):
        names = SOLVED if values else dict.fromkeys((*SOLVED, *kept, *FLAGS))
        axes = grid.axes(parameters)
        solution = _timed(clock, "solving", _solved, axes, parameters, rtol, names)
        values = values or {name: getattr(solution, name) for name in (*kept, *FLAGS)}
        if weight:
            for flag, states in STATES.items():
                for index, state in enumerate(states):
                    counts[f"{state}_probability"] += weight * (getattr(solution, flag) == index)
        for name, each in (
            _timed(clock, "searching", _limits, axes, solution, parameters, rtol)
            | _timed(clock, "searching", _turning, axes, solution.separation, parameters, rtol)
        ).items():
            found[name].append(each)
    return values | counts | _summed_up(found, weights)


def _solved(axes, parameters, rtol, names) -> Solution:
    """The points of a grid: by a sweep over the separation if they are many."""
    if is_worthwhile(axes, rtol):
        return sweep(axes, parameters, rtol, names)
    return solve_arrays(crossed(axes), parameters, rtol, names)


def _timed(clock, what, function, *given):
    start = process_time()
    result = function(*given)
    setattr(clock, what, getattr(clock, what) + process_time() - start)
    return result


def _limits(axes, solution, parameters, rtol) -> dict[str, NDArray]:
    """Up to which diameter particles stay out of the particle-surface mode, and from which viscosity
    on lubrication is no longer boundary lubrication."""
    return {
        name: first_passed(along, variable, level, direction, axes, solution, parameters, rtol)
        for name, (along, variable, level, direction) in LIMITED.items()
    }


def first_passed(
    along: str,
    variable: str,
    level: float,
    direction: float,
    axes: Axes,
    solution: Solution,
    parameters: Parameters,
    rtol: float,
) -> NDArray:
    """Where a variable first passes a level along one axis of a solved grid.

    Between neighbours ln of the odds is interpolated over ln of the axis; where it leaps, as it does
    where the first particle touches, points between them are solved.

    Parameters
    ----------
    along : str
        The axis, whose value 0 is left out.
    variable : str
        One of ``solution``.
    level, direction : float
        What is passed, and whether upwards, 1, or downwards, -1.
    axes : mapping
        The five axes.
    solution : Solution
        That of the grid.
    parameters, rtol
        Of the solution; the place of a leap is found as closely.

    Returns
    -------
    array
        Of the shape of the grid without the axis, SI: 0 where the level is passed at the first value
        already, infinite where it never is, nan where points without solution leave that open.
    """
    axis = list(axes).index(along)
    positive = axes[along] > 0.0
    values = np.moveaxis(getattr(solution, variable), axis, 0)[positive]
    nodes = axes[along][positive]
    beyond = direction * (values - level) > 0.0
    passed, last = beyond.any(axis=0), beyond.argmax(axis=0)
    never = np.where(np.isnan(values).any(axis=0), np.nan, np.inf)
    found = np.where(passed, 0.0, never)
    others = np.nonzero(passed & (last > 0))
    high = last[others]
    ends = [np.log(nodes[place]) for place in (high - 1, high)]
    shares = [values[(place, *others)] for place in (high - 1, high)]
    with np.errstate(divide="ignore", invalid="ignore"):
        below, above = (logit(share) - logit(level) for share in shares)
        root = ends[0] + below / (below - above) * (ends[1] - ends[0])
    leap = np.flatnonzero(np.isfinite(shares[0]) & ~(np.abs(above - below) < EVEN))
    root[leap], _ = level_roots(
        along,
        tuple(end[leap] for end in ends),
        [variable],
        np.zeros(leap.size, int),
        np.full(leap.size, level),
        {
            name: axes[name][places[leap]]
            for name, places in zip((name for name in axes if name != along), others, strict=True)
        },
        parameters,
        min(LEAP_RTOL * rtol, 1e-2),
    )
    found[others] = np.exp(root)
    return found


def _turning(axes, separation, parameters, rtol) -> dict[str, NDArray]:
    """Turning points of all curves, and their windows."""
    films, sizes, densities = (
        axes[name] for name in ("viscosity", "particle_diameter", "particle_density")
    )
    (roughness,) = axes["roughness"]
    diameter, density = (each.ravel() for each in np.meshgrid(sizes, densities, indexing="ij"))
    turning = film_turning_points(
        separation.reshape(*separation.shape[:2], -1),
        films,
        diameter,
        np.full_like(diameter, roughness),
        density,
        parameters,
        rtol,
    )
    shape = films.size, sizes.size, 1, densities.size
    large = sizes > 0.0
    prominence = np.moveaxis(turning.prominence.reshape(shape)[:, large], 1, 0)
    low, high = swept_windows(sizes[large] / roughness, prominence)
    return dict(zip(TURNING, (turning.load.reshape(shape), low, high), strict=True))


def _summed_up(found: Mapping[str, list], weights) -> dict[str, NDArray]:
    """The values of the default, the quantiles of the ensemble, and which share of it has a value."""
    result = {}
    for name, each in found.items():
        members = np.repeat(np.stack(each), weights, axis=0)
        result[name] = each[0]
        result[f"{name}_range"] = quantiles(members)
        if name in TURNING[:2]:
            result[f"{name}_count"] = np.isfinite(members).sum(axis=0)
    for name, count in (("turning_point", TURNING[0]), ("turning_point_window", TURNING[1])):
        result[f"{name}_probability"] = result.pop(f"{count}_count").astype(np.int16)
    return result
