"""Several separations that balance the forces: which one is taken, and how many there are.

Where F_s rises with d, F_s(d) + F_f(d) = F_t (Eq. 1) may hold at several separations.  Surfaces that
close meet the largest first, and stay there; so this is the one that is solved.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.model.contact import greatest_single_load
from thirdbody.solver.points import Points

SUMMIT_PLACES = -4.0, -2.0, 0.0, 2.0, 4.0, 8.0  # (d - y_s)/sigma_s between which F_s is sampled
SIZE_PLACES = -3.0, -1.5, 0.0, 1.5  # and (d - m)/S
SAMPLES = 24  # between two neighbouring places
ZOOMS = 8  # how often an extremum is looked at more closely, each time
CLOSER = 9  # at so many places
LEAST_TURN = 1e-10  # of a load: less than that is rounding
ROUNDED = 1e-12  # of a load: so near F_t a sample does not tell on which side it is


class Enclosures(NamedTuple):
    """Where the largest separations lie, each array 1-D.

    Attributes
    ----------
    low, high : array
        Separations [m] on either side of the largest that balances the forces.
    count : array of int
        How many there are.
    """

    low: NDArray
    high: NDArray
    count: NDArray


def may_be_several(points: Points) -> NDArray:
    """Whether more than one separation may balance the forces, at each point."""
    if points.contact.particles is None:
        return np.zeros(points.log_load.shape, bool)
    return np.exp(points.log_load) > greatest_single_load(points.parameters)


def enclose_largest(points: Points, start: NDArray, end: NDArray, with_film: bool) -> Enclosures:
    """Find all separations that balance the forces, and enclose the largest.

    Parameters
    ----------
    points : Points
        Points with particles.
    start : array
        The least separation d [m] to look at.
    end : array
        A separation [m] at which all that is there may still bear the load, or not.
    with_film : bool
        Whether the film bears the more, the closer the surfaces are; if not, solids alone count.

    Returns
    -------
    Enclosures
        ``count`` is 0, and ``low`` and ``high`` are nan, where nothing balances from ``start`` on.

    Notes
    -----
    The sum of loads is sampled between all places at which its parts change their ways, and again
    about each extremum that may reach F_t.  Two separations so close together that rounding hides
    what lies between pass for none.
    """

    def excess(separation, which):
        return _excess(separation, points.take(which), with_film)

    every = np.arange(start.size)
    end = np.maximum(end, start) + points.surfaces.deviation
    while (bears := excess(end, every) > 0.0).any():
        end = np.where(bears, 1.25 * end, end)
    places = _places(points, start, end)
    which = np.repeat(every, places.shape[1])
    values = excess(places.ravel(), which).reshape(places.shape)
    above = values > 0.0
    farthest = places.shape[1] - 1
    last = farthest - above[:, ::-1].argmax(axis=1)
    undecided = farthest - (values > -ROUNDED)[:, ::-1].argmax(axis=1)
    found = above.any(axis=1)
    low = np.where(found, places[every, last], np.nan)
    beyond = np.minimum(np.maximum(last, undecided) + 1, farthest)
    high = np.where(found, places[every, beyond], np.nan)
    count = (above[:, 1:] != above[:, :-1]).sum(axis=1)
    point, inside, outside = _hidden_pairs(excess, places, values)
    np.add.at(count, point, 2)
    for index, crest, foot in zip(point, inside, outside, strict=True):
        if crest > 0.0 and not crest <= low[index]:  # above F_t, and beyond all other separations
            low[index], high[index] = crest, foot
    return Enclosures(low, high, count)


def _excess(separation, points, with_film):
    """ln of the load that is borne at ``separation`` [m] over F_t."""
    value = points.contact.log_solid_load(separation).value - points.log_load
    if with_film:
        value = np.logaddexp(value, points.log_film_load(separation))
    return value


def _places(points, start, end):
    """Where loads are sampled, increasing from ``start`` to ``end``: a row for each point."""
    surfaces, particles = points.surfaces, points.contact.particles
    alphas = [particles.moment.largest, particles.moment.smallest, *SIZE_PLACES]
    shift = points.parameters.readings.elastic_limits.side * particles.depth
    kinks = [alpha + np.zeros_like(shift) for alpha in alphas]
    kinks += [alpha - shift for alpha in alphas]
    places = [particles.mean + alpha * particles.spread for alpha in kinks]
    places += [surfaces.offset + t * surfaces.deviation + 0.0 * start for t in SUMMIT_PLACES]
    edges = np.sort(np.clip(np.stack([start, *places, end], axis=1), start[:, None], end[:, None]))
    share = np.sin(0.5 * np.pi * np.arange(SAMPLES) / SAMPLES) ** 2
    share = share**2 * (3.0 - 2.0 * share)  # from 0 to 1, closest next to the kinks
    between = edges[:, :-1, None] + np.diff(edges)[..., None] * share
    return np.concatenate([between.reshape(start.size, -1), edges[:, -1:]], axis=1)


def _hidden_pairs(excess, places, values):
    """Pairs of separations between two samples, at which a crest just reaches F_t or a trough just
    falls below: their points, and two places, beyond F_t and farther out than that.

    The first place is 0 for a trough, whose separations are not the largest.
    """
    near = np.abs(values)
    rises = np.abs(np.diff(values))
    same = (values[:, :-2] > 0.0) == (values[:, 2:] > 0.0)
    same &= (values[:, 1:-1] > 0.0) == (values[:, 2:] > 0.0)
    turns = same & (near[:, 1:-1] < near[:, :-2]) & (near[:, 1:-1] <= near[:, 2:])
    turn = np.maximum(rises[:, :-1], rises[:, 1:])
    turns &= (near[:, 1:-1] < 4.0 * turn) & (turn > LEAST_TURN)
    point, place = np.nonzero(turns)
    low, high = places[point, place], places[point, place + 2]
    sign = np.where(values[point, place + 1] > 0.0, 1.0, -1.0)
    found = [np.zeros(0, np.intp)], [np.zeros(0)], [np.zeros(0)]
    for _ in range(ZOOMS):
        if not point.size:
            break
        fine = np.linspace(low, high, CLOSER, axis=1)
        which = np.repeat(point, CLOSER)
        closer = sign[:, None] * excess(fine.ravel(), which).reshape(fine.shape)
        best = np.clip(closer.argmin(axis=1), 1, CLOSER - 2)
        rows = np.arange(point.size)
        crosses = closer.min(axis=1) <= 0.0
        furthest = CLOSER - 1 - (closer <= 0.0)[:, ::-1].argmax(axis=1)
        crest = np.where(sign < 0.0, fine[rows, furthest], 0.0)
        foot = fine[rows, np.minimum(furthest + 1, CLOSER - 1)]
        for kept, column in zip(found, (point, crest, foot), strict=True):
            kept.append(column[crosses])
        low, high = fine[rows, best - 1], fine[rows, best + 1]
        point, low, high, sign = (column[~crosses] for column in (point, low, high, sign))
    return map(np.concatenate, found)
