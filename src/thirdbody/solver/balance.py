"""The balance of forces F_t = F_s(d) + F_f(d) (Eq. 1), solved for the separation d.

There are three cases: no film; a film that depends on its own share of the load; and a film that
depends on the total load (the printed reading of Eq. 8).  All loads are dimensionless,
F* = F/(A_n E_ss), and enter as logarithms, so that neither a tail of the summits nor a vanishing
share of the fluid loses digits.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import log_expit

from thirdbody.model.particles import separation_bearing
from thirdbody.model.readings import LoadOfTheFluid, TotalLoad
from thirdbody.solver.points import Points
from thirdbody.solver.roots import NOISE, decreasing_roots

LOGIT_LIMIT = 745.0  # a smaller L_f than exp(-LOGIT_LIMIT) is zero in float64
ROUNDED_GAP = np.finfo(float).eps  # relative error of a film's thickness in float64


def first_separation(points: Points) -> NDArray:
    """About the separation d [m] at which the solids alone bear the load.

    It is the larger of those that summits alone and particles alone would have, where the solids
    bear between one and two times the load.
    """
    surfaces, contact = points.surfaces, points.contact
    guess = surfaces.offset + surfaces.deviation * surfaces.first_separation(points.log_load)
    if contact.particles is not None:
        area = np.exp(points.log_load) / contact.particle_pressure
        guess = np.maximum(guess, separation_bearing(area, contact.particles))
    return np.maximum(guess, 0.0)


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
    condition : array
        By how much a relative error of the solids' load is magnified in any variable [1].
    """

    logit: NDArray
    separation: NDArray
    width: NDArray
    error: NDArray
    condition: NDArray


def dry_balance(points: Points, tolerance: float) -> Balance:
    """Solve F_s(d) = F_t, where the solids bear the load alone.

    Parameters
    ----------
    points : Points
        Points without a film, or whose film bears nothing.
    tolerance : float
        Relative error that the iteration may leave in any variable.

    Returns
    -------
    Balance
        A load that the solids cannot bear at d = 0 has no solution.

    Notes
    -----
    The unknown is x = d/sigma, the function ln(F_s/F_t), which decreases with it.
    """

    def residual(x, some):
        scale = some.surfaces.roughness
        value, slope, steepest = some.contact.log_solid_load(x * scale)
        gain = np.maximum(-steepest * scale, 1.0 / x)
        return value - some.log_load, slope * scale, gain, 0.0

    scale = points.surfaces.roughness
    guess = first_separation(points) / scale
    roots, width, error, condition = decreasing_roots(
        residual, guess, np.zeros_like(guess), 2.0 * guess + 10.0, tolerance, points
    )
    dry = np.full_like(roots, np.inf)
    return Balance(dry, scale * roots, scale * width, error, condition)


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
    (Eqs. 2 and 4).  The function ln(F_s(d)/F_t) - ln L_s decreases with y, so that there is one
    root; and no digits cancel, however small L_s or L_f is.
    """

    def residual(y, some):
        odds = np.exp(-np.abs(y))
        less = -np.log1p(odds)  # ln of the larger share
        log_solid, log_fluid = less + np.minimum(y, 0.0), less - np.maximum(y, 0.0)
        separation, widening = some.film_separation(log_fluid)  # Eqs. 7 and 8
        value, slope, steepest = some.contact.log_solid_load(separation)  # Eqs. 2 and 4
        larger = 1.0 / (1.0 + odds)
        solid = np.where(y > 0.0, larger, odds * larger)
        shares = y > -LOGIT_LIMIT  # else L_s is zero in float64
        gain = np.maximum(solid * steepest * widening, shares)
        return (
            value - some.log_load - log_solid,
            -solid * slope * widening - (1.0 - solid),
            gain,
            ROUNDED_GAP * (1.0 - steepest * separation),
        )

    guess = _first_logit(points)
    lower = 1.1 * np.minimum(guess, 0.0) - 50.0
    upper = np.full_like(guess, LOGIT_LIMIT)
    found = decreasing_roots(residual, guess, lower, upper, tolerance, points)
    logit, width, error, condition = found
    separation, widening = points.film_separation(log_expit(-logit))
    width = np.abs(widening) * width + ROUNDED_GAP * separation
    return Balance(logit, separation, width, error, condition)


def _first_logit(points: Points):
    """About the logit of L_s: that at the larger of the separations which the solids alone and the
    film alone would have.

    Where the film's share there is the smaller one, the logit follows from it, so that the
    separation stays on the same side of the largest particle; else from the loads of both.
    """
    alone, _ = points.film_separation(0.0)
    separation = np.maximum(alone, first_separation(points))
    thickness = separation / points.parameters.ball_radius
    log_parameter = points.film.load_parameter(thickness, steps=2)
    log_fluid = np.minimum(log_parameter - points.log_load_parameter(0.0), 0.0)
    logit = np.log(-np.expm1(log_fluid)) - log_fluid
    wet = np.flatnonzero(~(logit > 0.0))
    some = points.take(wet)
    log_solid, *_ = some.contact.log_solid_load(separation[wet])
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
    """
    separation, _ = points.film_separation(0.0)
    log_solid, _, steepest = points.contact.log_solid_load(separation)
    log_solid -= points.log_load
    boundary = ~(log_solid < 0.0)
    logit = log_solid - np.log(-np.expm1(np.minimum(log_solid, 0.0)))
    error = ROUNDED_GAP * (1.0 - steepest * separation)
    # L_f = 1 - L_s is what suffers most
    condition = np.maximum(np.exp(logit), 1.0)
    width = ROUNDED_GAP * separation
    found = Balance(logit, separation, width, error + NOISE * condition, condition)
    if boundary.any():
        dry = dry_balance(points.take(boundary), tolerance)
        for name, values in vars(dry).items():
            getattr(found, name)[boundary] = values
    return found


# by the reading of Eq. 8
BALANCES = {LoadOfTheFluid: shared_balance, TotalLoad: total_load_balance}
