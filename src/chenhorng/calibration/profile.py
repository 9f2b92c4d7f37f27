"""The profile of the objective: how far one quantity may move if all other unknowns follow.

A quantity that the statements determine has a narrow valley; one that others can make up for has a
wide valley (Raue et al. 2009, doi:10.1093/bioinformatics/btp358).
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple, Self

import numpy as np
from numpy.typing import NDArray
from scipy.stats import truncnorm

from chenhorng.calibration.calibration import Interpretation, Objective
from chenhorng.calibration.search import best_of, descend_twice, search

ITERATIONS = 6, 8  # of least squares at a level, in both rounds
FEWER = 0.7, 0.5, 0.35  # parts of the particles: sizes about a mean are larger
EVALUATIONS = {"evaluations": 15}  # of the evolution after them, per unknown
MEANS = 0.0, 0.6  # of the sizes over x_a [1], past both ends of what is acceptable


def mean_square(inputs: Mapping[str, Any]) -> float:
    """Mean square of the sizes over x_a^2 [1]: a normal distribution, truncated at 0 and X_max."""
    mean, spread = inputs["mean_ratio"], inputs["spread_ratio"]
    return truncnorm.moment(2, -mean / spread, inputs["truncation"], loc=mean, scale=spread)


def largest_size(inputs: Mapping[str, Any]) -> float:
    """X_max over x_a [1]."""
    return inputs["mean_ratio"] + inputs["truncation"] * inputs["spread_ratio"]


class Combination(NamedTuple):
    """A combination of inputs: its value, and the ``dependent`` input that gives it a level."""

    dependent: str
    value: Callable[[Mapping[str, Any]], float]
    dependent_at: Callable[[Mapping[str, Any], float], float]


COMBINATIONS = {
    "reach": Combination(
        dependent="elastic_depth_ratio",
        value=lambda inputs: largest_size(inputs) + inputs["elastic_depth_ratio"],
        dependent_at=lambda inputs, level: level - largest_size(inputs),
    ),
    "mean_square": Combination(
        dependent="participation",
        value=lambda inputs: inputs["participation"] * mean_square(inputs),
        dependent_at=lambda inputs, level: level / mean_square(inputs),
    ),
}


def quantity(name: str, inputs: Mapping[str, Any]) -> float:
    """An input, or a combination of inputs, by name."""
    return COMBINATIONS[name].value(inputs) if name in COMBINATIONS else inputs[name]


@dataclass(frozen=True)
class Held(Interpretation):
    """An interpretation in which the quantity ``along`` is held at a ``level``."""

    along: str
    level: float

    @classmethod
    def at(cls, interpretation: Interpretation, along: str, level: float) -> Self:
        """The ``interpretation`` with a quantity held."""
        dependent = COMBINATIONS[along].dependent if along in COMBINATIONS else along
        free = tuple(each for each in interpretation.unknowns if each.name != dependent)
        fixed = interpretation.fixed
        if along not in COMBINATIONS:
            fixed = {**fixed, along: level}
        return cls(interpretation.name, fixed, free, along=along, level=level)

    def values(self, positions: Any) -> dict[str, float]:
        inputs = super().values(positions)
        if self.along not in COMBINATIONS:
            return {**inputs, self.along: self.level}
        combination = COMBINATIONS[self.along]
        known = {**self.fixed, **inputs}
        return {**inputs, combination.dependent: combination.dependent_at(known, self.level)}


def profile(
    interpretation: Interpretation,
    objective: Objective,
    best: Mapping[str, Any],
    along: str,
    levels: Sequence[float],
) -> list[dict[str, float]]:
    """The least objective at each of the ``levels`` of a quantity, in their order, with the inputs
    that give it, SI.

    The levels are passed from the ``best`` inputs outwards on both sides.  A fit starts from that
    before, with as many particles or ``FEWER``, or from where the line through the last two fits
    leads, whichever is better.
    """
    own = quantity(along, {**interpretation.fixed, **best})
    upwards = sorted(level for level in levels if level >= own)
    downwards = sorted((level for level in levels if level < own), reverse=True)
    rows = {}
    for side in (upwards, downwards):
        passed = [(own, best)]
        for level in side:
            held = Held.at(interpretation, along, level)
            starts = [held.positions(inputs) for inputs in _with_fewer(passed[-1][1])]
            starts.append(_led_to(held, passed, level))
            start = min(starts, key=partial(objective, held))
            descended = descend_twice(held, objective, start, ITERATIONS)
            evolved = search(held, objective, best_of(descended)[:-1], EVALUATIONS, seed=1)
            row = best_of(np.vstack([descended, evolved]))
            inputs = held.values(row[:-1])
            passed.append((level, inputs))
            rows[level] = {"level": level, "objective": float(row[-1]), **inputs}
    return [rows[level] for level in sorted(rows)]


def along_the_means(
    interpretation: Interpretation, inputs: Mapping[str, Any], count: int
) -> NDArray:
    """Positions with ``MEANS`` of the sizes, shape (count, unknowns).

    X_max and p<x^2> stay as in the ``inputs``: the statements determine these, and not the mean.
    """
    known = {**interpretation.fixed, **inputs}
    rows = []
    for mean in np.linspace(*MEANS, count).tolist():
        spread = (largest_size(known) - mean) / known["truncation"]
        moved = {**known, "mean_ratio": mean, "spread_ratio": spread}
        moved["participation"] = quantity("mean_square", known) / mean_square(moved)
        rows.append(interpretation.positions(moved))
    return np.array(rows)


def _with_fewer(inputs: Mapping[str, Any]) -> list[dict[str, Any]]:
    """The ``inputs`` with as many particles that carry load, and with fewer."""
    if "participation" not in inputs:
        return [dict(inputs)]
    return [{**inputs, "participation": part * inputs["participation"]} for part in (1.0, *FEWER)]


def _led_to(held: Held, passed: Sequence[tuple[float, Mapping[str, Any]]], level: float) -> NDArray:
    """Positions on the line through the last two fits, at a level."""
    if len(passed) < 2 or passed[-1][0] == passed[-2][0]:
        return held.positions(passed[-1][1])
    (first, last), (before, now) = zip(*passed[-2:], strict=True)
    one, other = held.positions(before), held.positions(now)
    return np.clip(other + (level - last) / (last - first) * (other - one), 0.0, 1.0)
