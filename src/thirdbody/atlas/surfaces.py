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
from thirdbody.curves.turning_point import film_turning_points
from thirdbody.curves.windows import swept_windows
from thirdbody.data.dataset import crossed
from thirdbody.data.quantities import FLAGS
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import (
    BOUNDARY_LIMIT,
    CONTACT_MODES,
    LUBRICATION_REGIMES,
    PARTICLE_LIMIT,
)
from thirdbody.solver import availability
from thirdbody.solver.plan import COMPILED, REPEATABLE
from thirdbody.solver.solve import solve_arrays

SOLVED = (
    *("separation", "particle_contact_area_ratio", "solid_load_fraction"),
    *("lubrication_regime", "contact_mode"),
)
STATES = {"lubrication_regime": LUBRICATION_REGIMES, "contact_mode": CONTACT_MODES}
# what has a value for each set of inputs, and over the ensemble quantiles and the share that has one
LIMITS = ("largest_particle_diameter", "least_viscosity")
TURNING = ("turning_point_load", "turning_point_window_low", "turning_point_window_high")


@dataclass
class Clock:
    """For how many sets of inputs points were solved, and the processor time that they and their
    turning points took [s]."""

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
        solution = _timed(
            clock, "solving", solve_arrays, crossed(axes), parameters, rtol, names, way()
        )
        values = values or {name: getattr(solution, name) for name in (*kept, *FLAGS)}
        if weight:
            for flag, states in STATES.items():
                for index, state in enumerate(states):
                    counts[f"{state}_probability"] += weight * (getattr(solution, flag) == index)
        for name, each in (
            _limits(axes, solution)
            | _timed(clock, "searching", _turning, axes, solution.separation, parameters, rtol)
        ).items():
            found[name].append(each)
    return values | counts | _summed_up(found, weights)


def way() -> str:
    """How points are solved: as fast as can be, but by the same way in every job."""
    return COMPILED if availability.is_installed() else REPEATABLE


def _timed(clock, what, function, *given):
    start = process_time()
    result = function(*given)
    setattr(clock, what, getattr(clock, what) + process_time() - start)
    return result


def _limits(axes, solution) -> dict[str, NDArray]:
    """Up to which diameter particles stay out of the particle-surface mode, and from which viscosity
    on lubrication is no longer boundary lubrication."""
    ratio, fraction = solution.particle_contact_area_ratio, solution.solid_load_fraction
    return {
        "largest_particle_diameter": first_passed(
            axes["particle_diameter"], np.moveaxis(ratio, 2, 0), PARTICLE_LIMIT, 1.0
        ),
        "least_viscosity": first_passed(
            axes["viscosity"], np.moveaxis(fraction, 1, 0), BOUNDARY_LIMIT, -1.0
        ),
    }


def first_passed(axis: NDArray, share: NDArray, level: float, direction: float) -> NDArray:
    """Where a share between 0 and 1 first passes a level along an axis.

    Between neighbours the logarithm of its odds is interpolated over that of the axis.

    Parameters
    ----------
    axis : array, shape (n,)
        Increasing values; a first one of 0 is left out.
    share : array, shape (n, ...)
        The share at each of them; nan where there is no solution.
    level : float
        What is passed.
    direction : float
        1 upwards, -1 downwards.

    Returns
    -------
    array, shape (...)
        0 where it is passed at the first value already, infinite where it never is, nan where points
        without solution leave that open.

    Examples
    --------
    >>> axis, share = np.array([0.0, 1.0, 2.0, 4.0]), np.array([0.0, 0.2, 0.5, 0.8])
    >>> first_passed(axis, share, 0.5, 1.0).round(3), first_passed(axis, share, 0.9, 1.0)
    (array(2.), array(inf))
    """
    positive = axis > 0.0
    log_axis, share = np.log(axis[positive]), share[positive]
    passed = direction * (share - level) > 0.0
    last = passed.argmax(axis=0)
    first = np.maximum(last - 1, 0)
    ends = [np.take_along_axis(share, place[np.newaxis], 0)[0] for place in (first, last)]
    with np.errstate(divide="ignore", invalid="ignore"):
        low, high = (np.clip(logit(end) - logit(level), -ODDS, ODDS) for end in ends)
        place = log_axis[first] + low / (low - high) * (log_axis[last] - log_axis[first])
    found = np.where(last == 0, 0.0, np.exp(place))
    never = np.where(np.isnan(share).any(axis=0), np.nan, np.inf)
    return np.where(passed.any(axis=0), found, never)


ODDS = 30.0  # logarithm of odds beyond which shares are 0 or 1


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
