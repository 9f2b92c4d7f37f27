"""Calibration of the unprinted inputs as an inverse problem.

An *interpretation* of the printed equations fixes some inputs and leaves the others unknown;
``config/calibration.yaml`` defines the interpretations.  The search works on *positions*.  The
position of an unknown is its value, scaled from its bounds to 0 to 1, linearly or logarithmically.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chenhorng.claims.claim import MISSING_SCORE, Claim
from chenhorng.claims.evidence import QUICK_EFFORT
from chenhorng.claims.judge import Judge

# The loss of a statement that fails badly is nearly flat.  This slope still rewards improvement.
SLOPE_OF_LOSS = 0.1


@dataclass(frozen=True)
class Unknown:
    """An input, searched between its ``bounds`` and penalised outside its ``usual`` range."""

    name: str
    bounds: tuple[float, float]
    usual: tuple[float, float]
    logarithmic: bool

    def value(self, position: float) -> float:
        """Value of the input at a ``position`` between 0 and 1."""
        low, high = self.bounds
        if self.logarithmic:
            return float(low * (high / low) ** position)
        return float(low + (high - low) * position)

    def position(self, value: float) -> float:
        """Position of a ``value``, clipped to 0 and 1; the inverse of the method ``value``."""
        low, high = self.bounds
        if self.logarithmic:
            low, high, value = np.log(low), np.log(high), np.log(value)
        return float(np.clip((value - low) / (high - low), 0.0, 1.0))

    def penalty(self, value: float) -> float:
        """Squared distance [1] of a ``value`` from the usual range, in decades or in widths of the
        range.
        """
        low, high = self.usual
        if self.logarithmic:
            return max(0.0, np.log10(low / value), np.log10(value / high)) ** 2
        return (max(0.0, low - value, value - high) / (high - low)) ** 2


@dataclass(frozen=True)
class Interpretation:
    """An interpretation of the printed equations: its fixed inputs, SI, and its unknowns in the
    order of the positions.
    """

    name: str
    fixed: dict[str, Any]
    unknowns: tuple[Unknown, ...]

    @classmethod
    def of(cls, name: str, settings: Mapping[str, Any]) -> Interpretation:
        """The interpretation of this name in the content of ``config/calibration.yaml``."""
        entry = settings["interpretations"][name]
        unknowns = []
        for unknown in (*settings["always"], *entry.get("unknowns", ())):
            if unknown not in entry["fixed"]:
                definition = settings["unknowns"][unknown]
                ends = tuple(definition["bounds"]), tuple(definition["usual"])
                unknowns.append(Unknown(unknown, *ends, definition["scale"] == "logarithmic"))
        return cls(name, entry["fixed"], tuple(unknowns))

    def values(self, positions: Iterable[float]) -> dict[str, float]:
        """The values of the unknowns at ``positions``, shape (unknowns,), by name, SI."""
        pairs = zip(self.unknowns, positions, strict=True)
        inputs = {unknown.name: unknown.value(position) for unknown, position in pairs}
        return self._sheared(inputs, -1.0)

    def positions(self, inputs: Mapping[str, Any]) -> NDArray:
        """Positions of the unknowns, shape (unknowns,), from their values by name, SI."""
        sheared = self._sheared(inputs, 1.0)
        return np.array([unknown.position(sheared[unknown.name]) for unknown in self.unknowns])

    def _sheared(self, inputs: Mapping[str, Any], sign: float) -> dict[str, Any]:
        """The ``inputs`` with X_max over the truncation in the place of the spread, or back.

        The statements determine the largest size, so the mean moves along their valley if X_max
        stays.
        """
        known = {**self.fixed, **inputs}
        if "spread_ratio" not in inputs or "truncation" not in known:
            return dict(inputs)
        shift = known.get("mean_ratio", 0.0) / known["truncation"]
        return {**inputs, "spread_ratio": inputs["spread_ratio"] + sign * shift}

    def penalty(self, inputs: Mapping[str, Any]) -> float:
        """How unusual the unknowns are [1], from their values by name, SI."""
        return float(sum(unknown.penalty(inputs[unknown.name]) for unknown in self.unknowns))


@dataclass(frozen=True)
class Objective:
    """The objective of a calibration [1]: the sum of weighted losses of statements and of penalties
    for unusual inputs.
    """

    judge: Judge
    weights: NDArray

    @classmethod
    def of(
        cls, claims: Sequence[Claim], settings: Mapping[str, Any], base: Mapping[str, Any]
    ) -> Objective:
        """The objective over the ``claims`` that are neither set aside nor impossible.  Those of a
        cluster share the weight of their kind.
        ``base`` has the inputs that no interpretation sets.
        """
        fitted = [claim for claim in claims if not (claim.aside or claim.impossible)]
        sizes = Counter(claim.counted_as for claim in fitted)
        weights = [
            settings["weights"].get(claim.kind, 1.0) / sizes[claim.counted_as] for claim in fitted
        ]
        return cls(Judge(fitted, base, settings["newtons"]), np.array(weights))

    @classmethod
    def without(
        cls,
        fold: int | None,
        claims: Sequence[Claim],
        settings: Mapping[str, Any],
        base: Mapping[str, Any],
    ) -> Objective:
        """The objective over the ``claims`` that a search without the ``fold`` may see, by its
        number, or over all if it is None."""
        if fold is not None:
            claims = make_folds(claims, settings["folds"])[fold].fitted
        return cls.of(claims, settings, base)

    @property
    def claims(self) -> Sequence[Claim]:
        """The statements to which the inputs are fitted."""
        return self.judge.claims

    def scores(self, interpretation: Interpretation, inputs: Mapping[str, Any]) -> NDArray:
        """The score of each of ``claims`` in tolerances [1]; the largest score if no surface has
        these inputs.
        """
        try:
            verdicts = self.judge({**interpretation.fixed, **inputs}, QUICK_EFFORT)
        except ValueError:
            return np.full(len(self.claims), MISSING_SCORE)
        return np.array([verdict.score for verdict in verdicts.values()])

    def losses(self, scores: ArrayLike, claims: Sequence[Claim]) -> NDArray:
        """The weighted losses [1] of some ``claims`` with these ``scores``."""
        weights = dict(zip((claim.id for claim in self.claims), self.weights, strict=True))
        return np.array([weights[claim.id] for claim in claims]) * loss(np.asarray(scores))

    def value(self, penalty: float, scores: ArrayLike) -> float:
        """The objective [1]: the ``penalty`` plus the weighted losses of the ``scores``."""
        return float(penalty + np.sum(self.weights * loss(np.asarray(scores))))

    def take(self, every: Objective, scores: NDArray) -> NDArray:
        """The columns of ``scores`` that belong to ``claims``; ``scores`` has the shape (...,
        statements of ``every``)."""
        ids = {claim.id for claim in self.claims}
        return scores[..., [claim.id in ids for claim in every.claims]]

    def __call__(self, interpretation: Interpretation, positions: Iterable[float]) -> float:
        """The objective [1] at the ``positions`` of the unknowns."""
        inputs = interpretation.values(positions)
        return self.value(interpretation.penalty(inputs), self.scores(interpretation, inputs))


def loss(score: NDArray) -> NDArray:
    """The loss s^4/(1 + s^4) + 0.1 s of a statement with the score s [1].

    The loss is steepest at the tolerance.  Far away it is nearly flat, so that a statement that
    cannot hold does not outweigh the others.
    """
    return score**4 / (1.0 + score**4) + SLOPE_OF_LOSS * score


class Fold(NamedTuple):
    """A fold of the cross-validation.

    The statements ``left_out`` are those of some figures.  They are judged with the result of a
    search over the statements ``fitted``, which neither refer to these figures nor repeat or
    contradict a statement left out.
    """

    left_out: tuple[Claim, ...]
    fitted: tuple[Claim, ...]


def make_folds(claims: Sequence[Claim], figures: Sequence[Sequence[int]]) -> list[Fold]:
    """Divide the statements into folds by ``figures``; each statement is left out once, in the fold
    of its first figure."""
    folds = []
    for figures_of_fold in map(set, figures):
        left_out = tuple(claim for claim in claims if min(claim.all_figures) in figures_of_fold)
        related = {claim.counted_as for claim in left_out}
        related |= {other for claim in left_out for other in claim.contradicts}
        fitted = tuple(
            claim
            for claim in claims
            if not (claim.all_figures & figures_of_fold or {claim.id, claim.counted_as} & related)
        )
        folds.append(Fold(left_out=left_out, fitted=fitted))
    return folds


def write_rows(path: Path, rows: NDArray) -> None:
    """Write ``rows`` of positions and objectives, shape (rows, unknowns + 1), with all digits."""
    np.savetxt(path, rows, fmt="%.17g", delimiter=",")


def read_rows(path: Path) -> NDArray:
    """Read the rows in a file that ``write_rows`` wrote."""
    return np.loadtxt(path, delimiter=",", ndmin=2)
