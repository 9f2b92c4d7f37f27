"""The balance of forces F_t = F_s(d) + F_f(d) (Eq. 1), solved for the separation d.

There are three cases: no film; a film that depends on its own share of the load; and a film that
depends on the total load (the printed reading of Eq. 8).  All loads are dimensionless,
F* = F/(A_n E_ss), and enter as logarithms, so that neither a tail of the summits nor a vanishing
share of the fluid loses digits.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import expit, log_expit

from thirdbody.model.contact import SolidLoad
from thirdbody.model.particles import VANISHED, separation_bearing
from thirdbody.model.readings import LoadOfTheFluid, TotalLoad
from thirdbody.solver.points import Points
from thirdbody.solver.roots import EPSILON, ROUNDING, Residual, decreasing_roots
from thirdbody.solver.several import enclose_largest, may_be_several

LOGIT_LIMIT = 745.0  # a smaller L_f than exp(-LOGIT_LIMIT) is zero in float64
FILM_ALONE = -50.0  # logit of an L_s so small that the film is as thick as if it bore all


def first_separation(points: Points) -> NDArray:
    """About the separation d [m] at which the solids alone bear the load.

    It is the larger of those that summits alone and particles alone would have, where the solids
    bear between one and two times the load.
    """
    surfaces, contact = points.surfaces, points.contact
    guess = surfaces.offset + surfaces.deviation * surfaces.first_separation(points.log_load)
    if contact.particles is not None:
        area = np.exp(points.log_load) / points.parameters.particle_pressure
        guess = np.maximum(guess, separation_bearing(area, contact.particles))
    return np.maximum(guess, 0.0)


def _beginning(points: Points, first: NDArray) -> NDArray:
    """Where to begin: at the separation [m] that another way has found, else at the ``first`` one."""
    return first if points.near is None else np.where(points.near > 0.0, points.near, first)


@dataclass(frozen=True)
class Balance:
    """Where the forces balance, at each of some points.

    Parameters
    ----------
    logit : array
        ln(L_s/L_f) [1], infinite without a film.
    separation : array
        d [m]; nan where nothing balances.
    width : array
        Bound on the error [m] that solving and rounding leave in d.
    error : array
        Bound on the relative error that they leave in any variable [1].
    count : array of int
        How many separations there are, of which this is the largest.
    """

    logit: NDArray
    separation: NDArray
    width: NDArray
    error: NDArray
    count: NDArray


def _moved(load: SolidLoad, separation: NDArray, error: ArrayLike) -> tuple[NDArray, NDArray]:
    """What the load and all variables may be wrong by, where rounding has moved the ``separation`` by
    a relative ``error``."""
    moved = error * np.abs(separation)
    return load.noise + moved * np.abs(load.slope), load.rounding + moved * load.steepest + error


def _places_to_search(points):
    """Indices of points for which more than one separation may balance the forces; none by tables,
    whose errors may hide one that just does."""
    return np.flatnonzero(may_be_several(points) & (not points.surfaces.is_tabulated))


def dry_balance(points: Points, tolerance: float, least: NDArray | None = None) -> Balance:
    """Solve F_s(d) = F_t, where the solids bear the load alone.

    Parameters
    ----------
    points : Points
        Points without a film, or whose film bears nothing.
    tolerance : float
        Relative error that the iteration may leave in any variable.
    least : array, optional
        A separation [m] at which the largest that balances the forces is known to be or beyond; else 0.

    Returns
    -------
    Balance
        A load that the solids cannot bear at d = 0 has no solution.

    Notes
    -----
    The unknown is x = d/sigma, the function ln(F_s/F_t), which decreases with it about the root.
    """

    def residual(x, some):
        scale = some.surfaces.roughness
        load = some.contact.log_solid_load(x * scale)
        noise, rounding = _moved(load, x * scale, 2.0 * EPSILON)
        gain = np.maximum(load.steepest * scale, 1.0 / np.abs(x))
        noise = noise + 2.0 * EPSILON * np.abs(some.log_load)
        return Residual(
            load.value - some.log_load,
            load.slope * scale,
            gain,
            noise,
            rounding + some.surfaces.table_error,
            some.surfaces.table_error,
        )

    scale = points.surfaces.roughness
    first = first_separation(points)
    far = first if points.contact.particles is None else points.contact.particles.reach
    guess, lower = _beginning(points, first) / scale, np.zeros_like(first)
    upper = 2.0 * np.maximum(first, far) / scale + 10.0
    count = np.ones(first.shape, int)
    several = _places_to_search(points)
    if several.size:
        start = np.zeros(several.size) if least is None else least[several]
        found = enclose_largest(points.take(several), start, first[several], with_film=False)
        where = np.broadcast_to(scale, first.shape)[several]
        count[several] = found.count
        guess[several] = 0.5 * (found.low + found.high) / where
        # a quotient may be rounded to the wrong side of a kink
        lower[several] = found.low / where * (1.0 - ROUNDING)
        upper[several] = found.high / where * (1.0 + ROUNDING)
    roots, width, error = decreasing_roots(residual, guess, lower, upper, tolerance, points)
    error = np.where(roots <= width, np.inf, error)  # it may be that nothing balances
    if several.size:
        _leave_open(roots, error, guess, several, found)
    dry = np.full_like(roots, np.inf)
    return Balance(dry, scale * roots, scale * width, error, count)


def shared_balance(points: Points, tolerance: float) -> Balance:
    """Solve Eq. 1 where the thickness of the film follows from the load that the film bears.

    Parameters
    ----------
    points : Points
        Points with a film.
    tolerance : float
        Relative error that the iteration may leave in any variable.

    Returns
    -------
    Balance

    Notes
    -----
    The unknown is y = ln(L_s/L_f), the logit of the solids' share.  From it follow both shares,
    from the film's share d = R_x H_c(W(F_f)) (Eqs. 7 and 8), and from d the load F_s of the solids
    (Eqs. 2 and 4).  The function ln(F_s(d)/F_t) - ln L_s decreases with y wherever F_s falls with d;
    and no digits cancel, however small L_s or L_f is.
    """

    def residual(y, some):
        odds = np.exp(-np.abs(y))
        less = -np.log1p(odds)  # ln of the larger share
        log_solid, log_fluid = less + np.minimum(y, 0.0), less - np.maximum(y, 0.0)
        separation, widening, rounded = some.film_separation(log_fluid)  # Eqs. 7 and 8
        load = some.contact.log_solid_load(separation)  # Eqs. 2 and 4
        larger = 1.0 / (1.0 + odds)
        solid = np.where(y > 0.0, larger, odds * larger)
        shares = y > -LOGIT_LIMIT  # else L_s is zero in float64
        noise, rounding = _moved(load, separation, rounded)
        noise = noise + 2.0 * EPSILON * (np.abs(some.log_load) + np.abs(log_solid))
        return Residual(
            load.value - some.log_load - log_solid,
            -solid * load.slope * widening - (1.0 - solid),
            np.maximum(-solid * load.steepest * widening, shares),
            noise,
            rounding + some.surfaces.table_error,
            some.surfaces.table_error,
        )

    alone, *_ = points.film_separation(0.0)
    guess = _first_logit(points, alone)
    lowest = points.contact.log_solid_load(alone).value - points.log_load
    lower = np.minimum(1.001 * lowest, FILM_ALONE) - 10.0
    upper = np.full_like(guess, LOGIT_LIMIT)
    count = np.ones(guess.shape, int)
    several = _places_to_search(points)
    if several.size:
        some = points.take(several)
        start = (1.0 - 1e-9) * alone[several]  # where the film bears more than F_t
        enclosed = enclose_largest(some, start, first_separation(some), with_film=True)
        low, high = enclosed.low, enclosed.high
        count[several] = enclosed.count
        ends = _logit(some.log_film_load(low)), _logit(some.log_film_load(high))
        doubt = 1e-12 * (1.0 + np.exp(np.negative(ends)))  # rounding of ln L_f, in y
        lower[several] = np.fmax(ends[0] - doubt[0], lower[several])
        upper[several] = np.fmin(ends[1] + doubt[1], LOGIT_LIMIT)
        middle = _logit(some.log_film_load(0.5 * (low + high)))
        guess[several] = np.where(np.isfinite(middle), middle, guess[several])
    found = decreasing_roots(residual, guess, lower, upper, tolerance, points)
    if several.size:
        _leave_open(found.root, found.error, guess, several, enclosed)
    log_fluid = log_expit(-found.root)
    separation, widening, rounding = points.film_separation(log_fluid)
    width = np.abs(widening) * found.width * expit(found.root) + rounding * separation
    return Balance(found.root, separation, width, found.error, count)


def _leave_open(roots, error, guess, several, enclosed):
    """Infinite errors where rounding leaves open which separation is the largest; and the ``guess``
    between both ends where it hides a change of sign that samples have shown."""
    hidden = np.isnan(roots[several]) & np.isfinite(enclosed.low)
    roots[several[hidden]] = guess[several[hidden]]
    error[several[hidden | enclosed.undecided]] = np.inf


def _logit(log_fluid):
    """ln(L_s/L_f) for ln L_f; a film that bears more than everything counts as bearing all."""
    log_fluid = np.minimum(log_fluid, 0.0)
    return np.log(-np.expm1(log_fluid)) - log_fluid


def _first_logit(points: Points, alone: NDArray):
    """About the logit of L_s: that at the separation which another way has found, else at the larger of
    those which the solids alone and the film ``alone`` would have [m].

    Where the film's share there is the smaller one, the logit follows from it, so that the
    separation stays on the same side of the largest particle; else from the loads of both.
    """
    separation = _beginning(points, np.maximum(alone, first_separation(points)))
    log_fluid = np.minimum(points.log_film_load(separation, steps=2), 0.0)
    logit = _logit(log_fluid)
    wet = np.flatnonzero(~(logit > 0.0))
    some = points.take(wet)
    log_solid = some.contact.log_solid_load(separation[wet]).value
    logit[wet] = log_solid - some.log_load - log_fluid[wet]
    return logit


def total_load_balance(points: Points, tolerance: float) -> Balance:
    """Solve Eq. 1 where the thickness of the film follows from the total load (Eq. 8 as printed).

    Parameters
    ----------
    points : Points
        Points with a film.
    tolerance : float
        Relative error that an iteration may leave in any variable.

    Returns
    -------
    Balance

    Notes
    -----
    d = R_x H_c(W(F_t)) is known, and L_s = F_s(d)/F_t with it.  Where the film would be thinner than
    the dry separation, L_s would exceed 1: there the solids bear everything at the dry separation.
    Where F_s rises with d, that may also hold at separations above the film's thickness.
    """
    separation, _, rounded = points.film_separation(0.0)
    load = points.contact.log_solid_load(separation)
    log_solid = load.value - points.log_load
    noise, rounding = _moved(load, separation, rounded)
    boundary = ~(log_solid < 0.0)
    count = np.where(boundary, 0, 1)
    several = _places_to_search(points)
    if several.size:
        some = points.take(several)
        found = enclose_largest(some, separation[several], first_separation(some), with_film=False)
        # a film so thin that particles cover everything is no balance
        count[several] *= ~_are_covered(some, separation[several])
        count[several] += found.count
        boundary[several] |= found.count > 0
    logit = log_solid - np.log(-np.expm1(np.minimum(log_solid, 0.0)))
    table_error = points.surfaces.table_error
    noise = np.where(log_solid > VANISHED, noise + 2.0 * EPSILON * np.abs(points.log_load), 0.0)
    # L_f = 1 - L_s is what suffers most
    error = rounding + table_error + (noise + table_error) * np.maximum(np.exp(logit), 1.0)
    undecided = np.zeros(boundary.shape, bool)
    if several.size:
        undecided[several] = found.undecided
    error[undecided] = np.inf
    width = rounded * separation
    found = Balance(logit, separation, width, error, count)
    if boundary.any():
        dry = dry_balance(points.take(boundary), tolerance, separation[boundary])
        # along a plateau as high as the load nothing may be found beyond the film
        stays = np.isnan(dry.separation) & undecided[boundary]
        boundary[boundary] = ~stays
        for name, values in vars(dry).items():
            if name != "count":
                getattr(found, name)[boundary] = values[~stays]
        np.maximum(count, 1, out=count)
    return found


def _are_covered(points, separation):
    """Whether particles leave no room between them at a ``separation`` [m]."""
    particles = points.contact.particles
    return particles.leave_no_room(particles.contact(separation)[2])


# by the reading of Eq. 8
BALANCES = {LoadOfTheFluid: shared_balance, TotalLoad: total_load_balance}
