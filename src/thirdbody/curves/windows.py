"""Windows of particle sizes: between which diameters a curve has a turning point.

Small particles vanish between the summits, large ones keep them apart: only for diameters x_a of
about the roughness sigma does A_sa,t* of dry contact turn (see ``turning_point``).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.curves.bracketing import bracketed_roots
from thirdbody.curves.turning_point import PROMINENCE, ratio_maxima
from thirdbody.model.parameters import Parameters
from thirdbody.solver.points import make_contact
from thirdbody.solver.solve import DEFAULT_RTOL, solve_arrays
from thirdbody.tabular import Tabular


@dataclass(frozen=True)
class Window(Tabular):
    """Diameters over roughness between which there is a turning point [1].

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
    prominence : float
        By how much a turning point must stand out [1].
    """

    ratios: NDArray
    separations: int = 60
    tolerance: float = 1e-9
    rtol: float = DEFAULT_RTOL
    prominence: float = PROMINENCE


def turning_point_windows(
    searches: Sequence[WindowSearch],
    roughness: ArrayLike,
    density: float,
    load_range: tuple[float, float],
    parameters: Parameters,
) -> list[Window]:
    """Find the ranges of x_a/sigma in which dry contact has a turning point.

    Parameters
    ----------
    searches : sequence of WindowSearch
        One for each surface; they differ only in ``ratios`` and ``tolerance``.
    roughness : array_like, shape (searches,)
        sigma [m] of each surface.
    density : float
        Particle density eta_a [m-2].
    load_range : pair of float
        First and last load F_t* [1] of the curves.

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
    0.7813 to 1.4181
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


def swept_windows(ratios: NDArray, prominence: NDArray) -> tuple[NDArray, NDArray]:
    """Find the windows of many sweeps at once, interpolated between the ratios of the sweep.

    Parameters
    ----------
    ratios : array, shape (ratios,)
        x_a/sigma [1], increasing.
    prominence : array, shape (ratios, ...)
        That of ``film_turning_points`` [1]; nan where no maximum is known.

    Returns
    -------
    low, high : array, shape (...)
        Ends of the longest run of ratios with a turning point [1]; nan where none has one.  A run
        that reaches an end of the sweep ends there.

    Examples
    --------
    >>> low, high = swept_windows(np.arange(1.0, 6.0), np.array([0.0, 0.04, 0.08, 0.04, np.nan]))
    >>> print(f"{low:.2f} to {high:.2f}")
    1.71 to 4.29
    """
    margin = _above_least(prominence)
    inside = margin > 0.0
    run, longest = np.zeros((2, *margin.shape[1:]), int)
    last = np.zeros(margin.shape[1:], int)
    for place, here in enumerate(inside):
        run = (run + 1) * here
        longer = run > longest
        longest, last = np.where(longer, run, longest), np.where(longer, place, last)
    ends = []
    for inner, step in ((last - longest + 1, -1), (last, 1)):
        inner = np.minimum(inner, ratios.size - 1)  # of no run
        outer = np.clip(inner + step, 0, ratios.size - 1)
        at_inner, at_outer = (
            np.take_along_axis(margin, place[np.newaxis], 0)[0] for place in (inner, outer)
        )
        with np.errstate(
            divide="ignore", invalid="ignore"
        ):  # of no run, and of one that is not closed
            fraction = np.where(inner == outer, 0.0, at_inner / (at_inner - at_outer))
            ends.append(ratios[inner] + fraction * (ratios[outer] - ratios[inner]))
    return tuple(np.where(longest > 0, end, np.nan) for end in ends)


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
    fraction = margin_inner[coarse] / (margin_inner[coarse] - margin_outer[coarse])
    ends[coarse] += fraction * (outer[coarse] - inner[coarse])
    if fine.any():
        window, _ = np.nonzero(fine)
        ends[fine], width = bracketed_roots(
            lambda ratios: margin(ratios, window), inner[fine], outer[fine], tolerance[fine]
        )
        errors[fine] = width + tolerance[fine]
    return ends, errors


def _margin(search, load_range, diameter, roughness, density, parameters):
    """By how much a turning point stands out more than it must; negative where there is none."""
    columns = diameter, roughness, np.full_like(diameter, density)
    names = "particle_diameter", "roughness", "particle_density"
    points = {"load": np.array(load_range)[:, None], "viscosity": np.zeros(1)}
    points |= dict(zip(names, columns, strict=True))
    first, last = solve_arrays(points, parameters, search.rtol, ("separation",)).separation
    solids = make_contact(*columns, parameters, search.rtol)
    between = _between(first, last, roughness, search.separations)
    curve, _, _, prominence = ratio_maxima(solids, between, (first, last), search.rtol)
    greatest = np.full_like(first, np.nan)
    np.fmax.at(greatest, curve, prominence)
    return _above_least(greatest, search.prominence)


def _above_least(prominence, least=PROMINENCE):
    """By how much the root of a prominence, with its sign, exceeds that of the least; nan counts as 0.

    Roots are taken of both: the prominence of a maximum grows with the square of its distance from
    the end of the loads, and the root, with the sign kept, changes about evenly with x_a/sigma.
    """
    known = np.where(np.isnan(prominence), 0.0, prominence)
    return np.copysign(np.sqrt(np.abs(known)), known) - np.sqrt(least)


def _between(first, last, roughness, count):
    """``count`` separations [m] from the largest of ``first`` to the least of ``last`` among the
    curves of each roughness: shape (count, curves)."""
    _, surface = np.unique(roughness, return_inverse=True)
    ends = np.full((2, surface.max() + 1), np.nan)
    np.fmax.at(ends[0], surface, first)
    np.fmin.at(ends[1], surface, last)
    return np.linspace(*ends, count)[:, surface]
