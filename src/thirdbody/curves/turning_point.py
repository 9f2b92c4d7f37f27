"""Turning point of the contact area (TPCA): its load, and the diameters at which it occurs.

For given particles and surface the ratio A_sa,t* depends on the separation alone.  Its interior
maximum therefore lies at one separation d*, dry or lubricated, and the load there follows from the
balance of forces without any search over loads: F_t = F_s(d*) + F_f(d*).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace

import numpy as np
from scipy.special import expit, logit

from thirdbody.model.contact import Contact
from thirdbody.model.film import Film
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import PARTICLE_LIMIT, SURFACE_LIMIT
from thirdbody.solver.balance import Points
from thirdbody.solver.bracketing import bracketed_roots
from thirdbody.solver.solution import SolvedPoints
from thirdbody.solver.solve import DEFAULT_RTOL, has_particles, make_contact, tables_pay
from thirdbody.solver.surfaces import RoughSurfaces

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
    three_body = np.flatnonzero(has_particles(particle_diameter, particle_density))
    for place, table_rtol in _alike(roughness[three_body], len(separation), rtol):
        curves = three_body[place]
        solids = make_contact(*conditions[1:, curves], parameters, table_rtol)
        curve, peak, width = _maxima(solids, separation[:, curves], SEPARATION_MARGIN * rtol)
        if curve.size:
            refined = _state_at(solids.take(curve), viscosity[curves[curve]], peak, width, rtol)
            best = _highest(curve, refined["peak_ratio"])
            for name, values in refined.items():
                found[name][curves[curve[best]]] = values[best]
    return TurningPoints(**found)


def _alike(roughness, points, rtol):
    """Curves whose surfaces all have tables or all have none: their places, and the ``rtol`` of
    these tables or None.

    ``roughness`` [m] is that of each curve, on which so many ``points`` are looked at; there are
    tables where they cost less than they save.
    """
    _, surface, curves = np.unique(roughness, return_inverse=True, return_counts=True)
    tables = rtol >= CHEAP_TABLES or tables_pay(curves * points, rtol)
    worthwhile = np.broadcast_to(tables, curves.shape)[surface]
    for table_rtol, chosen in ((rtol, worthwhile), (None, ~worthwhile)):
        if chosen.any():
            yield np.flatnonzero(chosen), table_rtol


def _maxima(solids: Contact, separation, rtol):
    """Curves with an interior maximum of A_sa,t*, its d* [m] to within ``rtol``, and that width.

    ``separation`` [m] falls from row to row, in a column for each curve.
    """
    falling = solids.odds_slope(separation) > 0.0
    solved = np.isfinite(separation)
    step, curve = np.nonzero(solved[:-1] & solved[1:] & ~falling[:-1] & falling[1:])
    near, far = separation[step + 1, curve], separation[step, curve]
    slope = solids.take(curve).odds_slope
    return curve, *bracketed_roots(slope, near, far, rtol * near)


def _highest(curve, ratio):
    """Index of the highest ratio of each curve."""
    order = np.lexsort((-ratio, curve))
    return order[np.unique(curve[order], return_index=True)[1]]


def _state_at(solids: Contact, viscosity, separation, width, rtol) -> dict:
    """The fields of ``TurningPoints`` at the maxima ``separation`` [m] known within ``width``, from
    functions that are good for ``rtol``."""
    log_solid, slope, _ = solids.log_solid_load(separation)
    solid = np.exp(log_solid)
    fluid = np.zeros_like(solid)
    steepest = np.abs(slope)
    wet = viscosity > 0.0
    fluid[wet], film_slope = _fluid_load(viscosity[wet], separation[wet], solids.take(wet))
    steepest[wet] = np.maximum(steepest[wet], film_slope)
    load = solids.parameters.readings.film_load.total_load(solid, fluid)
    return {
        "load": load,
        "load_error": load * (steepest * width + rtol),
        "peak_ratio": _ratio(solids, separation),
        "solid_load_fraction": solid / load,
        "separation": separation,
    }


def _ratio(solids: Contact, separation):
    """A_sa,t* [1] at ``separation`` d [m]."""
    particle_area, log_summit_area = solids.areas(separation)
    return expit(np.log(particle_area) - log_summit_area)


def _fluid_load(viscosity, separation, solids: Contact):
    """F_f* [1] of films that are ``separation`` d [m] thick, and |d ln F_f/dd| [m-1] (Eq. 7)."""
    inputs = solids.parameters
    film = Film.of(viscosity, solids.summits.roughness, inputs)
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


def turning_point_windows(
    searches: Sequence[WindowSearch], roughness, density, load_range, parameters: Parameters
) -> list[Window]:
    """Ranges of x_a/sigma in which dry contact has a turning point and stays in the hybrid mode.

    The longest run of each sweep in which it does, its ends refined.  ``searches``, which differ
    in ratios and tolerance alone, belong to the surfaces of ``roughness`` [m], 1-D; ``density``
    [m-2] is a scalar, ``load_range`` the first and last F_t* [1].
    """
    if not searches:
        return []
    roughness = np.asarray(roughness)

    def margin(ratios, window):
        there = roughness[window]
        return _margin(searches[0], load_range, ratios * there, there, density, parameters)

    sizes = [search.ratios.size for search in searches]
    ratios = np.concatenate([search.ratios for search in searches])
    margins = margin(ratios, np.repeat(np.arange(len(searches)), sizes))
    found = np.full((4, len(searches), 2), np.nan)
    for window, start in enumerate(np.cumsum([0, *sizes[:-1]])):
        sweep = slice(start, start + sizes[window])
        inner, outer = _longest_run(margins[sweep] > 0.0)
        found[:, window, : inner.size] = (
            *(ratios[sweep][places] for places in (inner, outer)),
            *(margins[sweep][places] for places in (inner, outer)),
        )
    tolerance = np.array([[search.tolerance] * 2 for search in searches])
    ends, errors = _refined_ends(margin, tolerance, *found)
    return [
        Window(low, low_error, high, high_error)
        for (low, high), (low_error, high_error) in zip(ends, errors, strict=True)
    ]


def _longest_run(inside):
    """Places of the first and last of the longest run of true values, and of those beyond; each
    empty if none is true."""
    closed = np.concatenate([[False], inside, [False]])
    starts = np.flatnonzero(~closed[:-1] & closed[1:])
    stops = np.flatnonzero(closed[:-1] & ~closed[1:]) - 1
    if starts.size == 0:
        return starts, stops
    longest = np.argmax(stops - starts)
    within = np.array([starts[longest], stops[longest]])
    return within, np.clip(within + np.array([-1, 1]), 0, inside.size - 1)


def _refined_ends(margin, tolerance, inner, outer, margin_inner, margin_outer):
    """Where the margin vanishes between neighbours of the sweep, and the errors of that; all of
    shape (windows, 2), nan where there is no window."""
    enclosed = inner != outer
    ends = inner.copy()
    errors = np.where(enclosed, np.abs(outer - inner), np.inf)
    coarse, fine = enclosed & np.isinf(tolerance), enclosed & np.isfinite(tolerance + inner)
    share = margin_inner[coarse] / (margin_inner[coarse] - margin_outer[coarse])
    ends[coarse] += share * (outer[coarse] - inner[coarse])
    if fine.any():
        window, _ = np.nonzero(fine)
        ends[fine], width = bracketed_roots(
            lambda ratios: margin(ratios, window), inner[fine], outer[fine], tolerance[fine]
        )
        errors[fine] = width + tolerance[fine]
    return ends, errors


def _margin(search, load_range, diameter, roughness, density, parameters):
    """Positive where the turning point occurs and all is hybrid, by how much; else negative.

    The least of the logits by which the turning point is above the s-s mode, the whole curve
    below the p-s mode, and of the slope with which the odds of A_sa,t* rise at the first load.
    """
    margin = np.empty_like(diameter)
    conditions = np.stack([diameter, roughness, np.full_like(diameter, density)])
    for place, table_rtol in _alike(roughness, search.separations, search.rtol):
        solids = make_contact(*conditions[:, place], parameters, table_rtol)
        margin[place] = _margin_alike(search, load_range, solids, roughness[place])
    return margin


def _margin_alike(search, load_range, solids: Contact, roughness):
    """``_margin`` of curves whose surfaces all have tables or all have none."""
    (first, last), ratios = _dry(solids, roughness, load_range, search.rtol)
    between = _between(first, last, roughness, search.separations)
    curve, place, _ = _maxima(solids, between, search.rtol)
    found = (last[curve] < place) & (place < first[curve])
    curve, place = curve[found], place[found]
    peak = np.full_like(first, np.nan)
    np.fmax.at(peak, curve, _ratio(solids.take(curve), place))
    turning = np.isfinite(peak)
    highest = np.fmax(ratios.max(axis=0), peak)
    slope = _rise(solids, first)
    turns = np.where(turning, np.maximum(slope, 0.0), -np.abs(slope))
    above = logit(np.where(turning, peak, highest)) - logit(SURFACE_LIMIT)
    below = logit(PARTICLE_LIMIT) - logit(highest)
    return np.clip(np.minimum(turns, np.minimum(above, below)), -FARTHEST, FARTHEST)


def _between(first, last, roughness, count):
    """``count`` separations [m] from the largest of ``first`` to the least of ``last`` among the
    curves of each roughness: shape (count, curves)."""
    _, surface = np.unique(roughness, return_inverse=True)
    ends = np.full((2, surface.max() + 1), np.nan)
    np.fmax.at(ends[0], surface, first)
    np.fmin.at(ends[1], surface, last)
    return np.linspace(*ends, count)[:, surface]


def _dry(solids: Contact, roughness, loads, rtol):
    """d [m] and A_sa,t* at each of ``loads`` F_t*, a row each, on all curves of ``solids``."""
    count = roughness.size
    every = np.tile(np.arange(count), len(loads))
    points = Points(solids.take(every), None, np.repeat(np.log(loads), count))
    with np.errstate(all="ignore"):  # what is not there is nan or zero
        solved = SolvedPoints(points, rtol)
        if solved.imprecise.any():
            exact = RoughSurfaces.of(roughness[every], solids.parameters, None)
            solved = SolvedPoints(
                replace(points, contact=replace(points.contact, summits=exact)), rtol
            )
        found = solved.separation, solved.particle_contact_area_ratio
    return tuple(values.reshape(len(loads), count) for values in found)


def _rise(solids: Contact, separation):
    """-d ln(A_sa/A_ss)/d ln d at ``separation`` [m]: positive where A_sa,t* rises with the load;
    steepest where no particle touches yet."""
    with np.errstate(all="ignore"):
        area = solids.areas(separation)[0]
        slope = -solids.odds_slope(separation) * separation / area
    return np.where(area > 0.0, slope, FARTHEST)
