"""Turning points of the contact area (TPCA).

As the load on a contact with particles grows, the particles' share of the real contact area,
A_sa,t*, first grows because more particles are touched, and falls once the summits between them
touch in numbers.  The turning point of a curve A_sa,t*(F_t*) is its highest interior maximum.

For given particles and surface A_sa,t* depends on the separation d alone.  The maximum therefore
lies at one separation d*, dry or lubricated, and its load follows from the balance of forces
(Eq. 1) without any search over loads: F_t = F_s(d*) + F_f(d*).
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray
from scipy.special import expit

from thirdbody.model.contact import Contact
from thirdbody.model.film import Film
from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import has_particles
from thirdbody.solver.bracketing import bracketed_roots
from thirdbody.solver.plan import search_ways
from thirdbody.solver.points import make_contact
from thirdbody.solver.solve import DEFAULT_RTOL

# d is found this much closer than the load is asked for: F_t* changes by up to t^2 as much as d
SEPARATION_MARGIN = 1e-3


@dataclass(frozen=True)
class TurningPoints:
    """The turning point of each curve.

    Parameters
    ----------
    load : array, shape (curves,)
        F_t* there, F_TPCA* [1]; nan, as all else, where the curve has no turning point.
    load_error : array
        Bound on the error of ``load`` [1].
    peak_ratio : array
        A_sa,t* there [1].
    solid_load_fraction : array
        L_s there [1].
    separation : array
        d* [m].
    """

    load: NDArray
    load_error: NDArray
    peak_ratio: NDArray
    solid_load_fraction: NDArray
    separation: NDArray


def turning_points(
    separation: NDArray,
    viscosity: NDArray,
    particle_diameter: NDArray,
    roughness: NDArray,
    particle_density: NDArray,
    parameters: Parameters,
    rtol: float = DEFAULT_RTOL,
) -> TurningPoints:
    """Find the highest interior maximum of A_sa,t*(F_t*) on each curve.

    Parameters
    ----------
    separation : array, shape (loads, curves)
        Solved separations d [m] at increasing loads; nan where there is no solution.  They only
        enclose the maxima, which are then found more closely than the loads lie together.
    viscosity, particle_diameter, roughness, particle_density : array, shape (curves,)
        Conditions of each curve [m2/s, m, m, m-2].
    parameters : Parameters
        Inputs of the model.
    rtol : float
        Relative error asked for.

    Returns
    -------
    TurningPoints
        Two-body curves, and curves without solution where the maximum would lie, have none; and
        where A_sa,t* is 1 in float64 at the maximum, it is so around it: that is none either.

    Examples
    --------
    >>> import numpy, thirdbody
    >>> inputs = thirdbody.load_parameters()
    >>> condition = 90e-6, 0.4e-6, 0.3e-6, 1e11
    >>> loads = numpy.geomspace(1e-7, 1e-4, 30)
    >>> separation = thirdbody.solve(loads, *condition, inputs).separation
    >>> columns = [numpy.array([value]) for value in condition]
    >>> turning_points(separation[:, None], *columns, inputs).load.round(10)
    array([4.612e-07])
    """
    found = {field.name: np.full(separation.shape[1], np.nan) for field in fields(TurningPoints)}
    three_body = np.flatnonzero(has_particles(particle_diameter, particle_density))
    for _, table_rtol, places in search_ways(roughness[three_body], len(separation), rtol):
        curves = three_body[places]
        solids = make_contact(
            *(column[curves] for column in (particle_diameter, roughness, particle_density)),
            parameters,
            table_rtol,
        )
        curve, peak, width = highest_shares(solids, separation[:, curves], SEPARATION_MARGIN * rtol)
        if curve.size:
            refined = _state_at(solids.take(curve), viscosity[curves[curve]], peak, width, rtol)
            seen = refined["peak_ratio"] < 1.0  # else A_sa,t* is 1 on either side too
            curve, refined = curve[seen], {name: some[seen] for name, some in refined.items()}
            best = _highest(curve, refined["peak_ratio"])
            for name, values in refined.items():
                found[name][curves[curve[best]]] = values[best]
    return TurningPoints(**found)


def highest_shares(solids: Contact, separation: NDArray, rtol: float) -> tuple:
    """Find the interior maxima of A_sa,t* over the separation.

    Parameters
    ----------
    solids : Contact
        Surfaces and particles of each curve.
    separation : array, shape (separations, curves)
        d [m], falling from row to row; nan where there is no solution.
    rtol : float
        How closely the maxima are found, relative to d.

    Returns
    -------
    curve : array of int
        Index of the curve of each maximum; a curve may have several or none.
    separation : array
        d* [m] of each maximum.
    width : array
        Bound on the error of d* [m].
    """
    falling = solids.odds_slope(separation) > 0.0
    solved = np.isfinite(separation)
    step, curve = np.nonzero(solved[:-1] & solved[1:] & ~falling[:-1] & falling[1:])
    near, far = separation[step + 1, curve], separation[step, curve]
    slope = solids.take(curve).odds_slope
    return curve, *bracketed_roots(slope, near, far, rtol * near)


def particle_share(solids: Contact, separation: NDArray) -> NDArray:
    """A_sa,t* [1] at ``separation`` d [m] (Eq. 10)."""
    particle_area, log_summit_area = solids.areas(separation)
    return expit(np.log(particle_area) - log_summit_area)


def _highest(curve, ratio):
    """Index of the highest ratio of each curve."""
    order = np.lexsort((-ratio, curve))
    return order[np.unique(curve[order], return_index=True)[1]]


def _state_at(solids: Contact, viscosity, separation, width, rtol) -> dict:
    """The fields of ``TurningPoints`` at the maxima ``separation`` [m] known within ``width``, from
    functions that are good for ``rtol``."""
    bears = solids.log_solid_load(separation)
    solid = np.exp(bears.value)
    fluid = np.zeros_like(solid)
    steepest = np.abs(bears.slope)
    wet = viscosity > 0.0
    fluid[wet], film_slope = _fluid_load(viscosity[wet], separation[wet], solids.take(wet))
    steepest[wet] = np.maximum(steepest[wet], film_slope)
    load = solids.parameters.readings.film_load.total_load(solid, fluid)  # Eq. 1
    return {
        "load": load,
        "load_error": load * (steepest * width + rtol),
        "peak_ratio": particle_share(solids, separation),
        "solid_load_fraction": solid / load,
        "separation": separation,
    }


def _fluid_load(viscosity, separation, solids: Contact):
    """F_f* [1] of films that are ``separation`` d [m] thick, and |d ln F_f/dd| [m-1] (Eq. 7)."""
    inputs = solids.parameters
    film = Film.of(viscosity, solids.summits.roughness, inputs)
    log_parameter = film.load_parameter(separation / inputs.ball_radius)
    load = np.exp(log_parameter) * inputs.ball_radius**2 / inputs.apparent_area
    return load, 1.0 / np.abs(inputs.ball_radius * film.thickness(log_parameter)[1])
