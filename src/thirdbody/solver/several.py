"""Force balances with several roots: find the largest and count all.

Where F_s increases with d, F_s(d) + F_f(d) = F_t (Eq. 1) may have several roots.  Approaching
surfaces reach the largest first and stay there, so this one is the solution.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.model.particles import EPSILON
from thirdbody.solver.points import Points

SUMMIT_KNOTS = -4.0, -2.0, 0.0, 2.0, 4.0, 8.0  # (d - y_s)/sigma_s between which F_s is sampled
SIZE_KNOTS = -3.0, -1.5, 0.0, 1.5  # and (d - m)/S
SAMPLES = 24  # between two neighbouring knots
ZOOMS = 8  # refinements about an extremum
ZOOM_SAMPLES = 9  # samples in each refinement
BISECTIONS = 60  # bisections that reduce an interval to rounding
LOAD_ROUNDING = 1e-12  # of a load, plus the noise of solids: closer to F_t a sign is uncertain


class Largest(NamedTuple):
    """The largest root of the force balance at each point: separations [m] on both sides of it, nan
    without one.

    ``count`` is the number of roots, where two are not counted if rounding hides what lies between
    them.  Rounding may leave the largest root, or its existence, ``undecided``, as on a plateau or at a
    crest near F_t.
    """

    low: NDArray
    high: NDArray
    count: NDArray
    undecided: NDArray


def bracket_largest(points: Points, start: NDArray, end: NDArray) -> Largest:
    """Find all roots of the force balance from ``start`` [m] on, and bracket the largest.

    The total load is sampled between all kinks of its contributions, up to beyond ``end`` [m] and
    all contacts, and again around each extremum that may reach F_t.
    """

    def excess(separation, which):
        forces = points.take(which).forces(separation)
        return forces.excess.value, LOAD_ROUNDING + forces.errors.noise

    every = np.arange(start.size)
    # farther out, summits and particles together may carry more than each alone
    end = np.maximum(np.maximum(end, start), points.contact.particles.reach)
    end = end + points.contact.summits.deviation
    while (too_large := excess(end, every)[0] > -LOAD_ROUNDING).any():
        end = np.where(too_large, 1.25 * end, end)
    samples = _samples(points, start, end)
    which = np.repeat(every, samples.shape[1])
    values, noise = (each.reshape(samples.shape) for each in excess(samples.ravel(), which))
    above, below = values > noise, ~(values >= -noise)
    farthest = samples.shape[1] - 1
    found, decided = (values > 0.0).any(axis=1), above.any(axis=1)
    before = np.where(decided, _last(above), _last(values > 0.0))
    last = np.maximum(_last(~below), before)  # beyond it loads are certainly too small
    low = np.where(found, samples[every, before], np.nan)
    high = np.where(found, samples[every, np.minimum(last + 1, farthest)], np.nan)
    # a single undecided sample next to the root does not matter
    undecided = samples[every, last] > samples[every, np.minimum(before + 1, farthest)]
    undecided = np.where(decided, undecided, ~below.all(axis=1))
    values = _replace_covered(points.contact.particles, excess, samples, values)
    count = _changes(values > 0.0, above | below)
    pairs = _close_pairs(excess, samples, values, noise)
    point, *_, certain = pairs
    np.add.at(count, point[certain], 2)
    count = np.maximum(count, found)  # a root only under full coverage, or on a plateau
    for index, crest, foot, certain in zip(*pairs, strict=True):
        if crest > 0.0 and not crest <= low[index]:  # above F_t, and beyond all other roots
            undecided[index] |= not certain
            if certain:
                low[index], high[index] = crest, foot
    return Largest(low=low, high=high, count=count, undecided=undecided)


def _replace_covered(particles, excess, samples, values):
    """Replace ``values`` where particles cover everything, which have no meaning, by the first one
    where they do not."""

    def is_bare(separation, which):
        _, coverage = particles.take(which).contact(separation)
        return 1.0 - coverage.value > EPSILON

    rows, columns = samples.shape
    bare = is_bare(samples.ravel(), np.repeat(np.arange(rows), columns)).reshape(samples.shape)
    first = bare.argmax(axis=1)  # coverage decreases with d
    some = np.flatnonzero(first)
    low, high = samples[some, first[some] - 1], samples[some, first[some]]
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        here = is_bare(middle, some)
        low, high = np.where(here, low, middle), np.where(here, middle, high)
    there, _ = excess(high, some)
    values = values.copy()
    covered = np.arange(columns) < first[some, np.newaxis]
    values[some] = np.where(covered, there[:, np.newaxis], values[some])
    return values


def _last(holds):
    """Index of the last true element of each row of ``holds``; of the last element if none is true."""
    return holds.shape[1] - 1 - holds[:, ::-1].argmax(axis=1)


def _changes(signs, known):
    """Number of sign changes along each row, between elements where the signs are ``known``."""
    latest = np.maximum.accumulate(np.where(known, np.arange(signs.shape[1]), 0), axis=1)
    signs = np.take_along_axis(signs, latest, axis=1)
    return (signs[:, 1:] != signs[:, :-1]).sum(axis=1)


def _samples(points, start, end):
    """Separations [m] to sample, increasing from ``start`` to ``end``: a row for each point."""
    surfaces, particles = points.contact.summits, points.contact.particles
    alphas = [particles.moment.largest, particles.moment.smallest, *SIZE_KNOTS]
    shifts = 0.0, points.parameters.interpretation.elastic_limits.side * particles.depth
    samples = [particles.mean + (a - shift) * particles.spread for a in alphas for shift in shifts]
    samples += [surfaces.offset + t * surfaces.deviation + 0.0 * start for t in SUMMIT_KNOTS]
    edges = np.sort(np.clip(np.stack([start, *samples, end], axis=1), start[:, None], end[:, None]))
    part = np.sin(0.5 * np.pi * np.arange(SAMPLES) / SAMPLES) ** 2
    part = part**2 * (3.0 - 2.0 * part)  # from 0 to 1, clustered at the kinks
    between = edges[:, :-1, None] + np.diff(edges)[..., None] * part
    return np.concatenate([between.reshape(start.size, -1), edges[:, -1:]], axis=1)


def _close_pairs(excess, samples, values, noise):
    """Pairs of roots between samples of one sign, where a crest just exceeds F_t or a trough just
    falls below it; extrema within the ``noise`` are ignored.

    Returns for each pair its point, a separation [m] on its crest and one farther out where loads
    are certainly too small, and whether F_t is exceeded by more than rounding.  The crest is 0 for
    a trough, whose roots are not the largest.
    """
    near = np.abs(values)
    rises = np.abs(np.diff(values))
    same = (values[:, :-2] > 0.0) == (values[:, 2:] > 0.0)
    same &= (values[:, 1:-1] > 0.0) == (values[:, 2:] > 0.0)
    turns = same & (near[:, 1:-1] < near[:, :-2]) & (near[:, 1:-1] <= near[:, 2:])
    turn = np.maximum(rises[:, :-1], rises[:, 1:])
    turns &= (near[:, 1:-1] < 4.0 * turn) & (turn > noise[:, 1:-1])
    point, place = np.nonzero(turns)
    low, high = samples[point, place], samples[point, place + 2]
    beyond = (values < -noise)[point] & (np.arange(samples.shape[1]) > place[:, None] + 1)
    foot = samples[point, np.where(beyond.any(axis=1), beyond.argmax(axis=1), -1)]
    sign = np.where(values[point, place + 1] > 0.0, 1.0, -1.0)
    found = [np.zeros((4, 0))]
    for zoom in range(ZOOMS):
        if not point.size:
            break
        fine = np.linspace(low, high, ZOOM_SAMPLES, axis=1)
        which = np.repeat(point, ZOOM_SAMPLES)
        value, noise = (each.reshape(fine.shape) for each in excess(fine.ravel(), which))
        closer = sign[:, None] * value
        best = np.clip(closer.argmin(axis=1), 1, ZOOM_SAMPLES - 2)
        rows = np.arange(point.size)
        certain = (closer < -noise).any(axis=1)
        # between the last samples, values may be higher by their spread
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
