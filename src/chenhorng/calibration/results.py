"""Results of the searches for the unprinted inputs, as the content of calibrated files."""

from collections.abc import Mapping, Sequence
from itertools import combinations
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from chenhorng.calibration.calibration import Interpretation, make_folds
from chenhorng.claims.claim import Claim

DIGITS = 6  # significant digits of numbers in the file
IDENTIFIED = 0.25  # part of its bounds that an identified input may span with acceptable values
NOTABLE_CORRELATION = 0.6  # smaller coefficients are left out
QUANTILES = 0.05, 0.5, 0.95  # of the sample of each seed
PROFILE_BINS = 12  # equal parts of an input's bounds


def summary(
    interpretation: Interpretation,
    searches: Sequence[NDArray],
    samples: Sequence[NDArray],
    folds: Sequence[NDArray],
    claims: Sequence[Claim],
    settings: Mapping[str, Any],
) -> dict[str, Any]:
    """The content of the calibrated file of an interpretation, SI.

    ``searches`` and ``samples`` have rows of positions and objectives, shape (rows, unknowns + 1),
    for each seed; ``folds`` has them for each fold.  Only interpretations on the shortlist have
    samples and folds.  ``claims`` are all statements.
    """
    rows = np.concatenate([*searches, *samples])
    good = acceptable(rows, settings["acceptance"])
    pooled = np.concatenate(samples) if samples else good[:0]
    drawn = np.linspace(0, len(pooled) - 1, settings["ensemble"] - 1 if samples else 0)
    inputs = inputs_of(interpretation, good[0])
    members = [inputs_of(interpretation, row) for row in pooled[drawn.round().astype(int)]]
    best = [fold[fold[:, -1].argmin()] for fold in folds]
    figures_of_folds = settings["folds"] if folds else ()
    parts = make_folds(claims, figures_of_folds)
    return {
        "interpretation": interpretation.name,
        "objective": rounded(good[0, -1]),
        "penalty": rounded(interpretation.penalty(inputs)),
        "objective_of_each_seed": [rounded(search[:, -1].min()) for search in searches],
        "evaluations": sum(map(len, searches)),
        "acceptable": len(good),
        "inputs": {**interpretation.fixed, **inputs},
        "folds": [
            {
                "figures": list(figures),
                "left_out": [claim.id for claim in fold.left_out],
                "objective": rounded(row[-1]),
                "inputs": {**interpretation.fixed, **inputs_of(interpretation, row)},
            }
            for figures, fold, row in zip(figures_of_folds, parts, best, strict=True)
        ],
        "ensemble": [inputs, *members],
        "ensemble_interpretations": [interpretation.name] * (1 + len(members)),
        "identification": _identification(interpretation, rows, good, samples),
        "correlations": _correlations(interpretation, pooled),
    }


def acceptable(rows: NDArray, acceptance: float) -> NDArray:
    """Unique rows with an objective up to ``acceptance`` above the least objective, best first."""
    ordered = np.unique(rows, axis=0)
    ordered = ordered[np.argsort(ordered[:, -1], kind="stable")]
    return ordered[ordered[:, -1] <= ordered[0, -1] + acceptance]


def shortlist(least: Mapping[str, float], within: float, most: int) -> list[str]:
    """The names of the ``most`` best interpretations ``within`` a distance from the best, from
    their ``least`` objectives; best first."""
    ranking = sorted(least, key=least.__getitem__)
    return [name for name in ranking if least[name] <= least[ranking[0]] + within][:most]


def inputs_of(interpretation: Interpretation, row: NDArray) -> dict[str, float]:
    """The unknowns of a row of positions and objective, SI, rounded to ``DIGITS``."""
    return {name: rounded(value) for name, value in interpretation.values(row[:-1]).items()}


def rounded(value: float) -> float:
    """``value`` with ``DIGITS`` significant digits."""
    return float(f"{value:.{DIGITS}g}")


def _identification(interpretation, rows, good, samples) -> dict:
    """For each unknown its acceptable range, its samples, and the least objectives along it."""
    result = {}
    for index, unknown in enumerate(interpretation.unknowns):
        first, last = good[:, index].min(), good[:, index].max()
        bins = np.minimum((rows[:, index] * PROFILE_BINS).astype(int), PROFILE_BINS - 1)
        quantiles = [
            [
                rounded(unknown.value(position))
                for position in np.quantile(sample[:, index], QUANTILES)
            ]
            for sample in samples
        ]
        least = [rows[bins == number, -1].min(initial=np.inf) for number in range(PROFILE_BINS)]
        result[unknown.name] = {
            "acceptable": [rounded(unknown.value(first)), rounded(unknown.value(last))],
            "identified": bool(last - first < IDENTIFIED),
            "median_of_each_seed": [median for _, median, _ in quantiles],
            "range_of_each_seed": [[low, high] for low, _, high in quantiles],
            "profile": [rounded(value) if np.isfinite(value) else None for value in least],
        }
    return result


def _correlations(interpretation, sample) -> list[dict]:
    """Pairs of unknowns that are correlated in the ``sample``, with their coefficients."""
    names = [unknown.name for unknown in interpretation.unknowns]
    coefficients = pd.DataFrame(sample[:, :-1], columns=names).corr()
    return [
        {"between": [one, other], "coefficient": float(f"{coefficients.loc[one, other]:.2f}")}
        for one, other in combinations(names, 2)
        if abs(coefficients.loc[one, other]) >= NOTABLE_CORRELATION
    ]
