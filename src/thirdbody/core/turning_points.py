"""Turning points of the contact area (TPCA).

As the load on a contact with particles increases, the particle fraction of the real contact area,
A_sa,t*, first increases because more particles touch, and decreases once many summits between them
touch.  "A_sa,t* exhibits a rise followed by a decrease as the load increases" (section 3.3).  A
curve has a turning point if A_sa,t* has a maximum within the range of loads, and this maximum
exceeds the least value at smaller loads, and the least value at larger loads, by ``PROMINENCE``.

For given particles and surface, A_sa,t* depends on the separation d alone.  The maximum is
therefore at the same separation d*, dry or lubricated, and the force balance (Eq. 1) gives its load
without a search over loads: F_t = F_s(d*) + F_f(d*).
"""

from dataclasses import dataclass, fields
from functools import partial

import numpy as np
import scipy  # scipy.special is loaded on first use: many jobs do not need it
from numpy.typing import NDArray

from thirdbody.core.bracketing import bracketed_roots
from thirdbody.core.contact import Contact
from thirdbody.core.film import load_of_film
from thirdbody.core.logarithms import TINY
from thirdbody.core.parameters import Parameters
from thirdbody.core.particles import has_particles
from thirdbody.core.solve import DEFAULT_RTOL

# ASSUME: least prominence of a turning point on both sides [1], a line width on an axis from 0 to 1
PROMINENCE = 0.02
# tolerance of d over that of the load: relative changes of F_t* are up to t^2 times those of d
SEPARATION_MARGIN = 1e-3


@dataclass(frozen=True, eq=False)
class TurningPoints:
    """The most prominent interior maximum of A_sa,t* of each curve, a turning point if ``exists``.

    The fields have the shape (curves,), with nan for curves without a maximum.  They are the load
    F_TPCA* [1] and a bound on its error, A_sa,t* and L_s [1], the separation d* [m], and the
    ``prominence`` [1].  The prominence is the excess of A_sa,t* over the least value at smaller
    loads, or over the least value at larger loads, whichever is less.
    """

    load: NDArray
    load_error: NDArray
    peak_ratio: NDArray
    solid_load_fraction: NDArray
    separation: NDArray
    prominence: NDArray

    @property
    def exists(self) -> NDArray[np.bool_]:
        """Whether a curve has a turning point, shape (curves,)."""
        return self.prominence >= PROMINENCE


def turning_points(
    separation: NDArray,
    viscosity: NDArray,
    particle_diameter: NDArray,
    roughness: NDArray,
    particle_density: NDArray,
    parameters: Parameters,
    rtol: float = DEFAULT_RTOL,
) -> TurningPoints:
    """Find the most prominent interior maximum of A_sa,t*(F_t*) on each curve.

    ``separation``, shape (loads, curves), are solved separations d [m] at increasing loads, nan
    without solution.  They only bracket the maxima.  The conditions are in SI, of shape (curves,).
    """
    found = {field.name: np.full(viscosity.shape, np.nan) for field in fields(TurningPoints)}
    three_body = np.flatnonzero(has_particles(particle_diameter, particle_density))
    if three_body.size == 0:
        return TurningPoints(**found)
    solids = Contact.of(
        particle_diameter[three_body],
        roughness[three_body],
        particle_density[three_body],
        parameters,
        rtol,
    )
    separation = separation[:, three_body]
    ends = np.fmax.reduce(separation), np.fmin.reduce(separation)
    which, peak, width, prominence = ratio_maxima(
        solids, separation, ends, SEPARATION_MARGIN * rtol
    )
    inside = np.flatnonzero(prominence > 0.0)
    # the index of the most prominent maximum of each curve
    order = inside[np.lexsort((-prominence[inside], which[inside]))]
    best = order[np.unique(which[order], return_index=True)[1]]
    curve = three_body[which[best]]
    contacts = solids.take(which[best])
    load, fraction, steepest = load_at(contacts, viscosity[curve], roughness[curve], peak[best])
    at_maxima = TurningPoints(
        load=load,
        load_error=load * (steepest * width[best] + rtol),
        peak_ratio=particle_ratio(contacts, peak[best]),
        solid_load_fraction=fraction,
        separation=peak[best],
        prominence=prominence[best],
    )
    for name, values in vars(at_maxima).items():
        found[name][curve] = values
    return TurningPoints(**found)


@np.errstate(divide="ignore", invalid="ignore")  # no particle may touch
def ratio_maxima(
    solids: Contact, separation: NDArray, ends: tuple[NDArray, NDArray], rtol: float
) -> tuple[NDArray, NDArray, NDArray, NDArray]:
    """Find the maxima of A_sa,t* over the separation, to ``rtol`` d.

    ``separation`` d [m], shape (separations, curves), decreases from row to row, nan without
    solution.  ``ends``, shape (curves,), are d [m] at the first and last load.  Returns the curve
    of each maximum, d* [m], a bound on the error of d*, and the prominence [1].  A maximum outside
    the curve has a negative prominence, minus its excess over the end.  The prominence is thus
    continuous, and 0 for a maximum at the end.
    """
    falling = odds_slope(solids, separation) > 0.0
    solved = np.isfinite(separation)
    bracket = solved[:-1] & solved[1:] & (falling[:-1] != falling[1:])
    step, curve = np.nonzero(bracket)
    near, far = separation[step + 1, curve], separation[step, curve]
    slope = partial(odds_slope, solids.take(curve))
    extremum, width = bracketed_roots(slope, near, far, rtol * near)
    ratio = particle_ratio(solids.take(curve), extremum)
    high = falling[step + 1, curve]
    prominence = _prominence(
        (curve[high], extremum[high], ratio[high]),
        (curve[~high], extremum[~high], ratio[~high]),
        np.array(ends),
        solids,
    )
    return curve[high], extremum[high], width[high], prominence


def _prominence(maxima, minima, ends, solids: Contact) -> NDArray:
    """The prominence of maxima: ``maxima`` and ``minima`` have curve, d [m] and A_sa,t*."""
    curve, extremum, ratio = maxima
    first, last = ends[:, curve]
    before, after = ratio - particle_ratio(solids.take(curve), np.stack([first, last]))
    before = np.where(extremum < first, before, -np.abs(before))
    after = np.where(extremum > last, after, -np.abs(after))
    inside = (last < extremum) & (extremum < first)
    for other, valley, least in zip(*minima, strict=True):  # minima are rare
        between = inside & (curve == other) & (last < valley) & (valley < first)
        for side, beside in ((before, valley > extremum), (after, valley < extremum)):
            side[between & beside] = np.maximum(side, ratio - least)[between & beside]
    return np.minimum(before, after)


@np.errstate(divide="ignore", invalid="ignore")  # no particle may touch
def particle_ratio(solids: Contact, separation: NDArray) -> NDArray:
    """A_sa,t* [1] at ``separation`` d [m] (Eq. 10)."""
    state = solids.at(separation, with_areas=True)
    return scipy.special.expit(np.log(state.particle_area.value) - state.log_summit_area.value)


@np.errstate(divide="ignore", invalid="ignore")  # no particle may touch
def load_at(
    solids: Contact, viscosity: NDArray, roughness: NDArray, separation: NDArray
) -> tuple[NDArray, NDArray, NDArray]:
    """F_t* [1] at ``separation`` d [m] (Eq. 1), L_s [1], and the largest |d ln F/dd| [m-1] of
    solids and film: arrays of one shape."""
    inputs, log_solid = solids.parameters, solids.at(separation).log_load
    solid_load = np.exp(log_solid.value)
    film, film_slope = load_of_film(separation, viscosity, roughness, inputs)
    load = inputs.total_load(solid_load, film)
    return load, solid_load / load, np.maximum(np.abs(log_solid.slope), np.abs(film_slope))


def odds_slope(solids: Contact, separation: NDArray) -> NDArray:
    """(dA_sa/dd - A_sa d ln A_ss-sa/dd)/A_n [m-1], which has the sign of dA_sa,t*/dd.

    It is negative where no particle touches.
    """
    state = solids.at(separation, with_areas=True)
    area = state.particle_area
    slope = area.slope - area.value * state.log_summit_area.slope
    return np.where(area.value > 0.0, slope, -TINY)
