"""The unprinted inputs as an inverse problem: a search over what they may be, reading by reading.

``config/calibration.yaml`` states the unknowns, their bounds and what is usual, the objective and
the budget.  A search records every evaluation, so that what is acceptable, what is identified and
what is correlated can be told afterwards.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import differential_evolution, least_squares

from thirdbody.model.parameters import Parameters
from thirdbody.study.checks import MISSING_SCORE, judge
from thirdbody.study.claims import Claim, assign_roles, referenced_conditions
from thirdbody.study.evidence import QUICK_EFFORT, SolvedEvidence

SLOPE_OF_LOSS = 0.1  # keeps a statement that fails badly worth improving
LOCAL_POOL = 12  # of the best sets: local searches start from those farthest apart among them
DIFFERENCE_STEP = 4e-3  # of a position: well above the error of what is solved
EDGE = 1e-3
WALK_STEP = 0.15  # of the spread of the acceptable sets found so far


@dataclass(frozen=True)
class Unknown:
    """An input to be found: hard ``bounds``, the range ``usual`` in nature, and its scale."""

    name: str
    bounds: tuple[float, float]
    usual: tuple[float, float]
    logarithmic: bool

    def value(self, position: float) -> float:
        """The input at ``position`` in [0, 1] between its bounds."""
        low, high = self.bounds
        if self.logarithmic:
            return float(low * (high / low) ** position)
        return float(low + (high - low) * position)

    def position(self, value: float) -> float:
        """The inverse of ``value``, held between 0 and 1."""
        low, high = self.bounds
        if self.logarithmic:
            low, high, value = np.log(low), np.log(high), np.log(value)
        return float(np.clip((value - low) / (high - low), 0.0, 1.0))

    def penalty(self, value: float) -> float:
        """Squared distance beyond what is usual, in decades or widths of the usual range."""
        low, high = self.usual
        if self.logarithmic:
            return max(0.0, np.log10(low / value), np.log10(value / high)) ** 2
        return (max(0.0, low - value, value - high) / (high - low)) ** 2


@dataclass(frozen=True)
class Reading:
    """One way to read the printed equations: what it fixes, what it leaves unknown, a start."""

    name: str
    fixed: dict
    unknowns: tuple[Unknown, ...]
    start: dict

    @classmethod
    def of(cls, name: str, settings: dict) -> Reading:
        """The reading ``name`` of the mapping in ``config/calibration.yaml``."""
        entry = settings["readings"][name]
        names = (*settings["always"], *entry.get("unknowns", ()))
        unknowns = (
            Unknown(
                each,
                tuple(settings["unknowns"][each]["bounds"]),
                tuple(settings["unknowns"][each]["usual"]),
                settings["unknowns"][each]["scale"] == "logarithmic",
            )
            for each in names
        )
        return cls(name, entry["fixed"], tuple(unknowns), entry["start"])

    def values(self, positions) -> dict:
        """Inputs at ``positions`` in the unit cube."""
        pairs = zip(self.unknowns, positions, strict=True)
        return {unknown.name: unknown.value(position) for unknown, position in pairs}


@dataclass(frozen=True)
class Objective:
    """What a calibration minimises: misses of the statements and unusualness of the inputs."""

    claims: tuple[Claim, ...]
    asked: dict
    weights: dict
    newtons: tuple[float, float]
    base: Parameters

    @classmethod
    def of(cls, claims: Sequence[Claim], settings: dict, base: Parameters) -> Objective:
        """The objective over those of ``claims`` whose role is ``calibration``."""
        roles = assign_roles(claims)
        fitted = tuple(claim for claim in claims if roles[claim.id] == "calibration")
        asked = referenced_conditions(fitted)
        return cls(fitted, asked, settings["weights"], tuple(settings["newtons"]), base)

    def misses(self, reading: Reading, positions) -> np.ndarray:
        """Square roots of the terms of the objective at ``positions`` in the unit cube."""
        values = reading.values(positions)
        penalties = [unknown.penalty(values[unknown.name]) for unknown in reading.unknowns]
        try:
            evidence = SolvedEvidence(
                replace(self.base, **reading.fixed, **values),
                self.asked,
                self.newtons,
                QUICK_EFFORT,
            )
            scores = [judge(claim, evidence).score for claim in self.claims]
        except ValueError:  # no surface has these inputs
            scores = [MISSING_SCORE] * len(self.claims)
        weights = np.array([self.weights.get(claim.kind, 1.0) for claim in self.claims])
        return np.sqrt(np.concatenate([penalties, weights * loss(np.array(scores))]))


def loss(score):
    """Loss of one statement at its ``score`` in tolerances: 1/2 at the tolerance, about 1 far off."""
    return score**2 / (1.0 + score**2) + SLOPE_OF_LOSS * score


def search(reading: Reading, objective, budget: dict, seed: int, report=print) -> np.ndarray:
    """Every evaluation of a global, then local search and a walk over what is acceptable.

    ``objective.misses(reading, positions)`` is minimised in the sum of its squares; ``budget``
    limits the work; the same ``seed`` gives the same result.  Returns rows (positions in the unit
    cube ..., objective).
    """
    rows: list[np.ndarray] = []

    def recorded(positions):
        misses = objective.misses(reading, positions)
        rows.append(np.append(positions, np.sum(misses**2)))
        if len(rows) % 50 == 0:
            least = min(row[-1] for row in rows)
            report(f"{reading.name} seed {seed}: {len(rows)} evaluations, best {least:.3f}")
        return misses

    rng = np.random.default_rng(seed)
    _global_search(reading, recorded, budget, rng)
    for row in spread_out(acceptable(np.array(rows), np.inf)[:LOCAL_POOL], budget["starts"]):
        _local_search(recorded, row[:-1], budget["local"])
    _walk(recorded, np.array(rows), budget["walk"], rng)
    return np.array(rows)


def _global_search(reading, recorded, budget, rng) -> None:
    """Differential evolution from the reading's start, its surroundings and all of the cube."""
    start = np.array(
        [unknown.position(reading.start[unknown.name]) for unknown in reading.unknowns]
    )
    size = (budget["population"], start.size)
    near = start + rng.normal(scale=0.08, size=size)
    population = np.where(np.arange(size[0])[:, None] % 3 == 0, rng.uniform(size=size), near)
    population[0] = start
    differential_evolution(
        lambda positions: np.sum(recorded(positions) ** 2),
        [(0.0, 1.0)] * start.size,
        init=np.clip(population, 0.0, 1.0),
        maxiter=budget["generations"],
        mutation=(0.3, 0.9),
        recombination=0.8,
        tol=0.0,
        polish=False,
        rng=rng,
    )


def _local_search(recorded, start, steps) -> None:
    """Least squares on the misses, at most ``steps`` Gauss-Newton steps from ``start``."""
    least_squares(
        recorded,
        np.clip(start, EDGE, 1.0 - EDGE),
        bounds=(0.0, 1.0),
        diff_step=DIFFERENCE_STEP,
        x_scale=0.1,
        max_nfev=steps,
        xtol=1e-4,
        ftol=1e-4,
    )


def _walk(recorded, rows, evaluations, rng) -> None:
    """Metropolis walk from the best set: the unit of the objective is its temperature."""
    best = rows[np.argsort(rows[:, -1], kind="stable")[: 4 * rows.shape[1]]]
    steps = WALK_STEP * np.maximum(best[:, :-1].std(axis=0), 1e-3)
    position, value = best[0, :-1], best[0, -1]
    for _ in range(evaluations):
        trial = np.clip(position + steps * rng.normal(size=steps.size), 0.0, 1.0)
        found = np.sum(recorded(trial) ** 2)
        if np.log(rng.uniform()) < value - found:
            position, value = trial, found


def acceptable(rows: np.ndarray, acceptance: float) -> np.ndarray:
    """Rows whose objective is within ``acceptance`` of the best, best first, each once."""
    ordered = np.unique(rows, axis=0)
    ordered = ordered[np.argsort(ordered[:, -1], kind="stable")]
    return ordered[ordered[:, -1] <= ordered[0, -1] + acceptance]


def spread_out(rows: np.ndarray, count: int) -> np.ndarray:
    """The best row and others of ``rows``, ``count`` in all, each farthest from those before."""
    chosen = [0]
    distance = np.full(len(rows), np.inf)
    while len(chosen) < min(count, len(rows)):
        gap = np.linalg.norm(rows[:, :-1] - rows[chosen[-1], :-1], axis=1)
        distance = np.minimum(distance, gap)
        chosen.append(int(np.argmax(distance)))
    return rows[chosen]
