"""Several separations that balance the forces: which one is taken, and how many there are.

Where F_s rises with d, F_s(d) + F_f(d) = F_t (Eq. 1) may hold at several separations.  Surfaces that
close meet the largest first, and stay there; so this is the one that is solved.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from thirdbody.model.contact import greatest_single_load
from thirdbody.model.particles import EPSILON
from thirdbody.solver.points import Points

SUMMIT_PLACES = -4.0, -2.0, 0.0, 2.0, 4.0, 8.0  # (d - y_s)/sigma_s between which F_s is sampled
SIZE_PLACES = -3.0, -1.5, 0.0, 1.5  # and (d - m)/S
SAMPLES = 24  # between two neighbouring places
ZOOMS = 8  # how often an extremum is looked at more closely, each time
CLOSER = 9  # at so many places
HALVINGS = 60  # of an interval, which leave only rounding
ROUNDED = 1e-12  # of a load, beside the noise of solids: nearer to F_t no sample tells its side


def may_be_several(points: Points) -> NDArray:
    """Whether more than one separation may balance the forces, at each point."""
    if points.contact.particles is None:
        return np.zeros(points.log_load.shape, bool)
    return np.exp(points.log_load) > greatest_single_load(points.parameters)


def enclose_largest(
    points: Points, start: NDArray, end: NDArray
) -> tuple[NDArray, NDArray, NDArray, NDArray]:
    """Find all separations that balance the forces from ``start`` [m] on, and enclose the largest.

    The sum of loads is sampled between all places at which its parts change their ways, to beyond
    ``end`` [m] and all that carries, and again about each extremum that may reach F_t.

    Returns separations [m] on either side of the largest, nan where nothing balances; how many there
    are, of which two so close together that rounding hides what lies between pass for none; and
    whether rounding leaves open which is the largest, or whether there is any, as loads stay near F_t
    along a plateau or at a crest.
    """

    def excess(separation, which):
        forces = points.take(which).forces(separation)
        return forces.excess, ROUNDED + forces.noise

    every = np.arange(start.size)
    # two bodies together may carry more, farther out, than either of them alone
    end = np.maximum(np.maximum(end, start), points.contact.particles.reach)
    end = end + points.contact.summits.deviation
    while (carries := excess(end, every)[0] > -ROUNDED).any():
        end = np.where(carries, 1.25 * end, end)
    places = _places(points, start, end)
    which = np.repeat(every, places.shape[1])
    values, noise = (each.reshape(places.shape) for each in excess(places.ravel(), which))
    above, below = values > noise, ~(values >= -noise)
    farthest = places.shape[1] - 1
    found, decided = (values > 0.0).any(axis=1), above.any(axis=1)
    before = np.where(decided, _last(above), _last(values > 0.0))
    last = np.maximum(_last(~below), before)  # beyond it loads are too small for certain
    low = np.where(found, places[every, before], np.nan)
    high = np.where(found, places[every, np.minimum(last + 1, farthest)], np.nan)
    # a single place next to the separation may be as good as on it
    undecided = places[every, last] > places[every, np.minimum(before + 1, farthest)]
    undecided = np.where(decided, undecided, ~below.all(axis=1))
    values = _where_room_is_left(points.contact.particles, excess, places, values)
    count = _changes(values > 0.0, above | below)
    pairs = _hidden_pairs(excess, places, values, noise)
    point, *_, certain = pairs
    np.add.at(count, point[certain], 2)
    count = np.maximum(count, found)  # where it balances under full cover alone, or along a plateau
    for index, crest, foot, certain in zip(*pairs, strict=True):
        if crest > 0.0 and not crest <= low[index]:  # above F_t, and beyond all other separations
            undecided[index] |= not certain
            if certain:
                low[index], high[index] = crest, foot
    return low, high, count, undecided


def _where_room_is_left(particles, excess, places, values):
    """The ``values`` where particles cover everything, which mean nothing, become that where they begin
    to leave room."""

    def is_room(separation, which):
        return 1.0 - particles.take(which).contact(separation)[2] > EPSILON

    rows, columns = places.shape
    room = is_room(places.ravel(), np.repeat(np.arange(rows), columns)).reshape(places.shape)
    first = room.argmax(axis=1)  # as coverage falls with d
    some = np.flatnonzero(first)
    low, high = places[some, first[some] - 1], places[some, first[some]]
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        wide = is_room(middle, some)
        low, high = np.where(wide, low, middle), np.where(wide, middle, high)
    there, _ = excess(high, some)
    values = values.copy()
    covered = np.arange(columns) < first[some, np.newaxis]
    values[some] = np.where(covered, there[:, np.newaxis], values[some])
    return values


def _last(holds):
    """Index of the last place of each row that ``holds``; that of the last one where none does."""
    return holds.shape[1] - 1 - holds[:, ::-1].argmax(axis=1)


def _changes(signs, known):
    """How often ``signs`` change along each row, between places where they are ``known``."""
    latest = np.maximum.accumulate(np.where(known, np.arange(signs.shape[1]), 0), axis=1)
    signs = np.take_along_axis(signs, latest, axis=1)
    return (signs[:, 1:] != signs[:, :-1]).sum(axis=1)


def _places(points, start, end):
    """Where loads are sampled, increasing from ``start`` to ``end``: a row for each point."""
    surfaces, particles = points.contact.summits, points.contact.particles
    alphas = [particles.moment.largest, particles.moment.smallest, *SIZE_PLACES]
    shift = points.parameters.interpretation.elastic_limits.side * particles.depth
    kinks = [alpha + np.zeros_like(shift) for alpha in alphas]
    kinks += [alpha - shift for alpha in alphas]
    places = [particles.mean + alpha * particles.spread for alpha in kinks]
    places += [surfaces.offset + t * surfaces.deviation + 0.0 * start for t in SUMMIT_PLACES]
    edges = np.sort(np.clip(np.stack([start, *places, end], axis=1), start[:, None], end[:, None]))
    part = np.sin(0.5 * np.pi * np.arange(SAMPLES) / SAMPLES) ** 2
    part = part**2 * (3.0 - 2.0 * part)  # from 0 to 1, closest next to the kinks
    between = edges[:, :-1, None] + np.diff(edges)[..., None] * part
    return np.concatenate([between.reshape(start.size, -1), edges[:, -1:]], axis=1)


def _hidden_pairs(excess, places, values, noise):
    """Pairs of separations between samples that all are on one side of F_t, where a crest just reaches
    F_t or a trough just falls below; a turn within the ``noise`` is none.

    Returns for each pair its point, a place [m] on its crest and one farther out where loads are too
    small for certain, and whether F_t is reached by more than rounding.  The crest is 0 for a trough,
    whose separations are not the largest.
    """
    near = np.abs(values)
    rises = np.abs(np.diff(values))
    same = (values[:, :-2] > 0.0) == (values[:, 2:] > 0.0)
    same &= (values[:, 1:-1] > 0.0) == (values[:, 2:] > 0.0)
    turns = same & (near[:, 1:-1] < near[:, :-2]) & (near[:, 1:-1] <= near[:, 2:])
    turn = np.maximum(rises[:, :-1], rises[:, 1:])
    turns &= (near[:, 1:-1] < 4.0 * turn) & (turn > noise[:, 1:-1])
    point, place = np.nonzero(turns)
    low, high = places[point, place], places[point, place + 2]
    beyond = (values < -noise)[point] & (np.arange(places.shape[1]) > place[:, None] + 1)
    foot = places[point, np.where(beyond.any(axis=1), beyond.argmax(axis=1), -1)]
    sign = np.where(values[point, place + 1] > 0.0, 1.0, -1.0)
    found = [np.zeros((4, 0))]
    for zoom in range(ZOOMS):
        if not point.size:
            break
        fine = np.linspace(low, high, CLOSER, axis=1)
        which = np.repeat(point, CLOSER)
        value, noise = (each.reshape(fine.shape) for each in excess(fine.ravel(), which))
        closer = sign[:, None] * value
        best = np.clip(closer.argmin(axis=1), 1, CLOSER - 2)
        rows = np.arange(point.size)
        certain = (closer < -noise).any(axis=1)
        # what lies between the last samples may be as much higher as they differ
        nearly = closer <= noise + np.ptp(closer, axis=1, keepdims=True)
        reached = certain if zoom < ZOOMS - 1 else nearly.any(axis=1)
        furthest = _last(np.where(certain[:, None], closer < -noise, nearly))
        crest = np.where(sign < 0.0, fine[rows, furthest], 0.0)
        found.append([column[reached] for column in (point, crest, foot, certain)])
        low, high = fine[rows, best - 1], fine[rows, best + 1]
        left = point, low, high, sign, foot
        point, low, high, sign, foot = (column[~reached] for column in left)
    point, crest, foot, certain = map(np.concatenate, zip(*found, strict=True))
    return point.astype(np.intp), crest, foot, certain.astype(bool)
