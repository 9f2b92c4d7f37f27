"""Windows of particle sizes in which a curve has a turning point.

Small particles do not touch between the summits, and large particles keep the summits apart.
A_sa,t* of dry contact therefore turns only for diameters x_a close to the roughness sigma (see
``turning_points``).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from thirdbody.core.bracketing import bracketed_roots
from thirdbody.core.contact import Contact
from thirdbody.core.names import SEPARATION
from thirdbody.core.parameters import Parameters
from thirdbody.core.solve import DEFAULT_RTOL, solve_points
from thirdbody.core.turning_points import PROMINENCE, ratio_maxima


@dataclass(frozen=True)
class Window:
    """Range of x_a/sigma [1] with a turning point, nan if no curve has one.

    The bound on the error of an end is infinite if the sweep ends inside the window.
    """

    low: float
    low_error: float
    high: float
    high_error: float


@dataclass(frozen=True)
class WindowSearch:
    """Resolution of the search for windows.

    ``ratios`` are increasing samples of x_a/sigma [1].  Maxima are sought between so many
    ``separations``, and need the least ``prominence`` [1].  ``rtol`` is of solved points,
    ``tolerance`` [1] of the ends.  With an infinite tolerance the ends are only interpolated.
    """

    ratios: NDArray
    separations: int = 60
    tolerance: float = 1e-9
    rtol: float = DEFAULT_RTOL
    prominence: float = PROMINENCE


def turning_point_windows(
    search: WindowSearch,
    roughness: float | NDArray,
    density: float,
    load_range: tuple[float, float],
    parameters: Parameters,
) -> list[Window]:
    """Find the longest range of x_a/sigma with a turning point in dry contact.

    Returns a window for each ``roughness`` sigma [m], at a ``density`` eta_a [m-2].  ``load_range``
    has the first and the last load F_t* [1] of the curves.
    """
    roughness = np.asarray(roughness)
    if not roughness.size:
        return []

    def margin(ratios, surface):
        """Margin of the largest prominence over the required; negative without a turning point."""
        sigma = roughness[surface]
        columns = ratios * sigma, sigma, np.full_like(sigma, density)
        names = "particle_diameter", "roughness", "particle_density"
        points = {"load": np.array(load_range)[:, None], "viscosity": np.zeros(1)}
        points |= dict(zip(names, columns, strict=True))
        first, last = solve_points(points, parameters, search.rtol, (SEPARATION,))[SEPARATION]
        solids = Contact.of(*columns, parameters, search.rtol)
        between = _separations(first, last, sigma, search.separations)
        curve, _, _, prominence = ratio_maxima(solids, between, (first, last), search.rtol)
        greatest = np.full_like(first, np.nan)
        np.fmax.at(greatest, curve, prominence)
        return _margin_over_least(greatest, search.prominence)

    ratios, surface = np.broadcast_arrays(search.ratios[:, None], np.arange(roughness.size))
    margins = margin(ratios.ravel(), surface.ravel()).reshape(ratios.shape)
    inner, outer, ends = _ends_of_longest_runs(ratios, margins)
    errors = np.where(inner == outer, np.inf, np.abs(outer - inner))
    enclosed = np.isfinite(errors)
    if np.isfinite(search.tolerance) and enclosed.any():
        _, surface = np.nonzero(enclosed)
        brackets = inner[enclosed], outer[enclosed], search.tolerance
        ends[enclosed], width = bracketed_roots(lambda ratios: margin(ratios, surface), *brackets)
        errors[enclosed] = width + search.tolerance
    return [
        Window(low=low, low_error=low_error, high=high, high_error=high_error)
        for low, low_error, high, high_error in zip(
            ends[0], errors[0], ends[1], errors[1], strict=True
        )
    ]


def _ends_of_longest_runs(ratios, margins):
    """The longest run of positive ``margins``, in arrays of shape (2, ...).

    Returns the ratios at the ends of the run, the next ratios outside, and the interpolated zeros
    between both.
    """
    length, longest, last = np.zeros((3, *margins.shape[1:]), int)
    for index, inside in enumerate(margins > 0.0):
        length = (length + 1) * inside
        longer = length > longest
        longest, last = np.where(longer, length, longest), np.where(longer, index, last)
    first = np.where(longest > 0, last - longest + 1, 0)
    within = np.stack([first, last])
    beyond = np.clip(np.stack([first - 1, last + 1]), 0, len(margins) - 1)
    inner, outer = (np.take_along_axis(ratios, indices, 0) for indices in (within, beyond))
    at_inner, at_outer = (np.take_along_axis(margins, indices, 0) for indices in (within, beyond))
    inner = np.where(longest > 0, inner, np.nan)
    with np.errstate(divide="ignore", invalid="ignore"):  # a run up to the last ratio
        fraction = np.where(within == beyond, 0.0, at_inner / (at_inner - at_outer))
    return inner, outer, inner + fraction * (outer - inner)


def _margin_over_least(prominence, least):
    """Signed square root of the prominence minus the root of the ``least``; nan counts as 0.

    It is nearly linear in x_a/sigma.
    """
    height = np.where(np.isnan(prominence), 0.0, prominence)
    return np.copysign(np.sqrt(np.abs(height)), height) - np.sqrt(least)


def _separations(first, last, roughness, count):
    """Separations [m], shape (count, curves), equal for all curves of the same roughness.

    They span these curves from end to end.
    """
    _, surface = np.unique(roughness, return_inverse=True)
    ends = np.full((2, surface.max() + 1), np.nan)
    np.fmax.at(ends[0], surface, first)
    np.fmin.at(ends[1], surface, last)
    return np.linspace(ends[0], ends[1], count)[:, surface]
