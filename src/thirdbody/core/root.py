"""The force balance F_t = F_s(d) + F_f(d) (Eq. 1), solved for the separation d.

A root is accepted only if the sum of forces changes sign between two separations around it, by more
than rounding and table errors.  All variables are means of their values at these two, and the
differences bound the error.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.core.balance import Forces, Points
from thirdbody.core.brackets import Brackets
from thirdbody.core.logarithms import EPSILON

NARROW = 4.0 * EPSILON  # relative width of the narrowest bracket
GROWTH = 4.0  # growth of an interval whose signs rounding hides
SETTLED = 2.0  # of the noise: an excess below it cannot be halved for certain
# Half width of the interval, over the changes of d that the tolerance and the noise amount to.  It
# is wide enough for certain signs, and narrow enough for the bound.
WIDTH, NOISE_WIDTH = 0.125, 1.2


class EnclosedRoots(NamedTuple):
    """Solved ``points``, their ``indices`` among all points, and the ``forces`` at two separations
    around each root, of shape (2, points).  ``certain`` is whether the sum of forces changes its
    sign despite rounding, or need not change it."""

    points: Points
    indices: NDArray
    forces: Forces
    certain: NDArray


def enclose(
    points: Points, brackets: Brackets, tolerance: float, iterations: int
) -> Iterator[EnclosedRoots]:
    """Narrow the brackets by Newton's method until the variables converge to ``tolerance``.

    Yields the points as they are solved.  When the next step would converge, the signs on both
    sides of it are checked; if rounding could hide them, the interval is widened.  After so many
    ``iterations``, the rest is not ``certain``.
    """
    fixed = brackets.held | np.isnan(brackets.low)
    if fixed.any():
        yield _fixed(points, brackets, np.flatnonzero(fixed))
    rest = np.flatnonzero(~fixed)
    search = Search(
        points=points.take(rest),
        indices=rest,
        separation=brackets.guess[rest],
        low=brackets.low[rest],
        high=brackets.high[rest],
        previous=np.full(rest.shape, np.inf),
        widening=np.ones(rest.shape),
    )
    for iteration in range(iterations):
        if not search.indices.size:
            break
        interval = search.step(tolerance, is_last=iteration == iterations - 1)
        if interval.which.size:
            solved = search.check(interval)
            if solved.indices.size:
                yield solved


def _fixed(points, brackets, indices):
    """The points at ``indices``, where the film keeps its separation or nothing carries the
    load."""
    chosen = points.take(indices)
    forces = chosen.forces(
        np.stack([brackets.low[indices], brackets.high[indices]]), with_areas=True
    )
    return EnclosedRoots(
        points=chosen,
        indices=indices,
        forces=_rest_to_film(forces),
        certain=np.ones(indices.shape, bool),
    )


def _rest_to_film(forces):
    """The forces where a film of known thickness carries the load that the solids leave."""
    log_solid = forces.log_solid.value
    fluid = -np.expm1(np.minimum(log_solid, 0.0))
    less = np.exp(log_solid) / fluid  # F_s/F_f, which magnifies the rounding of F_s
    rounding = forces.errors.rounding + forces.solid_noise * less
    errors = forces.errors._replace(rounding=rounding)
    return forces._replace(log_fluid=np.log(fluid), errors=errors)


class Interval(NamedTuple):
    """Two separations [m] around the roots of some points, between which the sum of forces should
    change sign.  ``which`` are their indices; where ``is_final`` it is accepted in any case."""

    which: NDArray
    low: NDArray
    high: NDArray
    is_final: NDArray


@dataclass
class Search:
    """Newton's method at many points; solved points leave the search.

    ``indices`` are those of the points among all points.  The root is between ``low`` and ``high``
    [m], and forces are next evaluated at ``separation``.  ``previous`` is the size of the excess
    before the last step, or infinite if that was not a step of Newton's method.  ``widening``
    multiplies the width of the interval whose signs are checked.
    """

    points: Points
    indices: NDArray
    separation: NDArray
    low: NDArray
    high: NDArray
    previous: NDArray
    widening: NDArray

    def keep(self, kept: NDArray) -> None:
        """Go on with the points of the indices ``kept``."""
        for name, column in vars(self).items():
            setattr(self, name, column.take(kept))

    def step(self, tolerance: float, is_last: bool) -> Interval:
        """Narrow the brackets by the forces at the separations, and take the next step.

        Newton's step is taken while steps halve the excess; otherwise the bracket is halved.
        Returns an interval around the new separation where the next step would converge.
        """
        forces = self.points.forces(self.separation)
        excess, slope = forces.excess
        noise, steepest = forces.errors.noise, forces.errors.steepest
        self.low = np.where(excess > noise, self.separation, self.low)
        self.high = np.where(excess < -noise, self.separation, self.high)
        size, settled = np.abs(excess), np.abs(excess) <= SETTLED * noise
        new = self.separation - excess / slope
        is_newton = (
            (new >= self.low) & (new <= self.high) & (settled | (size <= 0.5 * self.previous))
        )
        # the slope of the contribution that changes fastest, over that of the sum of forces
        ratio = steepest / np.abs(slope)
        # Estimated error of the variables after the step: its square, and more where a contribution
        # changes faster.  It is only an estimate: the signs at both ends are checked afterwards.
        left = (size * ratio) ** 2 * (1.0 + ratio)
        converges = is_newton & (settled | (left <= tolerance))
        is_final = (self.high - self.low <= NARROW * self.separation) | is_last
        self.separation = np.where(is_newton, new, 0.5 * (self.low + self.high))
        self.previous = np.where(is_newton, size, np.inf)
        width = np.maximum(WIDTH * tolerance / steepest, NOISE_WIDTH * noise / np.abs(slope))
        width = self.widening * np.maximum(width, NARROW * self.separation)
        return self._interval(np.flatnonzero(converges | is_final), width, is_final)

    def _interval(self, which, width, is_final):
        """The interval of a ``width`` [m] to both sides of the separations, within the brackets."""
        middle, low, high = self.separation[which], self.low[which], self.high[which]
        width, is_final = width[which], is_final[which]
        return Interval(
            which=which,
            low=np.where(is_final, low, np.fmax(middle - width, low)),
            high=np.where(is_final, high, np.fmin(middle + width, high)),
            is_final=is_final,
        )

    def check(self, interval: Interval) -> EnclosedRoots:
        """The points where the sum of forces changes sign in the ``interval``; they leave the
        search.

        The others go on beyond the interval, or in a wider one.
        """
        which = interval.which
        both = np.stack([interval.low, interval.high])
        forces = self.points.take(which).forces(both, with_areas=True)
        above = forces.excess.value > forces.errors.noise
        below = forces.excess.value < -forces.errors.noise
        changes = above[0] & below[1]
        is_done = changes | interval.is_final
        done = np.flatnonzero(is_done)
        solved = EnclosedRoots(
            points=self.points.take(which[done]),
            indices=self.indices[which[done]],
            forces=forces.take(done),
            certain=changes[done],
        )
        if done.size < which.size:
            self._look_beyond(interval, closer=below[0] & ~is_done, farther=above[1] & ~is_done)
        self.keep(np.delete(np.arange(self.indices.size), which[done]))
        return solved

    def _look_beyond(self, interval, closer, farther):
        """Go on next to the ``interval`` where the root is ``closer`` or ``farther``, otherwise in
        a wider one."""
        which, low, high, _ = interval
        self.widening[which[~(closer | farther)]] *= GROWTH
        self.high[which[closer]], self.low[which[farther]] = low[closer], high[farther]
        next_closer, next_farther = 2.0 * low - high, 2.0 * high - low
        self.separation[which[closer]] = np.fmax(next_closer, self.low[which])[closer]
        self.separation[which[farther]] = np.fmin(next_farther, self.high[which])[farther]
