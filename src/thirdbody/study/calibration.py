"""Finding the inputs that the paper does not print, as an inverse problem.

A *reading* here is one way to read the printed equations; it fixes some inputs and leaves others
unknown.  For each reading the unknowns are searched for values under which the paper's statements
hold.  ``config/calibration.yaml`` states the readings, the unknowns with their bounds and the
ranges usual in nature, the weights of the objective, and how long to search.

A search works on *positions*: the value of each unknown as a number between 0 and 1, its place
between its bounds on a linear or logarithmic scale.  All positions together are a point in the unit
cube.  ``thirdbody.study.search`` searches it and records every evaluation;
``thirdbody.study.posterior`` tells from these records which values explain the statements about
equally well.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.model.parameters import Parameters
from thirdbody.study.checks import MISSING_SCORE, judge
from thirdbody.study.claims import CALIBRATION, VALIDATION, Claim, referenced_conditions
from thirdbody.study.evidence import QUICK_EFFORT, SolvedEvidence

# The loss of a statement that fails badly is nearly flat: this slope keeps it worth improving.
SLOPE_OF_LOSS = 0.1


@dataclass(frozen=True)
class Unknown:
    """An input of the model that is to be found.

    Attributes
    ----------
    name : str
        Field of ``Parameters``.
    bounds : tuple of float
        Least and greatest value that is tried [unit of the input].
    usual : tuple of float
        Range that is usual in nature; values beyond it are penalised [unit of the input].
    logarithmic : bool
        Whether it is searched on a logarithmic scale.
    """

    name: str
    bounds: tuple[float, float]
    usual: tuple[float, float]
    logarithmic: bool

    def value(self, position: float) -> float:
        """Value of the input at a position.

        Parameters
        ----------
        position : float
            Place between the bounds [1], from 0 to 1.

        Returns
        -------
        float
            In the unit of the input.

        Examples
        --------
        >>> radius = Unknown("summit_radius", (1e-6, 1e-2), (1e-5, 1e-4), logarithmic=True)
        >>> round(radius.value(0.5), 12)
        0.0001
        """
        low, high = self.bounds
        if self.logarithmic:
            return float(low * (high / low) ** position)
        return float(low + (high - low) * position)

    def position(self, value: float) -> float:
        """Place of a value between the bounds [1]: the inverse of ``value``, kept from 0 to 1."""
        low, high = self.bounds
        if self.logarithmic:
            low, high, value = np.log(low), np.log(high), np.log(value)
        return float(np.clip((value - low) / (high - low), 0.0, 1.0))

    def penalty(self, value: float) -> float:
        """How unusual a value is.

        Parameters
        ----------
        value : float
            In the unit of the input.

        Returns
        -------
        float
            Square of the distance beyond the usual range [1], counted in decades if the scale is
            logarithmic, else in widths of that range; 0 within it.
        """
        low, high = self.usual
        if self.logarithmic:
            return max(0.0, np.log10(low / value), np.log10(value / high)) ** 2
        return (max(0.0, low - value, value - high) / (high - low)) ** 2


@dataclass(frozen=True)
class Reading:
    """One way to read the printed equations, with the inputs that it leaves to be found.

    ``Reading.of`` makes one from the configuration.

    Attributes
    ----------
    name : str
        Its key in ``config/calibration.yaml``.
    fixed : dict
        Inputs that the reading fixes, by name of the field of ``Parameters``, SI.
    unknowns : tuple of Unknown
        Inputs to be found; their order is that of the columns of positions.
    """

    name: str
    fixed: dict[str, Any]
    unknowns: tuple[Unknown, ...]

    @classmethod
    def of(cls, name: str, settings: Mapping[str, Any]) -> Reading:
        """Take a reading from the configuration.

        An unknown of every reading is none of this one if it fixes it.

        Parameters
        ----------
        name : str
            Which of the readings.
        settings : mapping
            Content of ``config/calibration.yaml``.

        Raises
        ------
        KeyError
            If there is no reading of this name.
        """
        entry = settings["readings"][name]
        names = (*settings["always"], *entry.get("unknowns", ()))
        free = [each for each in names if each not in entry["fixed"]]
        unknowns = (
            Unknown(
                each,
                tuple(settings["unknowns"][each]["bounds"]),
                tuple(settings["unknowns"][each]["usual"]),
                settings["unknowns"][each]["scale"] == "logarithmic",
            )
            for each in free
        )
        return cls(name, entry["fixed"], tuple(unknowns))

    def values(self, positions: ArrayLike) -> dict[str, float]:
        """Values of the unknowns at their positions.

        Parameters
        ----------
        positions : array_like, shape (unknowns,)
            From 0 to 1 [1].

        Returns
        -------
        dict
            Value of each unknown by its name, SI.
        """
        pairs = zip(self.unknowns, positions, strict=True)
        return {unknown.name: unknown.value(position) for unknown, position in pairs}


class Found(NamedTuple):
    """What one set of inputs gives.

    Attributes
    ----------
    objective : float
        What is minimised [1].
    ends : array, shape (claims, 2)
        How far each statement that is fitted is from holding, in tolerances [1]: the ``ends`` of its
        verdict, which change smoothly as inputs do.
    beside : array, shape (beside,)
        Scores, in tolerances, of the statements that are watched and not fitted [1].
    """

    objective: float
    ends: NDArray[np.float64] = np.empty((0, 2))
    beside: NDArray[np.float64] = np.empty(0)


@dataclass(frozen=True)
class Objective:
    """What a calibration minimises: losses of the statements, and penalties for unusual inputs.

    ``Objective.of`` makes one from all statements of the paper.

    Attributes
    ----------
    claims : tuple of Claim
        Statements that the inputs are fitted to.
    beside : tuple of Claim
        Statements that are judged as well and have no part in what is minimised.
    asked : dict
        Conditions that all these statements speak of, as ``referenced_conditions`` returns them.
    weights : array, shape (claims,)
        Weight of each of ``claims`` [1].
    newtons : tuple of float
        First and last normal load [N].
    base : Parameters
        Values of all inputs that neither a reading fixes nor a search varies.
    """

    claims: tuple[Claim, ...]
    beside: tuple[Claim, ...]
    asked: dict[str, set]
    weights: NDArray[np.float64]
    newtons: tuple[float, float]
    base: Parameters

    @classmethod
    def of(
        cls,
        claims: Sequence[Claim],
        settings: Mapping[str, Any],
        base: Parameters,
        watched: bool = False,
    ) -> Objective:
        """Make the objective over the statements whose role is ``calibration``.

        Those that stand aside for others stay out.  The weight of a statement is that of its kind,
        shared among the statements of its cluster.

        Parameters
        ----------
        claims : sequence of Claim
            All statements of the paper.
        settings : mapping
            Content of ``config/calibration.yaml``.
        base : Parameters
            Values of all inputs that are neither fixed by a reading nor searched.
        watched : bool
            Whether the statements of the role ``validation`` are judged beside.
        """
        fitted = tuple(c for c in claims if c.role == CALIBRATION and not c.aside)
        sizes = Counter(claim.counted_as for claim in fitted)
        weights = [
            settings["weights"].get(claim.kind, 1.0) / sizes[claim.counted_as] for claim in fitted
        ]
        beside = tuple(c for c in claims if watched and c.role == VALIDATION)
        asked = referenced_conditions(fitted + beside)
        return cls(fitted, beside, asked, np.array(weights), tuple(settings["newtons"]), base)

    def found(self, reading: Reading, positions: ArrayLike) -> Found:
        """How far the model is from what the paper says, for one set of inputs.

        Parameters
        ----------
        reading : Reading
            Says what the positions stand for.
        positions : array_like, shape (unknowns,)
            From 0 to 1 [1].

        Returns
        -------
        Found
            Inputs that no surface can have give every statement its greatest score.
        """
        try:
            evidence = SolvedEvidence(
                replace(self.base, **reading.fixed, **reading.values(positions)),
                self.asked,
                self.newtons,
                QUICK_EFFORT,
            )
            fitted = np.array([judge(claim, evidence).ends for claim in self.claims])
            beside = np.array([judge(claim, evidence).score for claim in self.beside])
        except ValueError:  # no surface has these inputs
            fitted = np.full((len(self.claims), 2), MISSING_SCORE)
            beside = np.full(len(self.beside), MISSING_SCORE)
        return Found(self.value(reading, positions, fitted), fitted, beside)

    def value(self, reading: Reading, positions: ArrayLike, ends: ArrayLike) -> float:
        """What is minimised, where the scores of the statements are known or guessed.

        Parameters
        ----------
        reading : Reading
            Says what the positions stand for.
        positions : array_like, shape (unknowns,)
            From 0 to 1 [1].
        ends : array_like, shape (claims, 2)
            In tolerances [1], as ``Found`` has them.

        Returns
        -------
        float
            Penalties of the unknowns and weighted losses of the statements, added up [1].
        """
        values = reading.values(positions)
        penalties = [unknown.penalty(values[unknown.name]) for unknown in reading.unknowns]
        return float(np.sum(penalties) + np.sum(self.losses(ends)))

    def losses(self, ends: ArrayLike) -> NDArray[np.float64]:
        """Weighted loss of each statement [1], shape (claims,), from ``ends`` as ``Found`` has them."""
        return self.weights * loss(np.abs(ends).max(axis=1))


def loss(score: ArrayLike) -> ArrayLike:
    """Loss of a statement.

    It is small wherever the statement holds, steepest where it ceases to, and grows slowly far
    off, so that a statement that cannot hold does not drown the others.

    Parameters
    ----------
    score : array_like
        Distances from what is published, in tolerances [1], as ``thirdbody.study.checks.judge``
        returns them.

    Returns
    -------
    array_like
        s^4/(1 + s^4) + 0.1 s for each score s [1].
    """
    return score**4 / (1.0 + score**4) + SLOPE_OF_LOSS * score


def acceptable(rows: NDArray[np.float64], acceptance: float) -> NDArray[np.float64]:
    """Evaluations that are about as good as the best.

    Parameters
    ----------
    rows : array, shape (evaluations, unknowns + 1)
        As ``search`` returns them.
    acceptance : float
        How far the objective may be above the least one [1].

    Returns
    -------
    array, shape (accepted, unknowns + 1)
        The rows within ``acceptance`` of the best, in the order of their objective, equal rows
        once.
    """
    ordered = np.unique(rows, axis=0)
    ordered = ordered[np.argsort(ordered[:, -1], kind="stable")]
    return ordered[ordered[:, -1] <= ordered[0, -1] + acceptance]


def spread_out(rows: NDArray[np.float64], count: int) -> NDArray[np.float64]:
    """Choose rows that are far apart from each other.

    Parameters
    ----------
    rows : array, shape (n, unknowns + 1)
        Positions and objective; the first row is chosen first.
    count : int
        How many to choose.

    Returns
    -------
    array, shape (min(count, n), unknowns + 1)
        The first row, and each next the one whose positions are farthest from all before.
    """
    chosen = [0]
    distance = np.full(len(rows), np.inf)
    while len(chosen) < min(count, len(rows)):
        gap = np.linalg.norm(rows[:, :-1] - rows[chosen[-1], :-1], axis=1)
        distance = np.minimum(distance, gap)
        chosen.append(int(np.argmax(distance)))
    return rows[chosen]
