"""Results of the searches for the unprinted inputs, as the content of calibrated files."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chenhorng.calibration.calibration import Interpretation, make_folds
from chenhorng.calibration.search import best_of
from chenhorng.claims.claim import Claim

DIGITS = 6  # significant digits of numbers in the file


def summary(
    interpretation: Interpretation,
    searches: Sequence[NDArray],
    folds: Sequence[NDArray],
    claims: Sequence[Claim],
    settings: Mapping[str, Any],
) -> dict[str, Any]:
    """The content of the calibrated file of an interpretation, SI.

    ``searches`` have rows of positions and objectives, shape (rows, unknowns + 1), for each seed;
    ``folds`` have them for each fold.  ``claims`` are all statements.
    """
    best = best_of(np.concatenate(searches))
    inputs = inputs_of(interpretation, best)
    parts = make_folds(claims, settings["folds"])
    return {
        "interpretation": interpretation.name,
        "objective": rounded(best[-1]),
        "penalty": rounded(interpretation.penalty(inputs)),
        "objective_of_each_seed": [rounded(search[:, -1].min()) for search in searches],
        "evaluations": sum(map(len, searches)),
        "inputs": {**interpretation.fixed, **inputs},
        "folds": [
            {
                "figures": list(figures),
                "left_out": [claim.id for claim in fold.left_out],
                "objective": rounded(row[-1]),
                "inputs": {**interpretation.fixed, **inputs_of(interpretation, row)},
            }
            for figures, fold, row in zip(
                settings["folds"], parts, map(best_of, folds), strict=True
            )
        ],
    }


def fold_members(
    interpretation: Interpretation,
    samples: Sequence[NDArray],
    figures: Sequence[Sequence[int]],
    count: int,
) -> list[dict[str, Any]]:
    """The members of an ensemble: ``count`` sets of inputs, SI, from the sample of each fold, with
    the ``figures`` that the set has not seen.

    A sample has rows of positions and objectives, shape (rows, unknowns + 1), in the order in which
    it was drawn.  Sets are taken at even distances, which should not all be of one walker.
    """
    return [
        {
            "unseen": list(unseen),
            "inputs": {**interpretation.fixed, **inputs_of(interpretation, row)},
        }
        for unseen, rows in zip(figures, samples, strict=True)
        for row in rows[np.linspace(0, len(rows) - 1, count).round().astype(int)]
    ]


def inputs_of(interpretation: Interpretation, row: NDArray) -> dict[str, float]:
    """The unknowns of a row of positions and objective, SI, rounded to ``DIGITS``."""
    return {name: rounded(value) for name, value in interpretation.values(row[:-1]).items()}


def rounded(value: float) -> float:
    """``value`` with ``DIGITS`` significant digits."""
    return float(f"{value:.{DIGITS}g}")
