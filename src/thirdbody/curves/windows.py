"""Windows of particle sizes: between which diameters a curve has a turning point in hybrid mode.

Small particles vanish between the summits, large ones keep them apart: only for diameters x_a of
about the roughness sigma does A_sa,t* of dry contact turn (see ``turning_point``) while both,
particles and summits, bear a good part of the contact (the hybrid mode).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import logit

from thirdbody.curves.turning_point import highest_shares, particle_share
from thirdbody.model.contact import Contact
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import PARTICLE_LIMIT, SURFACE_LIMIT
from thirdbody.solver.bracketing import bracketed_roots
from thirdbody.solver.plan import search_ways
from thirdbody.solver.points import make_contact
from thirdbody.solver.solve import DEFAULT_RTOL, solve

FARTHEST = 20.0  # a logit beyond it is as good as infinite


@dataclass(frozen=True)
class Window:
    """Diameters over roughness between which the turning point occurs in hybrid mode [1].

    ``low`` and ``high`` are nan where there is no window.  ``low_error`` and ``high_error`` bound
    their errors; infinite where the sweep ends within the window, so that it was not enclosed.
    """

    low: float
    low_error: float
    high: float
    high_error: float


@dataclass(frozen=True)
class WindowSearch:
    """How finely a window is searched.

    Parameters
    ----------
    ratios : array
        Ratios x_a/sigma of the first sweep [1], increasing.
    separations : int
        Number of separations between which turning points are looked for.
    tolerance : float
        Absolute error of both ends [1]; infinite: interpolated in the sweep, not refined.
    rtol : float
        Relative error of what is solved.
    """

    ratios: NDArray
    separations: int = 60
    tolerance: float = 1e-9
    rtol: float = DEFAULT_RTOL


def turning_point_windows(
    searches: Sequence[WindowSearch],
    roughness: ArrayLike,
    density: float,
    load_range: tuple[float, float],
    parameters: Parameters,
) -> list[Window]:
    """Find the ranges of x_a/sigma in which dry contact turns and stays in the hybrid mode.

    Parameters
    ----------
    searches : sequence of WindowSearch
        One for each surface; they differ in ``ratios`` and ``tolerance`` alone.
    roughness : array_like, shape (searches,)
        sigma [m] of each surface.
    density : float
        Particle density eta_a [m-2].
    load_range : pair of float
        First and last load F_t* [1] of the curves.
    parameters : Parameters
        Inputs of the model.

    Returns
    -------
    list of Window
        Of each search the longest run of its ratios in which this is so, with refined ends.

    Examples
    --------
    >>> import numpy, thirdbody
    >>> inputs = thirdbody.load_parameters()
    >>> sweep = WindowSearch(numpy.linspace(0.5, 2.0, 16), tolerance=1e-6)
    >>> (window,) = turning_point_windows([sweep], [0.3e-6], 1e11, (1e-7, 1e-4), inputs)
    >>> print(f"{window.low:.4f} to {window.high:.4f}")
    0.9531 to 1.2482
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
    """By how much a curve has a turning point and is all in hybrid mode; negative if it is not.

    The least of three: the logits by which the turning point is above the s-s mode, and the whole
    curve below the p-s mode, and the slope with which the odds of A_sa,t* rise at the first load.
    """
    margin = np.empty_like(diameter)
    density = np.full_like(diameter, density)
    for way, table_rtol, curves in search_ways(roughness, search.separations, search.rtol):
        conditions = [column[curves] for column in (diameter, roughness, density)]
        dry = solve(
            np.array(load_range)[:, None],
            *(0.0, *conditions, parameters, search.rtol),
            variables=("separation", "particle_contact_area_ratio"),
            way=way,
        )
        solids = make_contact(*conditions, parameters, table_rtol)
        margin[curves] = _margin_between(
            search, dry.separation, dry.particle_contact_area_ratio, solids, conditions[1]
        )
    return margin


def _margin_between(search, separation, shares, solids: Contact, roughness):
    """``_margin`` of curves from d [m] and A_sa,t* at the first and the last load, a row each."""
    first, last = separation
    between = _between(first, last, roughness, search.separations)
    curve, place, _ = highest_shares(solids, between, search.rtol)
    found = (last[curve] < place) & (place < first[curve])
    curve, place = curve[found], place[found]
    peak = np.full_like(first, np.nan)
    np.fmax.at(peak, curve, particle_share(solids.take(curve), place))
    turning = np.isfinite(peak)
    highest = np.fmax(shares.max(axis=0), peak)
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


def _rise(solids: Contact, separation):
    """-d ln(A_sa/A_ss)/d ln d at ``separation`` [m]: positive where A_sa,t* rises with the load;
    steepest where no particle touches yet."""
    with np.errstate(all="ignore"):
        area = solids.areas(separation)[0]
        slope = -solids.odds_slope(separation) * separation / area
    return np.where(area > 0.0, slope, FARTHEST)
