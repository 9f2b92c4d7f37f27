"""What it costs the other statements that one of them holds: fronts of what searches have seen.

A front belongs to one of the chief statements of the paper.  Each of its points is a set of inputs
that was evaluated, seen as two numbers: how far the model is from that statement, and the objective
without it.  No other evaluated set is better in both.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from thirdbody.study.calibration import Found, Objective, loss

POINTS = 16  # of a front in a file of calibrated inputs
# Scores among which that of a loss is interpolated.
SCORES = np.concatenate([np.linspace(0.0, 2.0, 2001), np.geomspace(2.001, 100.0, 2000)])
LOSSES = loss(SCORES)
Front = NDArray[np.float64]  # shape (points, 2), the first column increasing, the second falling


class Witness:
    """Sees every evaluation of a search and keeps the front of each chief statement.

    Parameters
    ----------
    objective : Objective
        What is minimised.
    headline : sequence of str
        Ids of the chief statements that are fitted; those that are not are left out.

    Attributes
    ----------
    fronts : dict
        Of each of these, and of each statement that the objective judges beside, by its id an array of
        shape (points, 2): the score, in tolerances up to 1 and logarithmic beyond, and the objective
        without the statement and those that repeat it.
    """

    def __init__(self, objective: Objective, headline: Sequence[str]):
        names = {claim.id: claim.counted_as for claim in objective.claims}
        self._members = {
            name: np.array([claim.counted_as == names[name] for claim in objective.claims])
            for name in headline
            if name in names
        }
        self._beside = [claim.id for claim in objective.beside]
        self._objective = objective
        names = (*self._members, *self._beside)
        self.fronts: dict[str, Front] = {name: np.empty((0, 2)) for name in names}

    def see(self, found: Found) -> None:
        """Take note of one evaluation, as ``Objective.found`` returns it."""
        losses, weights = self._objective.losses(found.ends), self._objective.weights
        for name, members in self._members.items():
            own = losses[members].sum()
            score = np.interp(own / weights[members].sum(), LOSSES, SCORES)
            self._add(name, score, found.objective - own)
        for name, score in zip(self._beside, found.beside, strict=True):
            self._add(name, score, found.objective)

    def _add(self, name, score, others):
        """A point of the front of a statement, unless one that is there is better in both."""
        front, point = self.fronts[name], np.array([score, others])
        if not (front <= point).all(axis=1).any():
            self.fronts[name] = np.vstack([front[(front < point).any(axis=1)], point])


def merged(fronts: Iterable[Front]) -> Front:
    """The front of all points of several ones, thinned to ``POINTS``.

    Examples
    --------
    >>> merged([np.array([[0.5, 9.0], [2.0, 4.0]]), np.array([[1.0, 9.5], [1.5, 5.0]])]).tolist()
    [[0.5, 9.0], [1.5, 5.0], [2.0, 4.0]]
    """
    points = np.unique(np.concatenate(list(fronts)), axis=0)  # by score, then by the rest
    before = np.concatenate([[np.inf], np.minimum.accumulate(points[:-1, 1])])
    best = points[points[:, 1] < before]
    chosen = np.linspace(0, len(best) - 1, min(POINTS, len(best))).round().astype(int)
    return best[chosen]
