"""Turning point of the contact area (TPCA): its load, and the diameters at which it occurs.

For given particles and surface the ratio A_sa,t* depends on the separation alone.  Its interior
maximum therefore lies at one separation d*, dry or lubricated, and the load there follows from the
balance of forces without any search over loads: F_t = F_s(d*) + F_f(d*).
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np
from scipy.optimize.elementwise import find_root
from scipy.special import expit

from thirdbody.balance import Points
from thirdbody.interface import make_points, prepare_surface, solve
from thirdbody.parameters import Parameters
from thirdbody.regimes import PARTICLE_LIMIT, SURFACE_LIMIT


@dataclass(frozen=True)
class TurningPoints:
    """The turning point of each curve, 1-D arrays; nan where the curve has none."""

    load: np.ndarray  # F_TPCA* [1]
    load_error: np.ndarray  # bound on the error of F_TPCA* [1]
    peak_ratio: np.ndarray  # A_sa,t* there [1]
    solid_load_fraction: np.ndarray  # L_s there [1]
    separation: np.ndarray  # d* [m]


def turning_points(
    separation,
    viscosity,
    particle_diameter,
    roughness,
    particle_density,
    parameters: Parameters,
    tolerance: float = 1e-12,
) -> TurningPoints:
    """Highest interior maximum of A_sa,t*(F_t*) on each curve, refined below the load spacing.

    ``separation`` [m] has shape (loads, curves) and belongs to increasing loads; the four
    conditions (SI) have shape (curves,).  ``tolerance`` is relative, for the separation.  Two-body
    curves, and curves with unsolved points where the maximum would lie, have none.
    """
    conditions = np.stack([viscosity, particle_diameter, roughness, particle_density])
    found = {field.name: np.full(separation.shape[1], np.nan) for field in fields(TurningPoints)}
    three_body = (particle_diameter > 0.0) & (particle_density > 0.0)
    for sigma in np.unique(roughness):
        for lubricated in (False, True):
            curves = np.flatnonzero(
                (roughness == sigma) & three_body & ((viscosity > 0.0) == lubricated)
            )
            for name, values in _on_one_surface(
                separation[:, curves], conditions[:, curves], parameters, tolerance
            ).items():
                found[name][curves] = values
    return TurningPoints(**found)


def _on_one_surface(separation, conditions, parameters, tolerance) -> dict:
    """The fields of ``TurningPoints`` for three-body curves of one roughness."""
    count = separation.shape[1]
    result = {field.name: np.full(count, np.nan) for field in fields(TurningPoints)}
    if count == 0:
        return result
    rough = prepare_surface(float(conditions[2, 0]), parameters, tabulate=False)
    step, curve = _rises_to_a_maximum(separation, conditions, rough, parameters)
    if curve.size == 0:
        return result
    points = make_points(rough, parameters, np.ones(curve.size), *conditions[:, curve])
    inner, outer = separation[step + 1, curve], separation[step, curve]
    chosen = np.arange(curve.size)
    root = find_root(
        lambda d, index: points.take(index.astype(int)).odds_slope(d),
        (inner, outer),
        args=(chosen,),
        tolerances={"xatol": 0.0, "xrtol": tolerance},
    )
    refined = _state_at(points, root.x, root.bracket[1] - root.bracket[0])
    best = _highest(curve, refined["peak_ratio"])
    for name, values in refined.items():
        result[name][curve[best]] = values[best]
    return result


def _rises_to_a_maximum(separation, conditions, rough, parameters):
    """Load steps and curves between which A_sa,t* turns from rising to falling."""
    loads, count = separation.shape
    every = np.broadcast_to(conditions[:, None, :], (4, loads, count)).reshape(4, -1)
    points = make_points(rough, parameters, np.ones(loads * count), *every)
    falling = points.odds_slope(separation.ravel()).reshape(loads, count) > 0.0
    solved = np.isfinite(separation)
    return np.nonzero(solved[:-1] & solved[1:] & ~falling[:-1] & falling[1:])


def _highest(curve, ratio):
    """Index of the highest ratio of each curve."""
    order = np.lexsort((-ratio, curve))
    return order[np.unique(curve[order], return_index=True)[1]]


def _state_at(points: Points, separation, width) -> dict:
    """The fields of ``TurningPoints`` at the maxima ``separation`` [m] known within ``width``."""
    log_solid, slope = points.log_solid_load(separation)
    solid = np.exp(log_solid)
    fluid = np.zeros_like(solid)
    steepest = np.abs(slope)
    if points.film is not None:
        radius = points.parameters.ball_radius
        log_parameter = points.film.load_parameter(separation / radius)
        fluid = np.exp(log_parameter) * radius**2 / points.parameters.apparent_area
        widening = radius * points.film.thickness(log_parameter)[1]
        steepest = np.maximum(steepest, 1.0 / np.abs(widening))
    if points.parameters.film_load == "total":
        load = np.maximum(solid, fluid)
    else:
        load = solid + fluid
    particle_area, log_summit_area, _ = points.areas(separation)
    return {
        "load": load,
        "load_error": load * steepest * (np.abs(width) + 1e-13 * separation),
        "peak_ratio": expit(np.log(particle_area) - log_summit_area),
        "solid_load_fraction": solid / load,
        "separation": separation,
    }


@dataclass(frozen=True)
class Window:
    """Diameters over roughness between which the turning point occurs in hybrid mode [1].

    An end that the search did not enclose has an infinite error; a window that does not exist is
    nan.
    """

    low: float
    low_error: float
    high: float
    high_error: float


WINDOW_LOADS = 60
WINDOW_HALVINGS = 30


def turning_point_window(ratios, roughness, density, load_range, parameters: Parameters) -> Window:
    """Range of x_a/sigma in which dry contact has a turning point and stays in the hybrid mode.

    ``ratios`` x_a/sigma [1], increasing, is the sweep that finds the range (its longest run);
    both ends are then halved down.  ``roughness`` [m] and ``density`` [m-2] are scalars,
    ``load_range`` the first and last F_t* [1].
    """
    loads = np.geomspace(*load_range, WINDOW_LOADS)

    def occurs(some):
        return _stays_hybrid(loads, some * roughness, roughness, density, parameters)

    inside = occurs(ratios)
    edges = np.flatnonzero(np.diff(np.concatenate([[False], inside, [False]]).astype(int)))
    if edges.size == 0:
        return Window(*(np.nan,) * 4)
    starts, stops = edges[::2], edges[1::2]
    longest = np.argmax(stops - starts)
    first, last = starts[longest], stops[longest] - 1
    within = np.array([ratios[first], ratios[last]])
    beyond = np.array([ratios[max(first - 1, 0)], ratios[min(last + 1, ratios.size - 1)]])
    enclosed = within != beyond
    for _ in range(WINDOW_HALVINGS):
        middle = 0.5 * (within + beyond)
        hits = occurs(middle)
        within, beyond = np.where(hits, middle, within), np.where(hits, beyond, middle)
    error = np.where(enclosed, np.abs(beyond - within), np.inf)
    return Window(within[0], error[0], within[1], error[1])


def _stays_hybrid(loads, diameter, roughness, density, parameters):
    """Whether the turning point occurs in hybrid mode and no load brings the p-s mode."""
    solution = solve(loads[:, None], 0.0, diameter, roughness, density, parameters)
    same = np.ones_like(diameter)
    turning = turning_points(
        solution.separation, 0.0 * same, diameter, roughness * same, density * same, parameters
    )
    hybrid = (turning.peak_ratio > SURFACE_LIMIT) & (turning.peak_ratio < PARTICLE_LIMIT)
    highest = solution.particle_contact_area_ratio.max(axis=0)
    return hybrid & (highest < PARTICLE_LIMIT)
