"""What the atlas finds on one surface: all loads, films and sizes, for each set of inputs at once.

Every set of inputs is solved once.  What charts and tables are made of is taken from its points while
they are in memory: the regime and mode of each, the limits of design, and the turning points.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from time import process_time

import numpy as np
from numpy.typing import NDArray
from scipy.special import logit

from thirdbody.atlas.grid import AtlasGrid
from thirdbody.atlas.spread import quantiles
from thirdbody.curves.bracketing import bracketed_roots
from thirdbody.curves.turning_point import film_turning_points
from thirdbody.curves.windows import swept_windows
from thirdbody.data.dataset import Axes, crossed
from thirdbody.data.quantities import FLAGS
from thirdbody.model.film import Film, film_load, log_load_parameter
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import (
    BOUNDARY_LIMIT,
    CONTACT_MODES,
    LUBRICATION_REGIMES,
    PARTICLE_LIMIT,
)
from thirdbody.solver.points import make_contact
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
# what has a value for each set of inputs, and over the ensemble quantiles and the fraction that has one
LIMITS = tuple(LIMITED)
TURNING = ("turning_point_load", "turning_point_window_low", "turning_point_window_high")
EVEN = 2.0  # step of the logarithm of odds up to which a limit is interpolated
PLACES = 900  # separations between which the diameter that a limit belongs to is interpolated


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
    ends = np.nanmin(solution.separation), np.nanmax(solution.separation)
    diameter = passed_diameter(PARTICLE_LIMIT, axes, ends, parameters, rtol)
    leaps = {
        "largest_particle_diameter": lambda ends, load, film, surface, density: np.clip(
            diameter[film, density, load], *ends
        ),
        "least_viscosity": lambda ends, *place: passed_viscosity(
            BOUNDARY_LIMIT, ends, place, axes, parameters, rtol
        ),
    }
    return {name: first_passed(*LIMITED[name], axes, solution, leaps[name]) for name in LIMITED}


def first_passed(
    along: str,
    variable: str,
    level: float,
    direction: float,
    axes: Axes,
    solution: Solution,
    leap: Callable[..., NDArray],
) -> NDArray:
    """Where a variable first passes a level along one axis of a solved grid.

    Between neighbours ln of the odds is interpolated over ln of the axis.

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
    leap : callable
        Maps neighbours on the axis [SI], and places on the other four, to where between them the level
        is passed [SI].  It is asked where the variable leaps, as it does where the first particle
        touches.

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
    ends = nodes[high - 1], nodes[high]
    at_ends = [values[(place, *others)] for place in (high - 1, high)]
    with np.errstate(divide="ignore", invalid="ignore"):
        below, above = (logit(value) - logit(level) for value in at_ends)
        crossing = ends[0] * (ends[1] / ends[0]) ** (below / (below - above))
    leaps = np.flatnonzero(np.isfinite(at_ends[0]) & ~(np.abs(above - below) < EVEN))
    if leaps.size:
        some = tuple(end[leaps] for end in ends)
        crossing[leaps] = leap(some, *(places[leaps] for places in others))
    found[others] = crossing
    return found


@np.errstate(all="ignore")  # no particle may touch
def passed_diameter(
    level: float, axes: Axes, ends: tuple[float, float], parameters: Parameters, rtol: float
) -> NDArray:
    """Mean diameter x_a [m] at which A_sa,t* is ``level``: shape (films, densities, loads).

    At a separation d the ratio depends on the particles alone, so that x_a(d) is sought there; the
    load that belongs to it is F_s + F_f (Eq. 1).  Of several the largest d counts.  ``ends`` are those
    of d [m]; beyond those of the axis x_a is the end.
    """
    sizes, densities, loads = (
        axes[name] for name in ("particle_diameter", "particle_density", "load")
    )
    separation = np.geomspace(*ends[::-1], PLACES)
    d, density = (each.ravel() for each in np.meshgrid(separation, densities))
    roughness = np.full(d.size, axes["roughness"][0])

    def excess(log_diameter, some):
        columns = np.exp(log_diameter), roughness[some], density[some]
        state = make_contact(*columns, parameters, rtol).log_solid_load(d[some], with_areas=True)
        return np.log(state.area) - state.log_beside - logit(level)

    every = np.arange(d.size)
    low, high = (np.full(d.size, np.log(size)) for size in (sizes[sizes > 0.0][0], sizes[-1]))
    log_diameter = np.where(excess(low, every) > 0.0, low, high)
    passed = np.flatnonzero((log_diameter == high) & (excess(high, every) > 0.0))
    log_diameter[passed], _ = bracketed_roots(
        lambda log_size: excess(log_size, passed), low[passed], high[passed], 0.1 * rtol
    )
    contact = make_contact(np.exp(log_diameter), roughness, density, parameters, rtol)
    solid = np.exp(contact.log_solid_load(d).value).reshape(densities.size, -1)
    viscosity = axes["viscosity"][:, np.newaxis]
    film, _ = film_load(separation, viscosity, axes["roughness"][0], parameters)
    total = parameters.interpretation.film_load.total_load(solid, film[:, np.newaxis])
    total = np.maximum.accumulate(np.log(total), axis=-1)
    log_diameter = log_diameter.reshape(densities.size, -1)
    found = np.empty((*total.shape[:2], loads.size))
    for place in np.ndindex(total.shape[:2]):
        found[place] = np.interp(np.log(loads), total[place], log_diameter[place[1]])
    return np.exp(found)


def passed_viscosity(
    level: float,
    ends: tuple[NDArray, NDArray],
    place: Sequence[NDArray],
    axes: Axes,
    parameters: Parameters,
    rtol: float,
) -> NDArray:
    """Viscosity [m2/s] between two ``ends`` at which L_s is ``level``, at places on the other four axes.

    The solids carry that fraction of the load at one separation, dry or not; the film is as thick
    (Eqs. 7 and 8).
    """
    names = "load", "particle_diameter", "roughness", "particle_density"
    given = {name: axes[name][each] for name, each in zip(names, place, strict=True)}
    log_fluid = parameters.interpretation.film_load.log_fraction(np.log1p(-level))
    log_parameter = log_load_parameter(np.log(given["load"]) + log_fluid, parameters)  # ln W
    dry = given | {"load": level * given["load"], "viscosity": np.zeros(1)}
    separation = solve_arrays(dry, parameters, rtol, ["separation"]).separation
    wanted = separation / parameters.ball_radius

    def excess(log_viscosity):
        film = Film.of(np.exp(log_viscosity), given["roughness"], parameters)
        return np.log(film.thickness(log_parameter)[0] / wanted)

    root, _ = bracketed_roots(excess, *np.log(ends), 0.1 * rtol)
    return np.exp(root)


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
    """The values of the default, the quantiles of the ensemble, and which fraction of it has a value."""
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
