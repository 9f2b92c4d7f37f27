"""Turning point of the contact area (TPCA): its load, and the diameters at which it occurs.

For given particles and surface the ratio A_sa,t* depends on the separation alone.  Its interior
maximum therefore lies at one separation d*, dry or lubricated, and the load there follows from the
balance of forces without any search over loads: F_t = F_s(d*) + F_f(d*).
"""

from __future__ import annotations

from dataclasses import dataclass, fields, replace

import numpy as np
from scipy.special import expit, logit

from thirdbody.balance import Points, RoughSurface
from thirdbody.bracketing import bracketed_roots
from thirdbody.film import Film
from thirdbody.interface import (
    DEFAULT_RTOL,
    has_particles,
    make_points,
    prepare_surface,
    worthwhile_rtol,
)
from thirdbody.parameters import Parameters
from thirdbody.regimes import PARTICLE_LIMIT, SURFACE_LIMIT
from thirdbody.solution import SolvedPoints

CHEAP_TABLES = 1e-5  # rtol from which tables cost less than any search without them
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
    result = {field.name: np.full(separation.shape[1], np.nan) for field in fields(TurningPoints)}
    rough = _surface(float(conditions[2, 0]), parameters, rtol, separation.size)
    solids = _solids(rough, parameters, conditions[1:])
    curve, peak, width = _maxima(solids, separation, SEPARATION_MARGIN * rtol)
    if curve.size == 0:
        return result
    refined = _state_at(solids.take(curve), conditions[0, curve], peak, width, rtol)
    best = _highest(curve, refined["peak_ratio"])
    for name, values in refined.items():
        result[name][curve[best]] = values[best]
    return result


def _surface(roughness, parameters, rtol, points) -> RoughSurface:
    """The summits, as tables if these cost less than they save at so many ``points``."""
    table_rtol = rtol if rtol >= CHEAP_TABLES else worthwhile_rtol(points, rtol)
    return prepare_surface(roughness, parameters, table_rtol)


def _solids(rough, parameters, conditions) -> Points:
    """Curves without lubricant: A_sa,t* depends on the separation alone."""
    same = np.ones_like(conditions[0])
    return make_points(rough, parameters, same, 0.0 * same, *conditions)


def _maxima(solids: Points, separation, rtol):
    """Curves with an interior maximum of A_sa,t*, its d* [m] to within ``rtol``, and that width.

    ``separation`` [m] falls from row to row, in a column for each curve or in one for all.
    """
    falling = solids.odds_slope(separation) > 0.0
    separation = np.broadcast_to(separation, falling.shape)
    solved = np.isfinite(separation)
    step, curve = np.nonzero(solved[:-1] & solved[1:] & ~falling[:-1] & falling[1:])
    near, far = separation[step + 1, curve], separation[step, curve]
    slope = solids.take(curve).odds_slope
    return curve, *bracketed_roots(slope, near, far, rtol * near)


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
    return {
        "load": load,
        "load_error": load * (steepest * width + rtol),
        "peak_ratio": _ratio(solids, separation),
        "solid_load_fraction": solid / load,
        "separation": separation,
    }


def _ratio(solids: Points, separation):
    """A_sa,t* [1] at ``separation`` d [m]."""
    particle_area, log_summit_area = solids.areas(separation)
    return expit(np.log(particle_area) - log_summit_area)


def _fluid_load(viscosity, separation, solids: Points):
    """F_f* [1] of films that are ``separation`` d [m] thick, and |d ln F_f/dd| [m-1] (Eq. 7)."""
    inputs = solids.parameters
    film = Film.of(viscosity, solids.rough.roughness, inputs)
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
    """How finely a window is searched: ratios x_a/sigma of the sweep [1], increasing; separations
    between which a turning point is looked for; absolute error of the ends, infinite to interpolate
    in the sweep; relative error of what is solved."""

    ratios: np.ndarray
    separations: int = 60
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
        ends[enclosed], width = bracketed_roots(
            margin, ratios[inner], ratios[outer], search.tolerance
        )
        errors[enclosed] = width + search.tolerance
    return ends, errors


def _margin(search, load_range, diameter, roughness, density, parameters):
    """Positive where the turning point occurs and all is hybrid, by how much; else negative.

    The least of the logits by which the turning point is above the s-s mode, the whole curve
    below the p-s mode, and of the slope with which the odds of A_sa,t* rise at the first load.
    """
    same = np.ones_like(diameter)
    looked_at = diameter.size * search.separations
    rough = _surface(roughness, parameters, search.rtol, looked_at)
    solids = _solids(rough, parameters, (diameter, roughness * same, density * same))
    (first, last), ratios = _dry(solids, load_range, search.rtol)
    between = np.linspace(np.fmax.reduce(first), np.fmin.reduce(last), search.separations)
    curve, place, _ = _maxima(solids, between[:, None], search.rtol)
    found = (last[curve] < place) & (place < first[curve])
    curve, place = curve[found], place[found]
    peak = np.full_like(diameter, np.nan)
    np.fmax.at(peak, curve, _ratio(solids.take(curve), place))
    turning = np.isfinite(peak)
    highest = np.fmax(ratios.max(axis=0), peak)
    slope = _rise(solids, first)
    turns = np.where(turning, np.maximum(slope, 0.0), -np.abs(slope))
    above = logit(np.where(turning, peak, highest)) - logit(SURFACE_LIMIT)
    below = logit(PARTICLE_LIMIT) - logit(highest)
    return np.clip(np.minimum(turns, np.minimum(above, below)), -FARTHEST, FARTHEST)


def _dry(solids: Points, loads, rtol):
    """d [m] and A_sa,t* at each of ``loads`` F_t*, a row each, on all curves of ``solids``."""
    count = solids.log_load.size
    every = solids.take(np.tile(np.arange(count), len(loads)))
    points = replace(every, log_load=np.repeat(np.log(loads), count))
    with np.errstate(all="ignore"):  # what is not there is nan or zero
        solved = SolvedPoints(points, rtol)
        if solved.imprecise.any():
            exact = prepare_surface(solids.rough.roughness, solids.parameters, None)
            solved = SolvedPoints(replace(points, rough=exact), rtol)
        found = solved.separation, solved.particle_contact_area_ratio
    return tuple(values.reshape(len(loads), count) for values in found)


def _rise(solids: Points, separation):
    """-d ln(A_sa/A_ss)/d ln d at ``separation`` [m]: positive where A_sa,t* rises with the load;
    steepest where no particle touches yet."""
    with np.errstate(all="ignore"):
        area = solids.areas(separation)[0]
        slope = -solids.odds_slope(separation) * separation / area
    return np.where(area > 0.0, slope, FARTHEST)
