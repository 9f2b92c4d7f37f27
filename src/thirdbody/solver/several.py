"""Force balances with several roots: find the largest and count all.

Where F_s increases with d, F_s(d) + F_f(d) = F_t (Eq. 1) may have several roots.  Approaching
surfaces reach the largest first and stay there, so this one is the solution.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.model.floats import EPSILON
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


class _Samples(NamedTuple):
    """The force balance at increasing separations [m], a row for each point: ``excess`` is
    ln((F_s + F_f)/F_t) [1], and ``noise`` its error from rounding."""

    separation: NDArray
    excess: NDArray
    noise: NDArray

    @property
    def above(self):
        """Where loads are certainly too large."""
        return self.excess > self.noise

    @property
    def below(self):
        """Where loads are certainly too small, or unknown."""
        return ~(self.excess >= -self.noise)


class _Pairs(NamedTuple):
    """Pairs of roots close to an extremum: the index of the ``point`` of each; a separation [m] on the
    ``crest``, 0 for a trough, whose roots are not the largest; one farther out, at the ``foot``, where
    loads are certainly too small; and whether F_t is crossed by more than rounding (``certain``)."""

    point: NDArray
    crest: NDArray
    foot: NDArray
    certain: NDArray


def bracket_largest(points: Points, start: NDArray, end: NDArray) -> Largest:
    """Find all roots of the force balance from ``start`` [m] on, and bracket the largest.

    The total load is sampled between all kinks of its contributions, up to beyond ``end`` [m] and
    all contacts, and again around each extremum that may reach F_t.
    """
    samples = _sampled(points, start, end)
    largest, known = _largest_change(samples), samples.above | samples.below
    samples = _without_covered(points, samples)
    pairs = _close_pairs(points, samples)
    count = _changes(samples.excess > 0.0, known)
    np.add.at(count, pairs.point[pairs.certain], 2)
    found = ~np.isnan(largest.low)  # a root only under full coverage, or on a plateau, counts too
    _move_to_crests(largest, pairs)
    return largest._replace(count=np.maximum(count, found))


def _excess(points, separation, which):
    """ln((F_s + F_f)/F_t) and its noise at separations [m], with a row for each of the indices
    ``which`` of points."""
    forces = points.take(which).forces(separation.T)
    return forces.excess.value.T, LOAD_ROUNDING + forces.errors.noise.T


def _sampled(points, start, end):
    """Samples from ``start`` [m] to beyond ``end`` [m] and all contacts, where loads are too small."""
    every = np.arange(start.size)
    # farther out, summits and particles together may carry more than each alone
    end = np.maximum(np.maximum(end, start), points.contact.particles.reach)
    end = end + points.contact.summits.deviation
    while (too_large := _excess(points, end, every)[0] > -LOAD_ROUNDING).any():
        end = np.where(too_large, 1.25 * end, end)
    separation = _separations(points, start, end)
    excess, noise = _excess(points, separation, every)
    return _Samples(separation=separation, excess=excess, noise=noise)


def _largest_change(samples):
    """The largest root between samples of different sign; its count is left open."""
    separation, above, below = samples.separation, samples.above, samples.below
    every, farthest = np.arange(len(separation)), separation.shape[1] - 1
    positive = samples.excess > 0.0
    decided = above.any(axis=1)
    before = np.where(decided, _last(above), _last(positive))
    last = np.maximum(_last(~below), before)  # beyond it loads are certainly too small
    after = separation[every, np.minimum(last + 1, farthest)]
    # a single undecided sample next to the root does not matter
    undecided = separation[every, last] > separation[every, np.minimum(before + 1, farthest)]
    found = positive.any(axis=1)
    return Largest(
        low=np.where(found, separation[every, before], np.nan),
        high=np.where(found, after, np.nan),
        count=np.zeros(len(separation), int),
        undecided=np.where(decided, undecided, ~below.all(axis=1)),
    )


def _move_to_crests(largest, pairs):
    """Move the largest roots to crests beyond them, where F_t is certainly exceeded."""
    for point, crest, foot, certain in zip(*pairs, strict=True):
        if crest > 0.0 and not crest <= largest.low[point]:  # also if there is no root yet
            largest.undecided[point] |= not certain
            if certain:
                largest.low[point], largest.high[point] = crest, foot


def _without_covered(points, samples):
    """The samples; where particles cover everything, and the excess has no meaning, with the first one
    where they do not."""
    particles = points.contact.particles

    def is_bare(separation, which):
        _, coverage = particles.take(which).contact(separation.T)
        return 1.0 - coverage.value.T > EPSILON

    rows, columns = samples.separation.shape
    bare = is_bare(samples.separation, np.arange(rows))
    first = bare.argmax(axis=1)  # coverage decreases with d
    some = np.flatnonzero(first)
    low, high = (samples.separation[some, first[some] - side] for side in (1, 0))
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        here = is_bare(middle, some)
        low, high = np.where(here, low, middle), np.where(here, middle, high)
    there, _ = _excess(points, high, some)
    excess, covered = samples.excess.copy(), np.arange(columns) < first[some, np.newaxis]
    excess[some] = np.where(covered, there[:, np.newaxis], excess[some])
    return samples._replace(excess=excess)


def _last(holds):
    """Index of the last true element of each row of ``holds``; of the last element if none is true."""
    return holds.shape[1] - 1 - holds[:, ::-1].argmax(axis=1)


def _changes(signs, known):
    """Number of sign changes along each row, between elements where the signs are ``known``."""
    latest = np.maximum.accumulate(np.where(known, np.arange(signs.shape[1]), 0), axis=1)
    signs = np.take_along_axis(signs, latest, axis=1)
    return (signs[:, 1:] != signs[:, :-1]).sum(axis=1)


def _separations(points, start, end):
    """Separations [m] to sample, increasing from ``start`` to ``end``: a row for each point."""
    surfaces, particles = points.contact.summits, points.contact.particles
    alphas = [particles.moment.largest, particles.moment.smallest, *SIZE_KNOTS]
    shifts = 0.0, points.parameters.interpretation.elastic_limits.side * particles.depth
    knots = [particles.mean + (a - shift) * particles.spread for a in alphas for shift in shifts]
    knots += [surfaces.offset + t * surfaces.deviation + 0.0 * start for t in SUMMIT_KNOTS]
    edges = np.sort(np.clip(np.stack([start, *knots, end], axis=1), start[:, None], end[:, None]))
    part = np.sin(0.5 * np.pi * np.arange(SAMPLES) / SAMPLES) ** 2
    part = part**2 * (3.0 - 2.0 * part)  # from 0 to 1, clustered at the kinks
    between = edges[:, :-1, None] + np.diff(edges)[..., None] * part
    return np.concatenate([between.reshape(start.size, -1), edges[:, -1:]], axis=1)


@dataclass
class _Turns:
    """Extrema that may cross F_t, each between ``low`` and ``high`` [m]: a crest has the ``sign`` -1, a
    trough 1.  ``point`` and ``foot`` are as in ``_Pairs``."""

    point: NDArray
    low: NDArray
    high: NDArray
    sign: NDArray
    foot: NDArray

    @classmethod
    def of(cls, samples: _Samples) -> "_Turns":
        """The extrema between samples of one sign; those within the noise are ignored."""
        separation, excess, noise = samples
        point, place = np.nonzero(_may_cross(excess, noise))
        beyond = (excess < -noise)[point] & (np.arange(excess.shape[1]) > place[:, None] + 1)
        first_beyond = np.where(beyond.any(axis=1), beyond.argmax(axis=1), -1)
        return cls(
            point=point,
            low=separation[point, place],
            high=separation[point, place + 2],
            sign=np.where(excess[point, place + 1] > 0.0, 1.0, -1.0),
            foot=separation[point, first_beyond],
        )

    def keep(self, kept: NDArray) -> None:
        """Go on with those ``kept``."""
        for name, each in vars(self).items():
            setattr(self, name, each[kept])


def _may_cross(excess, noise):
    """Whether the excess turns towards 0 at each sample but the first and last, without a change of
    sign, and so near to 0 that it may cross it."""
    near, rises = np.abs(excess), np.abs(np.diff(excess))
    positive = excess > 0.0
    same = (positive[:, :-2] == positive[:, 2:]) & (positive[:, 1:-1] == positive[:, 2:])
    turns = same & (near[:, 1:-1] < near[:, :-2]) & (near[:, 1:-1] <= near[:, 2:])
    rise = np.maximum(rises[:, :-1], rises[:, 1:])
    return turns & (near[:, 1:-1] < 4.0 * rise) & (rise > noise[:, 1:-1])


def _close_pairs(points, samples):
    """The pairs of roots between samples of one sign, where a crest just exceeds F_t or a trough just
    falls below it."""
    turns = _Turns.of(samples)
    found = [_Pairs(*np.zeros((4, 0)))]
    for zoom in range(ZOOMS):
        if not turns.point.size:
            break
        pairs, reached = _zoomed(points, turns, is_last=zoom == ZOOMS - 1)
        found.append(_Pairs._make(column[reached] for column in pairs))
        turns.keep(~reached)
    point, crest, foot, certain = map(np.concatenate, zip(*found, strict=True))
    return _Pairs(point=point.astype(np.intp), crest=crest, foot=foot, certain=certain.astype(bool))


def _zoomed(points, turns, is_last):
    """Sample each of the ``turns`` more finely, and narrow it about the sample nearest to F_t.

    Returns the pair of roots at each, and where there is one; at the last time also where one is
    only possible.
    """
    fine = np.linspace(turns.low, turns.high, ZOOM_SAMPLES, axis=1)
    excess, noise = _excess(points, fine, turns.point)
    closer = turns.sign[:, None] * excess
    certain = (closer < -noise).any(axis=1)
    # between the last samples, values may be higher by their spread
    nearly = closer <= noise + np.ptp(closer, axis=1, keepdims=True)
    reached = nearly.any(axis=1) if is_last else certain
    farthest = _last(np.where(certain[:, None], closer < -noise, nearly))
    rows, best = np.arange(len(fine)), np.clip(closer.argmin(axis=1), 1, ZOOM_SAMPLES - 2)
    crest = np.where(turns.sign < 0.0, fine[rows, farthest], 0.0)
    turns.low, turns.high = fine[rows, best - 1], fine[rows, best + 1]
    return _Pairs(point=turns.point, crest=crest, foot=turns.foot, certain=certain), reached
