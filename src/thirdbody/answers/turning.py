"""``turning_point`` and ``turning_window``: where the particle fraction of the contact area turns."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from thirdbody.answers.find import queries
from thirdbody.conditions import check_count, check_ends, check_rtol, checked_parameters
from thirdbody.curves.turning_point import TurningPoints, turning_points
from thirdbody.curves.windows import Window, WindowSearch, turning_point_windows
from thirdbody.data.paper_tables import LOADS
from thirdbody.model.parameters import Parameters
from thirdbody.solver.solve import DEFAULT_RTOL, solve_arrays
from thirdbody.units import LOAD_IN_NEWTONS, UNITS, unit_of

SWEEP = 60  # loads between which maxima are sought
RATIOS = np.linspace(0.2, 3.0, 113)  # sampled x_a/sigma of a window
TOLERANCE = 1e-6  # of its ends
DRY = {"viscosity": 0.0, "particle_diameter": 0.0}  # for a window; any diameter


def turning_point(
    *,
    parameters: Parameters | None = None,
    between_N: tuple[float, float] = LOADS,
    count: int = SWEEP,
    rtol: float = DEFAULT_RTOL,
    **conditions: ArrayLike,
) -> TurningPoints:
    """Find the turning point of the contact area over the load: the maximum of A_sa,t*.

    The result has arrays of the broadcast shape; ``exists`` marks the curves with a turning point.
    ``load`` is F_t* [1]; multiply by ``parameters.newtons_per_load`` for newtons.  Raises ``ValueError``
    for loads that do not increase, a ``count`` out of range, and where ``solve`` does.

    Parameters
    ----------
    between_N : pair of float
        First and last load of the curve [N], by default those of the paper (Table 2).  The maximum
        must exceed the least values on both sides of it between them.
    count : int
        Number of loads between which maxima are sought; two within one step are missed.
    parameters, rtol, **conditions
        As in ``thirdbody.solve``, without the load; the conditions broadcast.

    Examples
    --------
    >>> import thirdbody as tb
    >>> layer = dict(particle_diameter_nm=[20, 300], particle_density_per_m2=1e11, roughness_nm=300)
    >>> tb.turning_point(viscosity_cSt=0, **layer).exists
    array([False,  True])
    """
    parameters = checked_parameters(parameters)
    check_rtol(rtol)
    check_count("count", count)
    loads = np.geomspace(*_load_range(between_N, parameters), count)
    shape, curves = queries(conditions, parameters, "load")
    points = {"load": loads[:, None]} | curves
    solved = solve_arrays(points, parameters, rtol, ["separation"])
    found = turning_points(solved.separation, **curves, parameters=parameters, rtol=rtol)
    return TurningPoints(*(column.reshape(shape) for column in vars(found).values()))


def turning_window(
    *,
    parameters: Parameters | None = None,
    between_N: tuple[float, float] = LOADS,
    **conditions: float,
) -> Window:
    """Find the longest range of x_a/sigma, from 0.2 to 3, in which dry contact has a turning point.

    Arguments and errors are those of ``turning_point``; the conditions are one roughness and one
    particle density.  The ends are nan if there is no such range.

    Examples
    --------
    >>> import thirdbody as tb
    >>> window = tb.turning_window(roughness_nm=300, particle_density_per_m2=1e11)
    >>> bool(window.low < 1.0 < window.high)
    True
    """
    for key in conditions:
        if unit_of(key).condition in ("load", *DRY):
            message = "allowed: roughness and particle density"
            raise ValueError(f"{key} is not a condition of a window in dry contact; {message}")
    parameters = checked_parameters(parameters)
    shape, given = queries(DRY | conditions, parameters, "load")
    if shape:
        names = " and ".join(conditions)
        raise ValueError(f"{names} have shape {shape}; allowed: one number each")
    loads = _load_range(between_N, parameters)
    search = WindowSearch(RATIOS, tolerance=TOLERANCE)
    (density,) = given["particle_density"].tolist()
    (found,) = turning_point_windows(search, given["roughness"], density, loads, parameters)
    return found


def _load_range(between_N: tuple[float, float], parameters: Parameters) -> tuple[float, float]:
    """First and last load F_t* [1] of a curve, converted from newtons."""
    check_ends("between_N", between_N)
    return tuple(UNITS[LOAD_IN_NEWTONS].to_si(between_N, parameters.newtons_per_load).tolist())
