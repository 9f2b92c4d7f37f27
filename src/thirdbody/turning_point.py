"""Turning point of the contact area (TPCA): its load, and the diameters at which it occurs.

For given particles and surface the ratio A_sa,t* depends on the separation alone.  Its interior
maximum therefore lies at one separation d*, dry or lubricated, and the load there follows from the
balance of forces without any search over loads: F_t = F_s(d*) + F_f(d*).
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np
from scipy.optimize.elementwise import find_root
from scipy.special import expit, logit

from thirdbody.balance import Points
from thirdbody.film import Film
from thirdbody.interface import (
    DEFAULT_RTOL,
    TABLE_WORTH,
    has_particles,
    make_points,
    prepare_surface,
    solve,
)
from thirdbody.parameters import Parameters
from thirdbody.regimes import PARTICLE_LIMIT, SURFACE_LIMIT

FARTHEST = 20.0  # a logit beyond it is as good as infinite

# d is found this much closer than the load is asked for: F_t* changes by up to t^2 as much as d
SEPARATION_MARGIN = 1e-3


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
    rtol: float = DEFAULT_RTOL,
) -> TurningPoints:
    """Highest interior maximum of A_sa,t*(F_t*) on each curve, refined below the load spacing.

    ``separation`` [m] has shape (loads, curves) and belongs to increasing loads; the four
    conditions (SI) have shape (curves,).  ``rtol`` is the relative error asked for.  Two-body
    curves, and curves with unsolved points where the maximum would lie, have none.
    """
    conditions = np.stack([viscosity, particle_diameter, roughness, particle_density])
    found = {field.name: np.full(separation.shape[1], np.nan) for field in fields(TurningPoints)}
    three_body = has_particles(particle_diameter, particle_density)
    for sigma in np.unique(roughness[three_body]):
        curves = np.flatnonzero((roughness == sigma) & three_body)
        for name, values in _on_one_surface(
            separation[:, curves], conditions[:, curves], parameters, rtol
        ).items():
            found[name][curves] = values
    return TurningPoints(**found)


def _on_one_surface(separation, conditions, parameters, rtol) -> dict:
    """The fields of ``TurningPoints`` for three-body curves of one roughness."""
    result = {
        field.name: np.full(separation.shape[1], np.nan) for field in fields(TurningPoints)
    }
    table_rtol = rtol if separation.size >= TABLE_WORTH else None
    rough = prepare_surface(float(conditions[2, 0]), parameters, table_rtol)
    step, curve = _rises_to_a_maximum(separation, conditions, rough, parameters)
    if curve.size == 0:
        return result
    solids = make_points(rough, parameters, np.ones(curve.size), *_dry(conditions[:, curve]))
    root = find_root(
        lambda d, index: solids.take(index.astype(int)).odds_slope(d),
        (separation[step + 1, curve], separation[step, curve]),
        args=(np.arange(curve.size),),
        tolerances={"xatol": 0.0, "xrtol": SEPARATION_MARGIN * rtol},
    )
    width = root.bracket[1] - root.bracket[0]
    refined = _state_at(solids, conditions[0, curve], root.x, width, rtol)
    best = _highest(curve, refined["peak_ratio"])
    for name, values in refined.items():
        result[name][curve[best]] = values[best]
    return result


def _dry(conditions):
    """The same conditions without lubricant: A_sa,t* depends on the separation alone."""
    return np.concatenate([np.zeros_like(conditions[:1]), conditions[1:]])


def _rises_to_a_maximum(separation, conditions, rough, parameters):
    """Load steps and curves between which A_sa,t* turns from rising to falling."""
    loads, count = separation.shape
    every = np.broadcast_to(_dry(conditions)[:, None, :], (4, loads, count)).reshape(4, -1)
    points = make_points(rough, parameters, np.ones(loads * count), *every)
    falling = points.odds_slope(separation.ravel()).reshape(loads, count) > 0.0
    solved = np.isfinite(separation)
    return np.nonzero(solved[:-1] & solved[1:] & ~falling[:-1] & falling[1:])


def _highest(curve, ratio):
    """Index of the highest ratio of each curve."""
    order = np.lexsort((-ratio, curve))
    return order[np.unique(curve[order], return_index=True)[1]]


def _state_at(solids: Points, viscosity, separation, width, rtol) -> dict:
    """The fields of ``TurningPoints`` at the maxima ``separation`` [m] known within ``width``, from
    functions that are good for ``rtol``."""
    log_solid, slope, _ = solids.log_solid_load(separation)
    solid = np.exp(log_solid)
    fluid = np.zeros_like(solid)
    steepest = np.abs(slope)
    wet = viscosity > 0.0
    fluid[wet], film_slope = _fluid_load(viscosity[wet], separation[wet], solids)
    steepest[wet] = np.maximum(steepest[wet], film_slope)
    together = np.maximum if solids.parameters.film_load == "total" else np.add
    load = together(solid, fluid)
    particle_area, log_summit_area = solids.areas(separation)
    return {
        "load": load,
        "load_error": load * (steepest * np.abs(width) + rtol),
        "peak_ratio": expit(np.log(particle_area) - log_summit_area),
        "solid_load_fraction": solid / load,
        "separation": separation,
    }


def _fluid_load(viscosity, separation, solids: Points):
    """F_f* [1] of films that are ``separation`` d [m] thick, and |d ln F_f/dd| [m-1] (Eq. 7)."""
    inputs = solids.parameters
    film = Film.of(viscosity, solids.rough.surface.roughness, inputs)
    log_parameter = film.load_parameter(separation / inputs.ball_radius)
    load = np.exp(log_parameter) * inputs.ball_radius**2 / inputs.apparent_area
    return load, 1.0 / np.abs(inputs.ball_radius * film.thickness(log_parameter)[1])


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


@dataclass(frozen=True)
class WindowSearch:
    """How finely a window is searched: ratios x_a/sigma of the sweep [1], increasing; loads a
    curve; absolute error of the ends, infinite to interpolate in the sweep; relative error of
    what is solved."""

    ratios: np.ndarray
    loads: int = 60
    tolerance: float = 1e-9
    rtol: float = DEFAULT_RTOL


def turning_point_window(
    search: WindowSearch, roughness, density, load_range, parameters: Parameters
) -> Window:
    """Range of x_a/sigma in which dry contact has a turning point and stays in the hybrid mode.

    The longest run of the sweep in which it does, its ends refined.  ``roughness`` [m] and
    ``density`` [m-2] are scalars, ``load_range`` the first and last F_t* [1].
    """
    ratios = search.ratios

    def margin(some):
        return _margin(search, load_range, some * roughness, roughness, density, parameters)

    margins = margin(ratios)
    inside = np.concatenate([[False], margins > 0.0, [False]])
    starts = np.flatnonzero(~inside[:-1] & inside[1:])
    stops = np.flatnonzero(inside[:-1] & ~inside[1:]) - 1
    if starts.size == 0:
        return Window(*(np.nan,) * 4)
    longest = np.argmax(stops - starts)
    within = np.array([starts[longest], stops[longest]])
    beyond = np.clip(within + np.array([-1, 1]), 0, ratios.size - 1)
    ends, errors = _refined_ends(search, margin, margins, within, beyond)
    return Window(ends[0], errors[0], ends[1], errors[1])


def _refined_ends(search, margin, margins, within, beyond):
    """Where the margin vanishes between neighbours of the sweep, and the errors of that."""
    ratios = search.ratios
    enclosed = within != beyond
    ends = ratios[within].copy()
    errors = np.where(enclosed, np.abs(ratios[beyond] - ratios[within]), np.inf)
    inner, outer = within[enclosed], beyond[enclosed]
    if not np.isfinite(search.tolerance):
        share = margins[inner] / (margins[inner] - margins[outer])
        ends[enclosed] += share * (ratios[outer] - ratios[inner])
    elif inner.size:
        root = find_root(
            margin,
            (ratios[inner], ratios[outer]),
            tolerances={"xatol": search.tolerance, "xrtol": 0.0},
        )
        ends[enclosed] = root.x
        errors[enclosed] = np.abs(root.bracket[1] - root.bracket[0]) + search.tolerance
    return ends, errors


def _margin(search, load_range, diameter, roughness, density, parameters):
    """Positive where the turning point occurs and all is hybrid, by how much; else negative.

    The least of the logits by which the turning point is above the s-s mode, the whole curve
    below the p-s mode, and of the slope with which the odds of A_sa,t* rise at the first load.
    """
    loads = np.geomspace(*load_range, search.loads)
    points = loads[:, None], 0.0, diameter, roughness, density
    wanted = "separation", "particle_contact_area_ratio"
    solution = solve(*points, parameters, search.rtol, wanted)
    same = np.ones_like(diameter)
    conditions = 0.0 * same, diameter, roughness * same, density * same
    turning = turning_points(solution.separation, *conditions, parameters, search.rtol)
    highest = np.fmax(solution.particle_contact_area_ratio.max(axis=0), turning.peak_ratio)
    peak = np.where(np.isnan(turning.load), highest, turning.peak_ratio)
    slope = _odds_slope(solution.separation[0], conditions, parameters)
    turns = np.where(np.isnan(turning.load), -np.abs(slope), np.maximum(slope, 0.0))
    above = logit(peak) - logit(SURFACE_LIMIT)
    below = logit(PARTICLE_LIMIT) - logit(highest)
    return np.clip(np.minimum(turns, np.minimum(above, below)), -FARTHEST, FARTHEST)


def _odds_slope(separation, conditions, parameters):
    """-d ln(A_sa/A_ss)/d ln d at ``separation`` [m] of conditions on one surface: positive where
    A_sa,t* rises with the load; steepest where no particle touches yet."""
    rough = prepare_surface(float(conditions[2][0]), parameters, None)
    points = make_points(rough, parameters, np.ones_like(separation), *conditions)
    with np.errstate(all="ignore"):
        area = points.areas(separation)[0]
        slope = -points.odds_slope(separation) * separation / area
    return np.where(area > 0.0, slope, FARTHEST)
