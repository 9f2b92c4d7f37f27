"""Finding the inputs that the paper does not print, as an inverse problem.

An *interpretation* of the printed equations fixes some inputs and leaves others unknown.  The unknowns are
sought for which the paper's statements hold, as ``config/calibration.yaml`` states it.  A search works on
*positions*: the value of each unknown as its place between its bounds, from 0 to 1, on a linear or
logarithmic scale.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.data.files import atomic_write
from thirdbody.study.checks import MISSING_SCORE, Judge
from thirdbody.study.claims import Claim
from thirdbody.study.evidence import QUICK_EFFORT

# The loss of a statement that fails badly is nearly flat: this slope keeps it worth improving.
SLOPE_OF_LOSS = 0.1


@dataclass(frozen=True)
class Unknown:
    """An input of the model that is to be found, a field of ``Parameters``: values between ``bounds`` are tried,
    those beyond the ``usual`` range are penalised [unit of the input]."""

    name: str
    bounds: tuple[float, float]
    usual: tuple[float, float]
    logarithmic: bool

    def value(self, position: float) -> float:
        """Value of the input at a position between 0 and 1."""
        low, high = self.bounds
        if self.logarithmic:
            return float(low * (high / low) ** position)
        return float(low + (high - low) * position)

    def position(self, value: float) -> float:
        """Position of a value, the inverse of ``value``, clipped to 0 and 1."""
        low, high = self.bounds
        if self.logarithmic:
            low, high, value = np.log(low), np.log(high), np.log(value)
        return float(np.clip((value - low) / (high - low), 0.0, 1.0))

    def penalty(self, value: float) -> float:
        """Square of the distance of a value beyond the usual range, 0 within it: in decades if the scale is
        logarithmic, else in widths of the range [1]."""
        low, high = self.usual
        if self.logarithmic:
            return max(0.0, np.log10(low / value), np.log10(value / high)) ** 2
        return (max(0.0, low - value, value - high) / (high - low)) ** 2


@dataclass(frozen=True)
class Interpretation:
    """One interpretation of the printed equations, by its name in ``config/calibration.yaml``: inputs that it
    fixes, SI, and those to be found, in the order of the positions."""

    name: str
    fixed: dict[str, Any]
    unknowns: tuple[Unknown, ...]

    @classmethod
    def of(cls, name: str, settings: Mapping[str, Any]) -> Interpretation:
        """Take an interpretation from the content of ``config/calibration.yaml``."""
        entry = settings["interpretations"][name]
        unknowns = []
        for each in (*settings["always"], *entry.get("unknowns", ())):
            if each not in entry["fixed"]:
                given = settings["unknowns"][each]
                ends = tuple(given["bounds"]), tuple(given["usual"])
                unknowns.append(Unknown(each, *ends, given["scale"] == "logarithmic"))
        return cls(name, entry["fixed"], tuple(unknowns))

    def values(self, positions: ArrayLike) -> dict[str, float]:
        """Values of the unknowns at ``positions``, shape (unknowns,), by name, SI."""
        pairs = zip(self.unknowns, positions, strict=True)
        return {unknown.name: unknown.value(position) for unknown, position in pairs}

    def positions(self, inputs: Mapping[str, Any]) -> NDArray[np.float64]:
        """Positions of the unknowns, shape (unknowns,), from their values by name, SI."""
        return np.array([unknown.position(inputs[unknown.name]) for unknown in self.unknowns])

    def penalty(self, inputs: Mapping[str, Any]) -> float:
        """How unusual the unknowns are [1], from their values by name, SI."""
        return float(sum(unknown.penalty(inputs[unknown.name]) for unknown in self.unknowns))


@dataclass(frozen=True)
class Objective:
    """What a calibration minimises: losses of the statements, each with its weight [1], and penalties for
    unusual inputs."""

    judge: Judge
    weights: NDArray[np.float64]

    @classmethod
    def of(
        cls, claims: Sequence[Claim], settings: Mapping[str, Any], base: Mapping[str, Any]
    ) -> Objective:
        """Make the objective over ``claims``, without those that stand aside.

        The weight of a statement is that of its kind, shared among the statements of its cluster.
        ``settings`` is the content of ``config/calibration.yaml``; ``base`` has the inputs that are neither
        fixed nor searched.
        """
        fitted = [claim for claim in claims if not claim.aside]
        sizes = Counter(claim.counted_as for claim in fitted)
        weights = [
            settings["weights"].get(claim.kind, 1.0) / sizes[claim.counted_as] for claim in fitted
        ]
        return cls(Judge(fitted, base, settings["newtons"]), np.array(weights))

    @property
    def claims(self) -> tuple[Claim, ...]:
        """Statements that the inputs are fitted to."""
        return self.judge.claims

    def repeating(self, name: str) -> NDArray[np.bool_]:
        """Which of ``claims`` is the one with the id ``name``, or repeats it."""
        clusters = [claim.counted_as for claim in self.claims]
        place = [claim.id for claim in self.claims].index(name)
        return np.array(clusters) == clusters[place]

    def scores(
        self, interpretation: Interpretation, inputs: Mapping[str, Any]
    ) -> NDArray[np.float64]:
        """Score of each of ``claims`` in tolerances [1]; the greatest if no surface has these inputs."""
        try:
            verdicts = self.judge({**interpretation.fixed, **inputs}, QUICK_EFFORT)
        except ValueError:
            return np.full(len(self.claims), MISSING_SCORE)
        return np.array([verdict.score for verdict in verdicts.values()])

    def value(self, penalty: float, scores: ArrayLike) -> float:
        """What is minimised [1]: the penalty, and the weighted losses of the scores added up."""
        return float(penalty + np.sum(self.weights * loss(np.asarray(scores))))

    def __call__(self, interpretation: Interpretation, positions: ArrayLike) -> float:
        """What is minimised [1], at the ``positions`` of the unknowns."""
        inputs = interpretation.values(positions)
        return self.value(interpretation.penalty(inputs), self.scores(interpretation, inputs))


def loss(score: ArrayLike) -> ArrayLike:
    """Loss of a statement, s^4/(1 + s^4) + 0.1 s for a score s in tolerances [1]: small where it holds, steepest where
    it ceases to, and nearly flat far off, so that one that cannot hold does not outweigh the others."""
    return score**4 / (1.0 + score**4) + SLOPE_OF_LOSS * score


class Fold(NamedTuple):
    """One part of the cross-validation: the statements of some figures are left out of the search and
    ``judged`` by its result; those ``fitted`` neither refer to these figures nor repeat or contradict a judged
    one."""

    judged: tuple[Claim, ...]
    fitted: tuple[Claim, ...]


def make_folds(claims: Sequence[Claim], figures: Sequence[Sequence[int]]) -> list[Fold]:
    """Divide the statements into folds: each is judged once, in the fold whose ``figures`` have its first
    figure, by inputs that never saw it."""
    folds = []
    for part in map(set, figures):
        judged = tuple(claim for claim in claims if min(claim.all_figures) in part)
        seen = {claim.counted_as for claim in judged}
        seen |= {other for claim in judged for other in claim.contradicts}
        fitted = tuple(
            claim
            for claim in claims
            if not (claim.all_figures & part or {claim.id, claim.counted_as} & seen)
        )
        folds.append(Fold(judged, fitted))
    return folds


def write_rows(path: Path, rows: NDArray[np.float64]) -> None:
    """Write positions and objectives, shape (rows, unknowns + 1), with all their digits."""
    with atomic_write(path) as part:
        np.savetxt(part, rows, fmt="%.17g", delimiter=",")


def read_rows(path: Path) -> NDArray[np.float64]:
    """What ``write_rows`` wrote."""
    return np.loadtxt(path, delimiter=",", ndmin=2)
